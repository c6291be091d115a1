#include "programs/kerf/run/recorder.hpp"

#include <chrono>

namespace kerf::program {

RecorderThread::RecorderThread(Recorder& recorder, bool has_clock)
    : recorder_(&recorder), has_clock_(has_clock) {
  if (recorder.wants_ticks()) {
    thread_ = std::thread([this] { work(); });
  }
}

RecorderThread::~RecorderThread() {
  join();
}

void RecorderThread::push(const TickRecord& record) noexcept {
  while (thread_.joinable() && !ring_->push(record)) {
    if (has_clock_ || has_failed_.load(std::memory_order_relaxed)) {
      ++dropped_;
      return;
    }
    std::this_thread::yield();
  }
}

void RecorderThread::finish() {
  join();
  if (error_) {
    std::rethrow_exception(error_);
  }
}

void RecorderThread::join() noexcept {
  over_.store(true, std::memory_order_release);
  if (thread_.joinable()) {
    thread_.join();
  }
}

void RecorderThread::work() noexcept {
  try {
    while (true) {
      const bool last_round = over_.load(std::memory_order_acquire);
      ring_->consume_all([this](const TickRecord& record) { recorder_->add(record); });
      if (last_round) {
        return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  } catch (...) {
    error_ = std::current_exception();  // the motion goes on without
    has_failed_.store(true, std::memory_order_relaxed);
  }
}

}  // namespace kerf::program
