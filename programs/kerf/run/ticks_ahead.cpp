#include "programs/kerf/run/ticks_ahead.hpp"

namespace kerf::program {

TicksAhead::TicksAhead(Kernel& kernel, PlanningBeside& planning)
    : kernel_(&kernel), planning_(&planning), thread_([this] { work(); }) {}

TicksAhead::~TicksAhead() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  change_.notify_all();
  thread_.join();
}

bool TicksAhead::is_asked() {
  planning_->reach_tick();
  return kernel_->asks_machine();
}

TicksAhead::Tick TicksAhead::make() {
  Tick tick;
  tick.status = kernel_->tick(tick.setpoint);
  tick.detail = kernel_->detail();
  return tick;
}

void TicksAhead::take() {
  std::unique_lock lock(mutex_);
  change_.wait(lock, [this] { return is_ready_ || has_ended_; });
  if (!is_ready_) {
    std::rethrow_exception(error_);
  }
  taken_.swap(ready_);
  next_ = 0;
  is_ready_ = false;
  makes_here_ = is_asked_;
  change_.notify_all();
}

void TicksAhead::give_back() {
  {
    const std::lock_guard lock(mutex_);
    makes_here_ = is_asked_ = false;
  }
  change_.notify_all();
}

void TicksAhead::work() noexcept {
  std::exception_ptr error;
  try {
    make_ahead();
  } catch (...) {
    error = std::current_exception();
  }
  hand_over(false);
  const std::lock_guard lock(mutex_);
  error_ = error;
  has_ended_ = true;
  change_.notify_all();
}

void TicksAhead::make_ahead() {
  for (TickStatus status{}; status != TickStatus::finished && status != TickStatus::failed;) {
    if (is_asked()) {
      if (!hand_over(true)) {
        return;
      }
      continue;
    }
    made_.push_back(make());
    status = made_.back().status;
    if (made_.size() == kBatch && !hand_over(false)) {
      return;
    }
  }
}

bool TicksAhead::hand_over(bool is_asked) {
  std::unique_lock lock(mutex_);
  change_.wait(lock, [this] { return !is_ready_ || over_; });
  ready_.swap(made_);
  made_.clear();
  is_ready_ = true;
  is_asked_ = is_asked;
  change_.notify_all();
  change_.wait(lock, [this] { return !is_asked_ || over_; });
  return !over_;
}

}  // namespace kerf::program
