// One change of feedrate, or a cruise where both feedrates are equal, as a value in closed form.
#pragma once

#include <type_traits>
#include <variant>

#include "profiles/quintic.hpp"
#include "profiles/s_curve.hpp"
#include "profiles/shape_value.hpp"
#include "profiles/sigmoid.hpp"
#include "profiles/sine.hpp"
#include "profiles/sine_series.hpp"
#include "profiles/trapezoid.hpp"

namespace kerf::profiles {

// Any of the shapes, by value.
using Shape = std::variant<Trapezoid, SCurve, Sine, Quintic, SineSeries, Sigmoid>;

static_assert(std::is_trivially_copyable_v<Shape>);
static_assert(sizeof(Shape) <= 40);

// The feedrates that a transition joins, both >= 0.
struct Ramp {
  double v_begin_mm_s = 0.0;
  double v_end_mm_s = 0.0;
};

// v(t) = v_begin + (v_end - v_begin) phi(t / duration). Acceleration is 0 at both ends but for the
// trapezoid. Trivially copyable: it crosses to the tick side.
class Transition {
 public:
  Transition() = default;
  // Precondition: duration_s >= 0; 0 only where the feedrates are equal or the limits infinite.
  Transition(Ramp ramp, double duration_s, Shape shape);
  // A stretch of constant feedrate over length_mm. Precondition: v_mm_s > 0, length_mm >= 0.
  static Transition cruise(double v_mm_s, double length_mm);
  // A rest of duration_s.
  static Transition rest(double duration_s);

  [[nodiscard]] const Ramp& ramp() const noexcept { return ramp_; }
  [[nodiscard]] double duration_s() const noexcept { return duration_s_; }
  // (v_begin + v_end) / 2 * duration, for every shape by its symmetry.
  [[nodiscard]] double length_mm() const noexcept {
    return 0.5 * (ramp_.v_begin_mm_s + ramp_.v_end_mm_s) * duration_s_;
  }
  // Motion t_s after the start; s counts from 0 there. t_s outside [0, duration] is clamped. Exact
  // at both ends: v_begin and s = 0 there, v_end and s = length_mm() here. With duration 0 it is at
  // its end throughout.
  // NOLINTNEXTLINE(bugprone-exception-escape): std::visit throws on a Shape without a law only.
  [[nodiscard]] PathMotion at(double t_s) const noexcept;
  // The same shape over factor times the duration: slower, longer, gentler. Precondition: > 0.
  [[nodiscard]] Transition stretched(double factor) const noexcept;
  // The same motion with every feedrate divided by factor, so over factor times the duration and
  // the same length. Precondition: > 0.
  [[nodiscard]] Transition slowed(double factor) const noexcept;
  // The same motion backwards in time: from v_end to v_begin, a mirror image by the symmetry of
  // every shape.
  [[nodiscard]] Transition reversed() const noexcept;

 private:
  Ramp ramp_{};
  double duration_s_ = 0.0;
  Shape shape_{};
};

}  // namespace kerf::profiles
