// One rational Bezier span, the form in which NURBS are cut up. Look-ahead side only.
//
// Computed in long double (but see Wide) about an origin of its own that moves along as the span is
// halved: then rounding is relative to the size of the span and not to its distance from the
// machine's zero, and tangents keep their digits down to pieces of 1e-12 mm. Halving by de
// Casteljau only averages (weights stay positive and keep their relative accuracy), whatever the
// ratio of the weights.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <Eigen/Core>

#include "curves/nurbs_piece.hpp"
#include "curves/position.hpp"

namespace kerf::curves {

// WebAssembly has no wide floating point: long double is 128 bits in software there, a sixth of
// the time of a plan. With double, pieces meet within 2e-13 mm instead of 1e-13, which no page
// shows.
#ifdef __wasm__
using Wide = double;
#else
using Wide = long double;
#endif
using WideVector = Eigen::Matrix<Wide, 3, 1>;
using WidePoint = Eigen::Matrix<Wide, 4, 1>;  // (w x, w y, w z, w)

inline WideVector widen(const Position& p) {
  return {static_cast<Wide>(p[0]), static_cast<Wide>(p[1]), static_cast<Wide>(p[2])};
}

inline Position narrow(const WideVector& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

struct BezierSpan {
  int degree = 1;
  Wide u_begin = 0.0L;
  Wide u_end = 0.0L;
  WideVector origin_mm = WideVector::Zero();
  std::array<WidePoint, kMaxDegree + 1> points{};  // about origin_mm, degree + 1 of them

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(degree) + 1; }
  // Control point i, seen from origin_mm.
  [[nodiscard]] WideVector seen(std::size_t i) const { return points[i].head<3>() / points[i].w(); }
  [[nodiscard]] Position begin_mm() const { return narrow(origin_mm + seen(0)); }
  [[nodiscard]] Position end_mm() const { return narrow(origin_mm + seen(count() - 1)); }
  // Sum of the lengths of the control polygon's sides: no less than the arc length.
  [[nodiscard]] Wide polygon_length_mm() const;
  // Largest weight over smallest.
  [[nodiscard]] Wide weight_ratio() const;
  // Unit tangents at the ends, as limits where control points coincide (closer than noise_mm): the
  // first control point apart from the end shows the way. Zero if all coincide.
  [[nodiscard]] WideVector begin_direction(Wide noise_mm) const;
  [[nodiscard]] WideVector end_direction(Wide noise_mm) const;
};

// The two halves in u, their common point as the origin of both.
std::pair<BezierSpan, BezierSpan> halve(const BezierSpan& span);

// Homogeneous coefficients by x^k about the begin of the span, where its end is at x = 1.
std::array<WidePoint, kMaxDegree + 1> taylor_at_begin(const BezierSpan& span);

// The span of powers of x over x in [-1, 1]; its origin and u are left to the caller.
BezierSpan from_powers(const std::array<WidePoint, kMaxDegree + 1>& power, int degree);

}  // namespace kerf::curves
