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
constexpr double kTangential = 1e-6;  // of a turn
// Of what a side itself turns along the way. A blend for a corner between lines slows down where
// they meet, and between curves its curvature swings by half of theirs: beside a slighter turn that
// swing asks for more jerk than the turn.
constexpr double kSlight = 0.3;

// s' and s'' by w at the begin of a blend; at its end s'' has the other sign.
struct ArcLengthRates {
  double first_mm = 0.0, second_mm = 0.0;
};

// Through a corner s = d w^3 from it, through a tangential joint w goes with s.
ArcLengthRates rates_at_begin(bool tangential, double way_mm) {
  return tangential ? ArcLengthRates{2.0 * way_mm, 0.0}
                    : ArcLengthRates{3.0 * way_mm, -6.0 * way_mm};
}

// r's derivatives by w at an end.
struct EndDerivatives {
  EndDerivatives(const PathDerivatives& path, const ArcLengthRates& rates)
      : point(vec(path.position_mm)),
        first(rates.first_mm * vec(path.first)),
        second(rates.first_mm * rates.first_mm * vec(path.second_per_mm) +
               rates.second_mm * vec(path.first)) {}

  Eigen::Vector3d point, first, second;
};

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
  const ArcLengthRates rates = rates_at_begin(is_tangential(corner, way_mm), way_mm);
  const EndDerivatives begin(curves::derivatives_at(*corner.before, length_mm - way_mm), rates);
  const EndDerivatives end(curves::derivatives_at(*corner.after, way_mm),
                           {rates.first_mm, -rates.second_mm});
  const curves::BezierSpan span = hermite_span(begin, end);
  auto made = curves::NurbsCurve::from_spans({&span, 1}, curves::to_position(end.point));
  if (!made || made->size() != 1) {
    return std::nullopt;
  }
  return std::move(made->front());
}

}  // namespace

bool is_tangential(const Corner& corner, double way_mm) {
  const CornerShape shape = shape_of(corner);
  return shape.turn < std::max(kTangential, kSlight * shape.curvature_per_mm * way_mm);
}

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
  return shape_between(before, curves::derivatives_at(*corner.after, 0.0));
}

CornerShape shape_between(const PathDerivatives& before, const PathDerivatives& after) {
  return {.turn = (vec(after.first) - vec(before.first)).norm(),
          .curvature_per_mm =
              std::max(vec(before.second_per_mm).norm(), vec(after.second_per_mm).norm()),
          .bend_per_mm = (vec(after.second_per_mm) - vec(before.second_per_mm)).norm()};
}

}  // namespace kerf::smoothing
