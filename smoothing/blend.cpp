#include "smoothing/blend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "curves/bezier_span.hpp"
#include "curves/corner_cubic.hpp"

namespace kerf::smoothing {

using curves::PathDerivatives;
using curves::Position;
using curves::Stretch;
using curves::vec;

namespace {

constexpr int kDegree = 5;
constexpr int kPlaces = 32;             // of a blend, where its departure is looked at
constexpr double kFinest = 1.0 / 256;   // between them, around the farthest: 3e-5 of it are missed
constexpr double kFinestOfPath = 1e-5;  // merged lines may turn as sharply as a needle there
constexpr int kProjections = 4;
constexpr double kReach = 1.5;  // of the way, within which the nearest point of a curve lies

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

// The nearest point of a curve, by Newton's method from a place close to it.
double distance_mm(const curves::Curve& curve, const Position& point, double s_mm,
                   const Stretch& within) {
  double s = std::clamp(s_mm, within.begin_mm, within.end_mm);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kProjections; ++i) {
    const PathDerivatives path = curves::derivatives_at(curve, s);
    const Eigen::Vector3d away = vec(point) - vec(path.position_mm);
    nearest = std::min(nearest, away.norm());
    const double slope = 1.0 - away.dot(vec(path.second_per_mm));
    s = std::clamp(s + away.dot(vec(path.first)) / std::max(slope, 0.5), within.begin_mm,
                   within.end_mm);
  }
  return std::min(nearest, (vec(point) - vec(curves::position_at(curve, s))).norm());
}

// The distance of a point of the programmed path from the blend, whose places lie close together.
Departure from_blend(const Position& point, const std::array<Position, kPlaces + 1>& places) {
  Departure nearest{.distance_mm = std::numeric_limits<double>::infinity()};
  for (std::size_t k = 1; k < places.size(); ++k) {
    const Eigen::Vector3d chord = vec(places[k]) - vec(places[k - 1]);
    const Eigen::Vector3d seen = vec(point) - vec(places[k - 1]);
    const double squared = chord.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(seen.dot(chord) / squared, 0.0, 1.0) : 0.0;
    const double away_mm = (seen - share * chord).norm();
    if (away_mm < nearest.distance_mm) {
      nearest = {.distance_mm = away_mm, .at_mm = places[k]};
    }
  }
  return nearest;
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

Departure departure_of(const Blend& blend, const Corner& corner, double way_mm) {
  const double before_mm = curves::length_mm(*corner.before);
  const double after_mm = curves::length_mm(*corner.after);
  if (std::holds_alternative<curves::Line>(*corner.before) &&
      std::holds_alternative<curves::Line>(*corner.after)) {
    return {.distance_mm = 0.125 * way_mm * shape_of(corner).turn,
            .at_mm = blend.curve.at(blend.s_corner_mm)};
  }
  const double reach_mm = kReach * way_mm;
  const Stretch taken_before{std::max(0.0, before_mm - reach_mm), before_mm};
  const Stretch taken_after{0.0, std::min(reach_mm, after_mm)};
  std::array<Position, kPlaces + 1> places{};
  Departure largest;
  double w_largest = 0.0;
  const auto look = [&](double w) {
    const Position point = blend.curve.at(blend.curve.s_at(w));
    const double behind_mm = way_mm * (1.0 - w) * (1.0 - w) * (1.0 - w);
    const double away_mm =
        std::min(distance_mm(*corner.before, point, before_mm - behind_mm, taken_before),
                 distance_mm(*corner.after, point, way_mm * w * w * w, taken_after));
    if (away_mm > largest.distance_mm) {
      largest = {.distance_mm = away_mm, .at_mm = point};
      w_largest = w;
    }
    return point;
  };
  for (int k = 0; k <= kPlaces; ++k) {
    places[static_cast<std::size_t>(k)] = look(static_cast<double>(k) / kPlaces);
  }
  for (double beside = 0.5 / kPlaces; beside > kFinest; beside *= 0.5) {
    const double w = w_largest;
    look(std::max(w - beside, 0.0));
    look(std::min(w + beside, 1.0));
  }
  for (const bool behind : {false, true}) {
    Departure farthest;
    double share_farthest = 0.0;
    const auto look_from = [&](double share) {
      const Departure away =
          from_blend(behind ? curves::position_at(*corner.after, share * way_mm)
                            : curves::position_at(*corner.before, before_mm - share * way_mm),
                     places);
      if (away.distance_mm > farthest.distance_mm) {
        farthest = away;
        share_farthest = share;
      }
    };
    for (int k = 0; k <= kPlaces; ++k) {
      look_from(static_cast<double>(k) / kPlaces);
    }
    for (double beside = 0.5 / kPlaces; beside > kFinestOfPath; beside *= 0.5) {
      const double share = share_farthest;
      look_from(std::max(share - beside, 0.0));
      look_from(std::min(share + beside, 1.0));
    }
    largest.widen(farthest);
  }
  return largest;
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
