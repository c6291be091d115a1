#include "profiles/transition.hpp"

#include <algorithm>
#include <cassert>
#include <type_traits>
#include <utility>
#include <variant>

namespace kerf::profiles {
namespace {

static_assert(std::is_trivially_copyable_v<Transition>);
static_assert(sizeof(Transition) <= 64);

// A Shape holds a law always: its alternatives are trivially copyable, so none can fail to be made.
// NOLINTNEXTLINE(bugprone-exception-escape)
ShapeValue value_at(const Shape& shape, double x) noexcept {
  return std::visit([x](const auto& law) { return law.at(x); }, shape);
}

}  // namespace

Transition::Transition(Ramp ramp, double duration_s, Shape shape)
    : ramp_(ramp), duration_s_(duration_s), shape_(shape) {
  assert(duration_s >= 0.0 && ramp.v_begin_mm_s >= 0.0 && ramp.v_end_mm_s >= 0.0);
}

Transition Transition::cruise(double v_mm_s, double length_mm) {
  assert(v_mm_s > 0.0 && length_mm >= 0.0);
  return {{.v_begin_mm_s = v_mm_s, .v_end_mm_s = v_mm_s}, length_mm / v_mm_s, Shape{}};
}

Transition Transition::rest(double duration_s) {
  return {Ramp{}, duration_s, Shape{}};
}

// The second half is measured from the end: there both the feedrate and the distance to go are
// exact to their last places, not to those of the whole transition, and the end is met exactly.
// NOLINTNEXTLINE(bugprone-exception-escape): see value_at.
PathMotion Transition::at(double t_s) const noexcept {
  const double change = ramp_.v_end_mm_s - ramp_.v_begin_mm_s;
  const bool at_end = t_s >= duration_s_;
  const bool at_begin = !(t_s > 0.0);
  if (change == 0.0 || !(duration_s_ > 0.0)) {
    const double s = at_end ? length_mm() : (at_begin ? 0.0 : ramp_.v_begin_mm_s * t_s);
    return {.s_mm = std::min(s, length_mm()), .v_mm_s = ramp_.v_end_mm_s};
  }
  const double rate = change / duration_s_;
  if (t_s <= 0.5 * duration_s_ || at_begin) {
    const double t = at_begin ? 0.0 : t_s;
    const ShapeValue value = value_at(shape_, t / duration_s_);
    return {.s_mm = ramp_.v_begin_mm_s * t + change * duration_s_ * value.integral,
            .v_mm_s = ramp_.v_begin_mm_s + change * value.phi,
            .a_mm_s2 = rate * value.slope,
            .j_mm_s3 = rate / duration_s_ * value.curvature};
  }
  const double left_s = at_end ? 0.0 : duration_s_ - t_s;
  const ShapeValue value = value_at(shape_, left_s / duration_s_);
  return {.s_mm = length_mm() - (ramp_.v_end_mm_s * left_s - change * duration_s_ * value.integral),
          .v_mm_s = ramp_.v_end_mm_s - change * value.phi,
          .a_mm_s2 = rate * value.slope,
          .j_mm_s3 = -rate / duration_s_ * value.curvature};
}

Transition Transition::stretched(double factor) const noexcept {
  assert(factor > 0.0);
  Transition result = *this;
  result.duration_s_ *= factor;
  return result;
}

Transition Transition::slowed(double factor) const noexcept {
  Transition result = stretched(factor);
  result.ramp_.v_begin_mm_s /= factor;
  result.ramp_.v_end_mm_s /= factor;
  return result;
}

Transition Transition::reversed() const noexcept {
  Transition result = *this;
  std::swap(result.ramp_.v_begin_mm_s, result.ramp_.v_end_mm_s);
  return result;
}

}  // namespace kerf::profiles
