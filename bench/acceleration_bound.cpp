#include "bench/acceleration_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "curves/curve.hpp"

namespace kerf::bench {

namespace {

constexpr std::size_t kCells = 20'000;
constexpr int kHalvings = 50;

// An axis: a = along * a_t + across * v^2.
struct AxisTerm {
  double along = 0.0;          // q'
  double across_per_mm = 0.0;  // q''
  double most_mm_s2 = 0.0;
};

struct Place {
  double most_squared = 0.0;
  double most_mm_s2 = 0.0;  // along the path
  std::array<AxisTerm, 3> axes{};
};

struct Accelerations {
  double low_mm_s2 = 0.0;
  double high_mm_s2 = 0.0;
};

// How fast a chord of a tick stays within the tolerance of an arc.
double chord_feedrate_mm_s(double curvature_per_mm, const lookahead::PlanLimits& limits) {
  const double d = limits.chord_tolerance_mm;
  const double left = 2.0 * d / curvature_per_mm - d * d;
  return curvature_per_mm > 0.0 && left > 0.0 ? 2.0 / limits.period_s * std::sqrt(left)
                                              : lookahead::kUnbounded;
}

Place place_at(const lookahead::Block& block, double s_mm, const lookahead::PlanLimits& limits) {
  const curves::PathDerivatives at = curves::derivatives_at(block.curve, s_mm);
  Place place{.most_mm_s2 = limits.path.acceleration_mm_s2};
  double most_mm_s = std::min(block.feedrate_mm_s, limits.path.velocity_mm_s);
  double curvature_squared = 0.0;
  for (std::size_t k = 0; k < place.axes.size(); ++k) {
    const double along = at.first[k];
    const double across = at.second_per_mm[k];
    place.axes[k] = {along, across, limits.axes[k].acceleration_mm_s2};
    most_mm_s = std::min(most_mm_s, limits.axes[k].velocity_mm_s / std::abs(along));
    curvature_squared += across * across;
  }
  most_mm_s = std::min(most_mm_s, chord_feedrate_mm_s(std::sqrt(curvature_squared), limits));
  place.most_squared = most_mm_s * most_mm_s;
  return place;
}

// Along the path, at that v^2. None: low is above high.
Accelerations accelerations_at(const Place& place, double v_squared) {
  Accelerations both{-place.most_mm_s2, place.most_mm_s2};
  for (const AxisTerm& axis : place.axes) {
    const double across_mm_s2 = axis.across_per_mm * v_squared;
    if (axis.along == 0.0) {
      if (std::abs(across_mm_s2) > axis.most_mm_s2) {
        return {1.0, -1.0};
      }
      continue;
    }
    const double one = (axis.most_mm_s2 - across_mm_s2) / axis.along;
    const double other = (-axis.most_mm_s2 - across_mm_s2) / axis.along;
    both.low_mm_s2 = std::max(both.low_mm_s2, std::min(one, other));
    both.high_mm_s2 = std::min(both.high_mm_s2, std::max(one, other));
  }
  return both;
}

// The largest v^2 from which the next place is reached at no more than that of it: those that do
// are an interval from 0 on.
double largest_before(const Place& place, double next_squared, double cell_mm) {
  const auto reaches = [&](double v_squared) {
    const Accelerations both = accelerations_at(place, v_squared);
    const double least = std::max(both.low_mm_s2, -0.5 * v_squared / cell_mm);
    return least <= both.high_mm_s2 && v_squared + 2.0 * cell_mm * least <= next_squared;
  };
  if (reaches(place.most_squared)) {
    return place.most_squared;
  }
  double low = 0.0;
  double high = place.most_squared;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (reaches(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

double AnyJerkMotion::v_squared_at(double s_mm) const {
  const double cells = s_mm / cell_mm;
  const std::size_t cell =
      std::min(static_cast<std::size_t>(std::max(cells, 0.0)), v_squared.size() - 2);
  return std::lerp(v_squared[cell], v_squared[cell + 1], cells - static_cast<double>(cell));
}

AnyJerkMotion any_jerk_motion(const lookahead::Block& block, const lookahead::PlanLimits& limits) {
  AnyJerkMotion motion;
  motion.cell_mm = block.length_mm / kCells;
  std::vector<Place> places;
  for (std::size_t i = 0; i <= kCells; ++i) {
    places.push_back(place_at(block, motion.cell_mm * static_cast<double>(i), limits));
  }
  std::vector<double> most_squared(places.size());
  for (std::size_t i = kCells; i > 0; --i) {
    most_squared[i - 1] = largest_before(places[i - 1], most_squared[i], motion.cell_mm);
  }
  motion.v_squared.push_back(0.0);
  for (std::size_t i = 0; i < kCells; ++i) {
    const double before = motion.v_squared.back();
    const double steepest = accelerations_at(places[i], before).high_mm_s2;
    const double next = std::min(most_squared[i + 1], before + 2.0 * motion.cell_mm * steepest);
    motion.time_s += 2.0 * motion.cell_mm / (std::sqrt(before) + std::sqrt(next));
    motion.v_squared.push_back(next);
  }
  return motion;
}

}  // namespace kerf::bench
