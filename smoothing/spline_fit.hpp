// A smooth curve through noisy points: least squares in the space of quintic splines.
//
// Idea. A spline of degree 5 on given knots is four times continuously differentiable, so nothing
// that the machine feels jumps. Its coefficients minimise the weighted sum of squared distances
// from the samples: a system with eleven diagonals, O(n) to solve. Points that decimals
// have moved to and fro are averaged by it as long as there are more of them than knots.
// (Least squares with B-splines: [DeBoor, chapter XIV].)
//
// Weakness. The parameter is the length of the polyline, so where noise makes the polyline much
// longer than the curve, the curve's speed is below 1; and next to an end the derivatives are known
// less well than within.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "curves/bezier_span.hpp"
#include "curves/position.hpp"
#include "smoothing/normal_equations.hpp"

namespace kerf::smoothing {

// A place w along the polyline, in mm from its begin, and the point there.
struct FitSample {
  double w_mm = 0.0;
  double weight = 0.0;
  curves::Position point_mm{};
};

// The data for the continuation of a spline: its value and derivatives at the junction, by its
// parameter.
struct SplineTail {
  std::array<Eigen::Vector3d, kFitDegree> derivatives{};  // from the 0th to the 4th
  double span_mm = 0.0;                                   // length of its last span
};

// One polynomial of the spline: powers of x in [-1, 1] over [w_begin, w_end].
struct FitSpan {
  double w_begin_mm = 0.0;
  double w_end_mm = 0.0;
  Eigen::Matrix<double, kFitDegree + 1, 3> powers{};

  [[nodiscard]] double local(double w_mm) const {
    return (2.0 * w_mm - w_begin_mm - w_end_mm) / (w_end_mm - w_begin_mm);
  }
  [[nodiscard]] Eigen::Vector3d at(double w_mm) const;
  [[nodiscard]] Eigen::Vector3d derivative(double w_mm) const;
  // Of |C''(w)| on the span.
  [[nodiscard]] double bend_bound_per_mm() const;
  [[nodiscard]] curves::BezierSpan bezier() const;
};

struct FitEnds {
  // The begin of a spline of its own, in this point, if there is no tail to go on from.
  curves::Position begin_mm{};
  std::optional<SplineTail> tail{};
  // Nothing: the end is as free as the rest.
  std::optional<curves::Position> end_mm{};
  // Of length 1: the first derivatives there, of ends that are given as points. Beside a tail the
  // end has one only if there are two spans or more.
  std::optional<Eigen::Vector3d> begin_direction{};
  std::optional<Eigen::Vector3d> end_direction{};
};

struct SplineFit {
  std::vector<FitSpan> spans;

  // To go on after this many spans. Precondition: 0 < count <= spans.
  [[nodiscard]] SplineTail tail_after(std::size_t count) const;
};

// breaks_mm: ascending, the ends of the spans, two at the least. Samples ascend and lie between the
// first and the last.
SplineFit fit_spline(std::span<const double> breaks_mm, std::span<const FitSample> samples,
                     const FitEnds& ends);

}  // namespace kerf::smoothing
