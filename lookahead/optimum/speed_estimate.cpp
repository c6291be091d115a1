#include "lookahead/optimum/speed_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kerf::lookahead {

namespace {

// The weakest axis in a direction, or the path.
double weakest(double along, const CellEnd& end, const PlanLimits& limits,
               double MotionLimits::*limit) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (end.first[k] != 0.0) {
      along = std::min(along, limits.axes[k].*limit / std::abs(end.first[k]));
    }
  }
  return along;
}

// v^2 at a distance from rest under a jerk: s = J t^3 / 6, v = J t^2 / 2.
double rest_feed_mm_s(double jerk_mm_s3, double distance_mm) {
  const double root = std::cbrt(6.0 * distance_mm);
  return 0.5 * std::cbrt(jerk_mm_s3) * root * root;
}

}  // namespace

double tangential_acceleration_mm_s2(const Cell& cell, const CellEnd& end,
                                     const PlanLimits& limits) {
  return cell.shares.acceleration *
         weakest(cell.along.acceleration_mm_s2, end, limits, &MotionLimits::acceleration_mm_s2);
}

double tangential_jerk_mm_s3(const Cell& cell, const CellEnd& end, const PlanLimits& limits) {
  return cell.shares.jerk * weakest(cell.along.jerk_mm_s3, end, limits, &MotionLimits::jerk_mm_s3);
}

double turning_feedrate_mm_s(const Cell& cell, const CellEnd& end, const PlanLimits& limits) {
  double v = cell.shares.feedrate * end.feedrate_mm_s;
  for (std::size_t k = 0; k < 3; ++k) {
    const MotionLimits& axis = limits.axes[k];
    const double q2 = std::abs(end.second_per_mm[k]);
    const double q3 = std::abs(end.third_per_mm2[k]);
    if (q2 > 0.0) {
      v = std::min(v, std::sqrt(cell.shares.acceleration * axis.acceleration_mm_s2 / q2));
    }
    if (q3 > 0.0) {
      v = std::min(v, std::cbrt(cell.shares.jerk * axis.jerk_mm_s3 / q3));
    }
  }
  return v;
}

std::vector<double> estimate_feeds(std::span<const Cell> cells, const EndFeeds& ends,
                                   const PlanLimits& limits) {
  const std::size_t count = cells.size();
  std::vector<double> squared(count + 1, kUnbounded);
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = turning_feedrate_mm_s(cells[i], cells[i].begin, limits);
    const double end = turning_feedrate_mm_s(cells[i], cells[i].end, limits);
    squared[i] = std::min(squared[i], begin * begin);
    squared[i + 1] = end * end;
  }
  squared.front() = std::min(squared.front(), ends.v_begin_mm_s * ends.v_begin_mm_s);
  squared.back() = std::min(squared.back(), ends.v_end_mm_s * ends.v_end_mm_s);
  const auto pass = [&](std::size_t from, std::size_t to, const Cell& cell, const CellEnd& end,
                        double& distance_mm) {
    distance_mm += cell.length_mm;
    const double a = tangential_acceleration_mm_s2(cell, end, limits);
    squared[to] = std::min(squared[to], squared[from] + 2.0 * a * cell.length_mm);
    if (std::isfinite(distance_mm)) {
      const double v = rest_feed_mm_s(tangential_jerk_mm_s3(cell, end, limits), distance_mm);
      squared[to] = std::min(squared[to], v * v);
    }
  };
  double distance = ends.v_begin_mm_s == 0.0 ? 0.0 : kUnbounded;
  for (std::size_t i = 0; i < count; ++i) {
    pass(i, i + 1, cells[i], cells[i].begin, distance);
  }
  distance = ends.v_end_mm_s == 0.0 ? 0.0 : kUnbounded;
  for (std::size_t i = count; i-- > 0;) {
    pass(i + 1, i, cells[i], cells[i].end, distance);
  }
  for (double& v : squared) {
    v = std::sqrt(v);
  }
  return squared;
}

}  // namespace kerf::lookahead
