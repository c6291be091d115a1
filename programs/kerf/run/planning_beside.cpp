#include "programs/kerf/run/planning_beside.hpp"

#include <chrono>
#include <limits>

#include "programs/kerf/io/interrupt.hpp"

namespace kerf::program {

PlanningBeside::PlanningBeside(Kernel& kernel, Feeder& feeder)
    : kernel_(&kernel), feeder_(&feeder), thread_([this] { work(); }) {}

PlanningBeside::~PlanningBeside() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  asked_change_.notify_one();
  thread_.join();
}

void PlanningBeside::reach_tick() {
  if (stop_requested()) {  // the ticks are faster than any stop that is planned beside them
    await_plan();
  }
  while (lacks_plan()) {
    const std::uint64_t block = kernel_->detail().block;
    kernel_->make_room();
    if (kernel_->detail().block == block) {
      return;
    }
  }
  if (++ticks_ >= kTicksOfRoom) {
    ask();
  }
}

bool PlanningBeside::lacks_plan() {
  if (!kernel_->needs_plan()) {
    return false;
  }
  const std::uint64_t number = ask();
  while (kernel_->needs_plan() && !wait_for(number)) {
  }
  return kernel_->needs_plan();
}

void PlanningBeside::await_plan() {
  for (const std::uint64_t number = ask(); !wait_for(number);) {
  }
}

std::uint64_t PlanningBeside::ask() {
  ticks_ = 0;
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = ++asked_;
  }
  asked_change_.notify_one();
  return number;
}

bool PlanningBeside::wait_for(std::uint64_t number) {
  constexpr std::chrono::microseconds kAtMost{300};
  std::unique_lock lock(mutex_);
  const bool is_done = done_change_.wait_for(lock, kAtMost, [&] { return done_ >= number; });
  if (error_) {
    std::rethrow_exception(error_);
  }
  return is_done;
}

void PlanningBeside::work() noexcept {
  std::unique_lock lock(mutex_);
  for (;;) {
    asked_change_.wait(lock, [this] { return over_ || asked_ > done_; });
    if (over_) {
      return;
    }
    const std::uint64_t number = asked_;
    lock.unlock();
    try {
      plan();
      lock.lock();
      done_ = number;
    } catch (...) {
      lock.lock();
      error_ = std::current_exception();
      done_ = std::numeric_limits<std::uint64_t>::max();
    }
    done_change_.notify_one();
  }
}

void PlanningBeside::plan() {
  if (stop_requested()) {
    feeder_->stop();
  }
  feeder_->pump();
}

}  // namespace kerf::program
