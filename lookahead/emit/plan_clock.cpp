#include "lookahead/emit/plan_clock.hpp"

#include <algorithm>

namespace kerf::lookahead {

namespace {

// A rest that ends this close behind a tick ends on it: rounding of sums of durations.
constexpr double kTickRounding = 1e-9;

}  // namespace

std::int64_t PlanClock::next_tick() const noexcept {
  return now_.tick + (now_.offset_s > kTickRounding * period_s_ ? 1 : 0);
}

void PlanClock::advance(double duration_s) noexcept {
  const double offset = now_.offset_s + duration_s;
  const auto whole = static_cast<std::int64_t>(offset / period_s_);
  now_.tick += whole;
  now_.offset_s = std::max(offset - static_cast<double>(whole) * period_s_, 0.0);
}

void PlanClock::align_to_tick() noexcept {
  now_ = {.tick = next_tick()};
}

}  // namespace kerf::lookahead
