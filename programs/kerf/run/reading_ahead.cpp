#include "programs/kerf/run/reading_ahead.hpp"

#include <chrono>
#include <utility>

namespace kerf::program {

ReadingAhead::ReadingAhead(Kernel& kernel, TextFeed& text, Progress& progress)
    : kernel_(&kernel), text_(&text), progress_(&progress), thread_([this] { work(); }) {}

ReadingAhead::~ReadingAhead() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wanted_change_.notify_one();
  thread_.join();
}

bool ReadingAhead::plan() {
  while (true) {
    const bool wants_text = kernel_->plan();
    progress_->set_planned(kernel_->totals().path_length_mm);
    if (!wants_text) {
      return false;
    }
    if (!wait()) {
      return error_.has_value();
    }
  }
}

tl::expected<TextPiece, std::string> ReadingAhead::read() {
  return tl::unexpected(*error_);
}

bool ReadingAhead::wait() {
  std::unique_lock lock(mutex_);
  is_wanted_ = true;
  wanted_change_.notify_one();
  read_change_.wait(lock, [this] { return is_read_ || has_ended_; });
  if (exception_) {
    std::rethrow_exception(exception_);
  }
  return std::exchange(is_read_, false);
}

void ReadingAhead::work() noexcept {
  std::exception_ptr exception;
  try {
    while (read_on()) {
    }
  } catch (...) {
    exception = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  exception_ = exception;
  has_ended_ = true;
  read_change_.notify_one();
}

bool ReadingAhead::read_on() {
  switch (kernel_->read()) {
    case ReadStatus::ended:
      return false;
    case ReadStatus::wants_text:
      return feed_piece();
    case ReadStatus::far_enough:
      pause();
      break;
    case ReadStatus::read: {
      const std::lock_guard lock(mutex_);
      is_read_ = true;
      read_change_.notify_one();
      break;
    }
  }
  const std::lock_guard lock(mutex_);
  return !over_;
}

bool ReadingAhead::feed_piece() {
  auto piece = text_->read();
  if (!piece) {
    const std::lock_guard lock(mutex_);
    error_ = std::move(piece.error());
    return false;
  }
  if (piece->state == TextPiece::State::end) {
    kernel_->finish();
  } else {
    kernel_->feed(piece->bytes);
  }
  progress_->set_read(text_->share_read());
  return true;
}

void ReadingAhead::pause() {
  constexpr std::chrono::microseconds kAtMost{200};
  std::unique_lock lock(mutex_);
  wanted_change_.wait_for(lock, kAtMost, [this] { return over_ || is_wanted_; });
  is_wanted_ = false;
}

}  // namespace kerf::program
