#include "programs/kerf/control/plan_pace.hpp"

#include <utility>

namespace kerf::program {

bool PlanPace::look(std::int64_t tick) {
  std::unique_lock lock(mutex_);
  if (is_over_) {
    return true;
  }
  if (tick == kTakenBack) {  // never of a run once more: its ticks wait
    record_.take_back_look();
    return true;
  }
  if (!repeated_) {
    record_.add_look(tick);
    return true;
  }
  if (repeated_->take_look(tick)) {
    return true;
  }
  const std::uint64_t ticks = ticks_;
  waits_ = true;
  changed_.notify_all();
  changed_.wait(lock, [&] { return is_over_ || ticks_ != ticks; });
  return false;
}

void PlanPace::note(std::string_view order) {
  const std::lock_guard lock(mutex_);
  if (!is_over_ && !repeated_) {
    record_.add_order(order);
  }
}

std::optional<std::string> PlanPace::next_order() {
  const std::lock_guard lock(mutex_);
  const auto order = is_over_ || !repeated_ ? std::nullopt : repeated_->take_order();
  return order ? std::optional(std::string(*order)) : std::nullopt;
}

bool PlanPace::next_is_end() {
  const std::lock_guard lock(mutex_);
  if (is_over_ || !repeated_ || repeated_->order() != kEnd) {
    return false;
  }
  repeated_->take_order();
  return true;
}

bool PlanPace::begin_tick(std::int64_t tick) {
  if (!repeated_) {
    return false;
  }
  std::unique_lock lock(mutex_);
  if (std::exchange(has_begun_, true)) {
    ++ticks_;
    waits_ = false;
    changed_.notify_all();
  }
  changed_.wait(lock, [this] { return is_over_ || waits_; });
  return emergency_tick_ == tick;
}

PlanRecord PlanPace::record() const {
  PlanRecord record = record_;
  if (emergency_tick_ != kNone) {
    record.emergency_tick = emergency_tick_;
  }
  return record;
}

void PlanPace::end() {
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  changed_.notify_all();
}

}  // namespace kerf::program
