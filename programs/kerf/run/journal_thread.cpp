#include "programs/kerf/run/journal_thread.hpp"

#include <chrono>
#include <utility>

namespace kerf::program {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kLook = std::chrono::milliseconds(20);
constexpr auto kInMotion = std::chrono::seconds(1);
constexpr auto kBetweenRests = std::chrono::milliseconds(200);

JournalledPlace place_of(const ControllerStatus& status) {
  return {.block = status.block,
          .line = status.setpoint.line,
          .run_s = status.run_s,
          .position_mm = status.setpoint.position_mm,
          .state = std::string(name_of(status.state))};
}

}  // namespace

JournalThread::JournalThread(const Operator& by, JournalWriter& writer)
    : by_(&by), writer_(&writer), thread_([this] { work(); }) {}

JournalThread::~JournalThread() {
  over_.store(true);
  thread_.join();
}

void JournalThread::work() {
  Clock::time_point written = Clock::now();
  bool rested = true;
  bool has_changed = false;
  int error = 0;
  while (!over_.load() && error == 0) {
    if (const char* const what = by_->first_change(); what != nullptr && !has_changed) {
      has_changed = true;
      error = writer_->change(what);
    }
    const ControllerStatus status = by_->status();
    const bool rests = status.setpoint.v_mm_s == 0.0 && status.setpoint.limit == Constraint::rest;
    const auto since = Clock::now() - written;
    if (status.programs > 0 && status.block > 0 &&
        (since >= kInMotion || (rests && !rested && since >= kBetweenRests))) {
      error = writer_->place(place_of(status));
      written = Clock::now();
    }
    rested = rests;
    std::this_thread::sleep_for(kLook);
  }
}

}  // namespace kerf::program
