#include "control/home_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace kerf::control {

namespace {

constexpr std::array kNames{"x", "y", "z"};

AxisSet bit_of(std::size_t axis) {
  return static_cast<AxisSet>(1U << axis);
}

constexpr double kFarthest_mm = 2000.0;  // is a switch of an axis without travel

double travel_of_search_mm(const AxisHoming& homing, const Travel& travel) {
  const double farthest_mm = homing.search_mm_s < 0.0 ? travel.max_mm - homing.switch_mm
                                                      : homing.switch_mm - travel.min_mm;
  const double longest_mm =
      std::isfinite(farthest_mm) ? farthest_mm + homing.back_off_mm : kFarthest_mm;
  return std::isfinite(homing.travel_mm) ? homing.travel_mm : longest_mm;
}

std::string text_of(double number) {
  std::array<char, 32> digits{};
  const int count = std::snprintf(digits.data(), digits.size(), "%g", number);
  return {digits.data(), static_cast<std::size_t>(count)};
}

}  // namespace

HomeSearch::HomeSearch(const MachineSettings& settings)
    : homing_(settings.manual.homing), period_s_(settings.limits.period_s) {
  for (std::size_t axis = 0; axis < homing_.size(); ++axis) {
    homing_[axis].travel_mm = travel_of_search_mm(homing_[axis], settings.table.axes[axis].travel);
    if (std::isfinite(homing_[axis].switch_mm)) {
      switches_ = static_cast<AxisSet>(switches_ | bit_of(axis));
      order_.push_back(axis);
    }
  }
  std::ranges::stable_sort(order_, {}, [this](std::size_t axis) { return homing_[axis].order; });
  unhomed_ = switches_;
}

void HomeSearch::begin() {
  forget_homes();
  axes_done_ = 0;
  waits_ = false;
  step_ = Step::begin;
}

HomeSearch::Next HomeSearch::next(const Setpoint& at, Move& move) {
  watch_.store({});
  switch (step_) {
    case Step::begin:
      return waits_for_switches(at) ? Next::waits : begin_axis(at, move);
    case Step::clear:
      return has_found() ? look_for_it(at, move) : fail("stays closed");
    case Step::search:
      return has_found() ? back_off(Step::back_off, at, move)
                         : fail("did not close within " + text_of(of_axis().travel_mm) + " mm");
    case Step::back_off:
      return has_found() ? latch(at, move) : fail("stays closed");
    case Step::latch:
      return has_found() ? give_place() : fail("did not close again");
    case Step::place:
      return go_home(at, move);
    case Step::go_home:
      return ++axes_done_ == order_.size() ? Next::done : begin_axis(at, move);
  }
  return Next::done;
}

// Before the first tick nobody has read them: an axis that stands on its own would go on into it.
bool HomeSearch::waits_for_switches(const Setpoint& at) {
  if (seen_.is_known) {
    return false;
  }
  if (!std::exchange(waits_, true)) {
    begun_tick_ = at.tick;
  }
  return static_cast<double>(at.tick - begun_tick_) * period_s_ < of_axis().time_s;
}

HomeSearch::Next HomeSearch::begin_axis(const Setpoint& at, Move& move) {
  return is_closed(axis()) ? back_off(Step::clear, at, move) : look_for_it(at, move);
}

HomeSearch::Next HomeSearch::latch(const Setpoint& at, Move& move) {
  const AxisHoming& homing = of_axis();
  return look(
      Step::latch, true,
      {.axis = axis(),
       .to_mm = at.position_mm[axis()] + std::copysign(homing.back_off_mm, homing.search_mm_s),
       .mm_s = homing.latch_mm_s},
      at.tick, move);
}

HomeSearch::Next HomeSearch::give_place() {
  shifted_axis_ = axis();
  shift_mm_ = of_axis().switch_mm - found_mm_.load(std::memory_order_relaxed);
  step_ = Step::place;
  shifts_.store(true, std::memory_order_release);
  return Next::gives_place;
}

