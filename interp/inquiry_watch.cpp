#include "interp/inquiry_watch.hpp"

namespace kerf::interp {

const Inquiry* InquiryWatch::asked() noexcept {
  const std::uint32_t number = asked_.load(std::memory_order_acquire);
  if (number == answered_.load(std::memory_order_relaxed)) {
    return nullptr;
  }
  if (begun_ != number) {
    begun_ = number;
    found_ = {};
    moves_ = false;
    ticks_at_rest_ = 0;
  }
  return &inquiry_;
}

void InquiryWatch::trip() noexcept {
  found_.found = true;
  found_.place_mm = inputs_.has_latched ? inputs_.latched_mm : inputs_.actual_mm;
}

bool InquiryWatch::must_brake() noexcept {
  if (ignores_.load(std::memory_order_relaxed)) {
    return false;
  }
  if (!found_.found && touches_as_asked()) {
    trip();
    found_.at_start = !moves_;
  }
  moves_ = true;
  return found_.found && !found_.has_braked;
}

void InquiryWatch::brake(const InquiryAnswer& braked) noexcept {
  found_.has_braked = true;
  found_.brake_tick = braked.brake_tick;
  found_.plan = braked.plan;
  found_.laws = braked.laws;
  found_.law = braked.law;
}

bool InquiryWatch::hears_input() noexcept {
  using Kind = Inquiry::Kind;
  if (inquiry_.kind == Kind::analog) {
    found_.value = inputs_.analog[inquiry_.channel];
    return found_.found = true;
  }
  if (inquiry_.kind == Kind::at_speed) {
    return found_.found = inputs_.spindle_at_speed;
  }
  const bool is_high = ((inputs_.digital >> inquiry_.channel) & 1U) != 0;
  const bool was_high = was_high_;
  was_high_ = is_high;
  found_.value = is_high ? 1.0 : 0.0;
  switch (inquiry_.kind) {
    case Kind::rise:
      found_.found = is_high && !was_high;
      break;
    case Kind::fall:
      found_.found = !is_high && was_high;
      break;
    case Kind::high:
      found_.found = is_high;
      break;
    case Kind::low:
      found_.found = !is_high;
      break;
    default:
      found_.found = true;
      break;
  }
  return found_.found || ticks_at_rest_ > inquiry_.max_ticks;
}

// What the outputs of the first tick at rest have brought about, the machine says at the next.
bool InquiryWatch::wait(const Position& rest_mm, std::int64_t plan_tick) noexcept {
  const bool is_first = ticks_at_rest_++ == 0;
  if (is_first) {
    was_high_ = ((inputs_.digital >> inquiry_.channel) & 1U) != 0;
    return false;
  }
  if (!inquiry_.is_probe()) {
    if (!hears_input()) {
      return false;
    }
  } else if (!found_.found && touches_as_asked()) {
    trip();
  } else if (!found_.found) {
    found_.place_mm = rest_mm;
  }
  found_.rest_mm = rest_mm;
  found_.rest_tick = plan_tick;
  answer_ = found_;
  answered_.store(begun_, std::memory_order_release);
  return true;
}

}  // namespace kerf::interp
