#include "smoothing/blend.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "curves/bezier_span.hpp"
#include "curves/curve_builders.hpp"

namespace kerf::smoothing {

using curves::PathDerivatives;
using curves::Position;
using curves::vec;

namespace {

constexpr int kDegree = 5;

// r's derivatives by w at an end: s = d w^3 from the corner, so s' = 3 d and s'' = 6 d there.
struct EndDerivatives {
  Eigen::Vector3d point, first, second;
};

EndDerivatives at_begin(const PathDerivatives& path, double way_mm) {
  return {vec(path.position_mm), 3.0 * way_mm * vec(path.first),
          9.0 * way_mm * way_mm * vec(path.second_per_mm) - 6.0 * way_mm * vec(path.first)};
}

EndDerivatives at_end(const PathDerivatives& path, double way_mm) {
  return {vec(path.position_mm), 3.0 * way_mm * vec(path.first),
          9.0 * way_mm * way_mm * vec(path.second_per_mm) + 6.0 * way_mm * vec(path.first)};
}

curves::BezierSpan hermite_span(const EndDerivatives& begin, const EndDerivatives& end) {
  const std::array<Eigen::Vector3d, 6> points{
      Eigen::Vector3d::Zero(),
      0.2 * begin.first,
      0.4 * begin.first + 0.05 * begin.second,
      end.point - begin.point - 0.4 * end.first + 0.05 * end.second,
      end.point - begin.point - 0.2 * end.first,
      end.point - begin.point};
  curves::BezierSpan span{.degree = kDegree, .u_begin = 0.0L, .u_end = 1.0L};
  span.origin_mm = begin.point.cast<curves::Wide>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    span.points[i] << points[i].cast<curves::Wide>(), 1.0L;
  }
  return span;
}

std::optional<curves::NurbsCurve> curve_between_lines(const curves::Line& before,
                                                      const curves::Line& after, double way_mm) {
  return curves::corner_cubic({.corner_mm = after.at(0.0),
                               .direction_in = before.direction(),
                               .direction_out = after.direction(),
                               .way_mm = way_mm});
}

std::optional<curves::NurbsCurve> curve_between(const Corner& corner, double way_mm) {
  const double length_mm = curves::length_mm(*corner.before);
  const EndDerivatives begin =
      at_begin(curves::derivatives_at(*corner.before, length_mm - way_mm), way_mm);
  const EndDerivatives end = at_end(curves::derivatives_at(*corner.after, way_mm), way_mm);
  const curves::BezierSpan span = hermite_span(begin, end);
  auto made = curves::NurbsCurve::from_spans({&span, 1}, curves::to_position(end.point));
  if (!made || made->size() != 1) {
    return std::nullopt;
  }
  return std::move(made->front());
}

}  // namespace

std::optional<Blend> make_blend(const Corner& corner, double way_mm) {
  assert(0.0 < way_mm && way_mm <= curves::length_mm(*corner.before) &&
         way_mm <= curves::length_mm(*corner.after));
  const auto* before = std::get_if<curves::Line>(corner.before);
  const auto* after = std::get_if<curves::Line>(corner.after);
  auto curve = before != nullptr && after != nullptr ? curve_between_lines(*before, *after, way_mm)
                                                     : curve_between(corner, way_mm);
  if (!curve) {
    return std::nullopt;
  }
  Blend blend{.curve = std::move(*curve)};
  blend.s_corner_mm = blend.curve.s_at(0.5);
  return blend;
}

CornerShape shape_of(const Corner& corner) {
  const PathDerivatives before =
      curves::derivatives_at(*corner.before, curves::length_mm(*corner.before));
  const PathDerivatives after = curves::derivatives_at(*corner.after, 0.0);
  return {.turn = (vec(after.first) - vec(before.first)).norm(),
          .curvature_per_mm =
              std::max(vec(before.second_per_mm).norm(), vec(after.second_per_mm).norm()),
          .bend_per_mm = (vec(after.second_per_mm) - vec(before.second_per_mm)).norm()};
}

}  // namespace kerf::smoothing