// Once the tick side has taken the place.
HomeSearch::Next HomeSearch::go_home(const Setpoint& at, Move& move) {
  if (is_placing(at)) {
    return Next::waits;
  }
  const AxisHoming& homing = of_axis();
  unhomed_.fetch_and(static_cast<AxisSet>(~bit_of(axis())));
  step_ = Step::go_home;
  ++looks_;
  begun_tick_ = at.tick;
  move = {.axis = axis(),
          .to_mm = std::isfinite(homing.home_mm) ? homing.home_mm : homing.switch_mm,
          .mm_s = std::fabs(homing.search_mm_s)};
  return Next::moves;
}

HomeSearch::Next HomeSearch::look_for_it(const Setpoint& at, Move& move) {
  const AxisHoming& homing = of_axis();
  return look(
      Step::search, true,
      {.axis = axis(),
       .to_mm = at.position_mm[axis()] + std::copysign(homing.travel_mm, homing.search_mm_s),
       .mm_s = std::fabs(homing.search_mm_s)},
      at.tick, move);
}

HomeSearch::Next HomeSearch::back_off(Step step, const Setpoint& at, Move& move) {
  const AxisHoming& homing = of_axis();
  return look(
      step, false,
      {.axis = axis(),
       .to_mm = at.position_mm[axis()] - std::copysign(homing.back_off_mm, homing.search_mm_s),
       .mm_s = std::fabs(homing.search_mm_s)},
      at.tick, move);
}

HomeSearch::Next HomeSearch::look(Step step, bool closed, const Move& move, std::int64_t tick,
                                  Move& out) {
  step_ = step;
  out = move;
  begun_tick_ = tick;
  closed_at_begin_ = seen_.closed;
  ++looks_;
  watch_.store({.axis = static_cast<std::uint8_t>(axis()), .closed = closed, .look = looks_});
  return Next::moves;
}

std::optional<std::string> HomeSearch::complaint(std::int64_t tick) const {
  if (static_cast<double>(tick - begun_tick_) * period_s_ > of_axis().time_s) {
    return of_switch("was not found within " + text_of(of_axis().time_s) + " s");
  }
  if (step_ == Step::go_home) {
    return std::nullopt;
  }
  const auto changed = static_cast<AxisSet>((seen_.closed ^ closed_at_begin_) & unhomed());
  for (std::size_t other = 0; other < homing_.size(); ++other) {
    if (other != axis() && (changed & bit_of(other)) != 0) {
      return std::string("homing ") + kNames[axis()] + ": the switch of " + kNames[other] +
             " changed";
    }
  }
  return std::nullopt;
}

HomeSearch::Next HomeSearch::fail(const std::string& what) {
  failure_ = of_switch(what);
  return Next::failed;
}

std::string HomeSearch::of_switch(const std::string& what) const {
  return std::string("homing ") + kNames[axis()] + ": its switch " + what;
}

void HomeSearch::see(AxisSet closed, const Setpoint& last) noexcept {
  closed_.store(closed, std::memory_order_relaxed);
  has_seen_.store(true);
  const Watch watch = watch_.load();
  if (watch.axis == Watch::kNone || found_.load(std::memory_order_relaxed) == watch.look) {
    return;
  }
  if ((((closed >> watch.axis) & 1U) != 0) == watch.closed) {
    found_mm_.store(last.position_mm[watch.axis], std::memory_order_relaxed);
    found_.store(watch.look, std::memory_order_release);
  }
}

bool HomeSearch::take_place(Setpoint& last) noexcept {
  if (!shifts_.load(std::memory_order_acquire)) {
    return false;
  }
  last.position_mm[shifted_axis_] += shift_mm_;
  place_tick_ = last.tick + 1;
  shifts_.store(false, std::memory_order_release);
  return true;
}

}  // namespace kerf::control
