#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "smoothing/blend.hpp"

namespace kerf::smoothing {

using curves::PathDerivatives;
using curves::Position;
using curves::Stretch;
using curves::vec;

namespace {

constexpr int kPlaces = 32;             // of a blend, where its deviation is looked at
constexpr double kFinest = 1.0 / 256;   // between them, around the farthest: 3e-5 of it are missed
constexpr double kFinestOfPath = 1e-5;  // merged lines may turn as sharply as a needle there
constexpr int kProjections = 4;
constexpr double kNearEnough = 1e-9;  // of what the nearest point is looked for on
constexpr double kReach = 1.5;        // of the way, within which the nearest point of a curve lies

// The nearest point of a path, by Newton's method from a place close to it, and its distance.
template <typename PathAt>
PathDeviation nearest_on(const PathAt& path_at, const Position& point, double s_mm,
                         const Stretch& within) {
  double s = std::clamp(s_mm, within.begin_mm, within.end_mm);
  PathDeviation nearest{.distance_mm = std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= kProjections; ++i) {
    const PathDerivatives path = path_at(s);
    const Eigen::Vector3d away = vec(point) - vec(path.position_mm);
    if (away.norm() < nearest.distance_mm) {
      nearest = {.distance_mm = away.norm(), .at_mm = path.position_mm};
    }
    const double slope = 1.0 - away.dot(vec(path.second_per_mm));
    const double to = std::clamp(s + away.dot(vec(path.first)) / std::max(slope, 0.5),
                                 within.begin_mm, within.end_mm);
    if (std::abs(to - s) <= kNearEnough * (within.end_mm - within.begin_mm)) {
      break;
    }
    s = to;
  }
  return nearest;
}

double distance_mm(const curves::Curve& curve, const Position& point, double s_mm,
                   const Stretch& within) {
  return nearest_on([&](double s) { return curves::derivatives_at(curve, s); }, point, s_mm, within)
      .distance_mm;
}

struct Place {
  double s_mm = 0.0;
  Position at_mm{};
};
using Places = std::array<Place, kPlaces + 1>;

// Where on the chords of places close together the nearest point of the blend is.
double s_nearest_mm(const Position& point, const Places& places) {
  double nearest_mm2 = std::numeric_limits<double>::infinity();
  double s_mm = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const Eigen::Vector3d chord = vec(places[k].at_mm) - vec(places[k - 1].at_mm);
    const Eigen::Vector3d seen = vec(point) - vec(places[k - 1].at_mm);
    const double squared = chord.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(seen.dot(chord) / squared, 0.0, 1.0) : 0.0;
    const double away_mm2 = (seen - share * chord).squaredNorm();
    if (away_mm2 < nearest_mm2) {
      nearest_mm2 = away_mm2;
      s_mm = places[k - 1].s_mm + share * (places[k].s_mm - places[k - 1].s_mm);
    }
  }
  return s_mm;
}

// Of the programmed path that a blend takes the place of, by the share of its way; the place is the
// blend's.
template <typename Programmed>
PathDeviation farthest_from_blend(const Programmed& programmed_at, const Places& places,
                                  const curves::NurbsCurve& curve) {
  PathDeviation farthest;
  double share_farthest = 0.0;
  const auto look = [&](double share) {
    const Position point = programmed_at(share);
    const PathDeviation away =
        nearest_on([&](double s) { return curve.derivatives_at(s); }, point,
                   s_nearest_mm(point, places), {.begin_mm = 0.0, .end_mm = curve.length_mm()});
    if (away.distance_mm > farthest.distance_mm) {
      farthest = away;
      share_farthest = share;
    }
  };
  for (int k = 0; k <= kPlaces; ++k) {
    look(static_cast<double>(k) / kPlaces);
  }
  double beside = 0.5 / kPlaces;
  while (beside > kFinestOfPath) {
    const double middle = share_farthest;
    look(std::max(middle - beside, 0.0));
    look(std::min(middle + beside, 1.0));
    beside *= 0.5;
  }
  return farthest;
}

}  // namespace

PathDeviation deviation_of(const Blend& blend, const Corner& corner, double way_mm) {
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
  const bool tangential = is_tangential(corner, way_mm);
  Places places{};
  PathDeviation largest;
  double w_largest = 0.0;
  const auto look = [&](double w) {
    const double s_mm = blend.curve.s_at(w);
    const Position point = blend.curve.at(s_mm);
    // About where it would be on each curve.
    const double to_go_mm = way_mm * (tangential ? 1.0 - 2.0 * w : std::pow(1.0 - w, 3));
    const double gone_mm = way_mm * (tangential ? 2.0 * w - 1.0 : w * w * w);
    const double away_mm =
        std::min(distance_mm(*corner.before, point, before_mm - to_go_mm, taken_before),
                 distance_mm(*corner.after, point, gone_mm, taken_after));
    if (away_mm > largest.distance_mm) {
      largest = {.distance_mm = away_mm, .at_mm = point};
      w_largest = w;
    }
    return Place{.s_mm = s_mm, .at_mm = point};
  };
  for (int k = 0; k <= kPlaces; ++k) {
    places[static_cast<std::size_t>(k)] = look(static_cast<double>(k) / kPlaces);
  }
  double beside = 0.5 / kPlaces;
  while (beside > kFinest) {
    const double w = w_largest;
    look(std::max(w - beside, 0.0));
    look(std::min(w + beside, 1.0));
    beside *= 0.5;
  }
  for (const bool behind : {false, true}) {
    const PathDeviation farthest = farthest_from_blend(
        [&](double share) {
          return behind ? curves::position_at(*corner.after, share * way_mm)
                        : curves::position_at(*corner.before, before_mm - share * way_mm);
        },
        places, blend.curve);
    largest = larger(largest, farthest);
  }
  return largest;
}

}  // namespace kerf::smoothing
