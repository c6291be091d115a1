// A stretch of a NURBS curve short enough that u(s) is one polynomial; a tick evaluates it.
#pragma once

#include <array>
#include <cstdint>

#include "curves/position.hpp"

namespace kerf::curves {

inline constexpr int kMaxDegree = 9;

// Homogeneous polynomials in a local parameter x in [-1, 1] about the middle of the piece, and
// x(s) as a polynomial in arc length, scaled to [-1, 1] as well. One evaluation is two Horner
// schemes and a division: the point lies on the curve to rounding whatever the error of x(s),
// which is below kArcLengthTolerance_mm (arc_length.hpp) along the path. Coordinates count from a
// point on the piece, so that rounding is that of one addition to the machine's coordinates.
struct NurbsPiece {
  static constexpr int kMapDegree = 9;
  double s_begin_mm = 0.0;
  double s_end_mm = 0.0;
  double u_begin = 0.0;
  double u_end = 0.0;
  std::int32_t degree = 0;
  bool ends_curve = false;  // at(s_end) is end_mm then, exactly
  Position origin_mm{};     // the curve at x = 0
  Position end_mm{};
  std::array<double, kMapDegree + 1> local_by_length{};  // x = sum c_k y^k, y in [-1, 1]
  // (w x, w y, w z, w) by x^k, about origin_mm, w = 1 at x = 0
  std::array<std::array<double, 4>, kMaxDegree + 1> coefficients{};

  // s_mm counts from the start of the whole curve; outside [s_begin, s_end] it is clamped.
  [[nodiscard]] Position at(double s_mm) const noexcept;
  // Exact at the point x(s): from the derivatives of the homogeneous polynomials. At a point where
  // the curve's parametrisation stands still (|C'(u)| = 0) the curvature has no limit in general;
  // the derivatives of a point less than 1e-11 mm away are given instead.
  [[nodiscard]] PathDerivatives derivatives_at(double s_mm) const noexcept;
  // To the resolution of double in u, however much path that is.
  [[nodiscard]] double u_at(double s_mm) const noexcept;
};

// x(s), within [-1, 1]. s_mm outside the piece is clamped.
double local_parameter(const NurbsPiece& piece, double s_mm) noexcept;

// s where x(s) is x, which is within [-1, 1].
double length_at(const NurbsPiece& piece, double x) noexcept;

// |dC/dx| at the local parameter x: the arc length per x.
double speed_mm(const NurbsPiece& piece, double x) noexcept;

}  // namespace kerf::curves
