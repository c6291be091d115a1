#include "lookahead/optimum/grid/speed_estimate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace kerf::lookahead {

namespace {

// The feedrate at a distance from where it was v0 and acceleration 0, under a jerk J:
// d = v0 t + J t^3 / 6, v = v0 + J t^2 / 2. The cubic has one real root.
double ramp_feed_mm_s(double v_begin_mm_s, double jerk_mm_s3, double distance_mm) {
  const double q = 3.0 * distance_mm / jerk_mm_s3;
  const double p = 2.0 * v_begin_mm_s / jerk_mm_s3;
  const double root = std::sqrt(p);
  const double t = p * root < 1e-9 * q ? std::cbrt(2.0 * q)
                                       : 2.0 * root * std::sinh(std::asinh(q / (p * root)) / 3.0);
  return v_begin_mm_s + 0.5 * jerk_mm_s3 * t * t;
}

// A rise under a constant jerk: begun with no acceleration at some feedrate, so far ago.
struct Rise {
  double v_begin_mm_s = 0.0;
  double distance_mm = 0.0;

  // What has this feedrate and acceleration now.
  static Rise at(double v_mm_s, double a_mm_s2, double jerk_mm_s3) {
    const double a = std::min(a_mm_s2, std::sqrt(2.0 * jerk_mm_s3 * v_mm_s));
    const double t = a / jerk_mm_s3;
    const double v = v_mm_s - 0.5 * a * t;
    return {.v_begin_mm_s = v, .distance_mm = t * (v + a * t / 6.0)};
  }
};

enum class Direction { forwards, backwards };

// What of a cell bounds a rise over it.
struct CellBounds {
  double length_mm = 0.0;
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;
};

// How far a rise has come when it reaches a feedrate.
double distance_to_mm(const Rise& rise, double v_mm_s, const CellBounds& cell) {
  const double dv = v_mm_s - rise.v_begin_mm_s;
  return dv > 0.0 ? std::sqrt(2.0 * dv / cell.jerk_mm_s3) * (rise.v_begin_mm_s + dv / 3.0) : 0.0;
}

// Bends the squared feedrate at the end of a cell to what is reached from that at its begin.
void bend(double from, const CellBounds& cell, Rise& rise, double& to) {
  const auto [h, a, j] = cell;
  rise.distance_mm += h;
  const double accelerated = from + 2.0 * a * h;
  const double v_to = std::sqrt(to);
  if (to <= accelerated && distance_to_mm(rise, v_to, cell) <= rise.distance_mm) {
    rise = Rise::at(v_to, std::clamp(0.5 * (to - from) / h, 0.0, a), j);
    return;
  }
  const double v = ramp_feed_mm_s(rise.v_begin_mm_s, j, rise.distance_mm);
  if (accelerated < v * v) {
    rise = Rise::at(std::sqrt(accelerated), a, j);
  }
  to = std::min(accelerated, v * v);
}

// Bends what rises more than acceleration and jerk allow, seen in one direction.
void pass(std::span<const Cell> cells, Direction direction, const PlanLimits& limits,
          std::vector<double>& squared) {
  const bool forwards = direction == Direction::forwards;
  const std::size_t count = cells.size();
  Rise rise;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = forwards ? k : count - 1 - k;
    const Cell& cell = cells[i];
    const PathSample& end = forwards ? cell.begin : cell.end;
    const double from = squared[forwards ? i : i + 1];
    if (k == 0) {
      rise = {.v_begin_mm_s = std::sqrt(from), .distance_mm = 0.0};
    }
    bend(from,
         {.length_mm = cell.length_mm,
          .acceleration_mm_s2 = tangential_acceleration_mm_s2(cell, end, limits),
          .jerk_mm_s3 = tangential_jerk_mm_s3(cell, end, limits)},
         rise, squared[forwards ? i + 1 : i]);
  }
}

}  // namespace

double tangential_acceleration_mm_s2(const Cell& cell, const curves::PathDerivatives& end,
                                     const PlanLimits& limits) {
  return cell.shares.acceleration * weakest_along(cell.along.acceleration_mm_s2, end, limits,
                                                  &MotionLimits::acceleration_mm_s2);
}

double tangential_jerk_mm_s3(const Cell& cell, const curves::PathDerivatives& end,
                             const PlanLimits& limits) {
  return cell.shares.jerk *
         weakest_along(cell.along.jerk_mm_s3, end, limits, &MotionLimits::jerk_mm_s3);
}

double curvature_feedrate_mm_s(const Cell& cell, const PathSample& end, const PlanLimits& limits) {
  double v = cell.shares.feedrate * end.feedrate_mm_s;
  double squared = kUnbounded;
  double cubed = kUnbounded;
  for (std::size_t k = 0; k < 3; ++k) {
    const MotionLimits& axis = limits.axes[k];
    const double jerk = cell.shares.jerk * axis.jerk_mm_s3;
    const double q2 = std::abs(end.second_per_mm[k]);
    const double q3 = std::abs(end.third_per_mm2[k]);
    if (q2 > 0.0) {
      squared = std::min(squared, cell.shares.acceleration * axis.acceleration_mm_s2 / q2);
    }
    if (q3 > 0.0) {
      cubed = std::min(cubed, jerk / q3);
    }
    if (cell.jumps_per_mm_s[k] > 0.0) {
      squared = std::min(squared, jerk / cell.jumps_per_mm_s[k]);
    }
  }
  if (squared < v * v) {
    v = std::sqrt(squared);
  }
  return cubed < v * v * v ? std::cbrt(cubed) : v;
}

std::vector<double> estimate_feeds(std::span<const Cell> cells, const EndFeeds& ends,
                                   const PlanLimits& limits) {
  assert(!cells.empty());
  const std::size_t count = cells.size();
  std::vector<double> squared(count + 1, kUnbounded);
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = curvature_feedrate_mm_s(cells[i], cells[i].begin, limits);
    const double end = curvature_feedrate_mm_s(cells[i], cells[i].end, limits);
    squared[i] = std::min(squared[i], begin * begin);
    squared[i + 1] = end * end;
  }
  squared.front() = std::min(squared.front(), ends.v_begin_mm_s * ends.v_begin_mm_s);
  squared.back() = std::min(squared.back(), ends.v_end_mm_s * ends.v_end_mm_s);
  pass(cells, Direction::forwards, limits, squared);
  pass(cells, Direction::backwards, limits, squared);
  for (double& v : squared) {
    v = std::sqrt(v);
  }
  return squared;
}

}  // namespace kerf::lookahead
