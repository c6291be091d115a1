// The concept of a feedrate law, which every shape is checked against.
#pragma once

#include <concepts>
#include <type_traits>

#include "profiles/shape_value.hpp"

namespace kerf::profiles {

// A shape is a small value, copied to the tick side. x is the share of the duration that has
// passed, in [0, 1].
//   at(x)                  phi, its integral and its first two derivatives; phi is monotone
//   peak_acceleration()    a*, the largest phi'
//   peak_jerk()            j*, the largest |phi''|; infinite where phi' jumps
//   fastest(change, limits)  the member of the family whose duration for that change of feedrate
//                          (either sign, mm/s) is the shortest
template <class S>
concept FeedrateShape = std::is_trivially_copyable_v<S> && std::default_initializable<S> &&
    requires(const S shape, double x, const RampLimits& limits) {
  { shape.at(x) }
  noexcept->std::same_as<ShapeValue>;
  { shape.peak_acceleration() } -> std::same_as<double>;
  { shape.peak_jerk() } -> std::same_as<double>;
  { S::fastest(x, limits) } -> std::same_as<S>;
};

// The peaks of a shape, which are all that a duration depends on.
struct ShapePeaks {
  double acceleration = 1.0;  // a*
  double jerk = 0.0;          // j*; 0 for a law without a jerk limit
};

// The value at x of the second half from the value at 1 - x of the first:
// phi(x) + phi(1 - x) = 1, so the integral is x - 1/2 + integral(1 - x).
constexpr ShapeValue mirrored(double x, const ShapeValue& at_one_minus_x) noexcept {
  return {.integral = x - 0.5 + at_one_minus_x.integral,
          .phi = 1.0 - at_one_minus_x.phi,
          .slope = at_one_minus_x.slope,
          .curvature = -at_one_minus_x.curvature};
}

}  // namespace kerf::profiles
