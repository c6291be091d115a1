#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

// Of the jerk's ramp: at the most, and where the feedrate rises for twice as long as a ramp takes.
constexpr double kMaxOfRamp = 0.5;
constexpr double kOfRamp = 0.08;
// What curvature takes of the limits may change by so much over a cell; of a turn by an angle so
// many times that angle.
constexpr double kChange = 0.5;
constexpr double kOfAngle = 4.0;
constexpr double kFlat = 1e-6;

}  // namespace

double change_mm(const Cell& cell, const StartState& motion, const PlanLimits& limits) {
  const double v2 = motion.v_mm_s * motion.v_mm_s;
  double most = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const MotionLimits& axis = limits.axes[k];
    const double second = std::abs(cell.end.second_per_mm[k] - cell.begin.second_per_mm[k]);
    const double third = std::abs(cell.end.third_per_mm2[k] - cell.begin.third_per_mm2[k]);
    const double a = std::min(motion.a_mm_s2, axis.acceleration_mm_s2);
    most = std::max({most, second * v2 / axis.acceleration_mm_s2,
                     (third * v2 + 3.0 * second * a) * motion.v_mm_s / axis.jerk_mm_s3});
  }
  const double turn = std::max(curves::vec(cell.begin.second_per_mm).norm(),
                               curves::vec(cell.end.second_per_mm).norm());
  return kChange / (most / cell.length_mm + kOfAngle * turn);
}

std::vector<double> legs_of(const std::vector<Cell>& cells, const std::vector<double>& feeds_mm_s) {
  std::vector<double> times(cells.size(), 0.0);
  const auto trend_of = [&](std::size_t i) {
    const double rise = feeds_mm_s[i + 1] - feeds_mm_s[i];
    return std::abs(rise) <= kFlat * feeds_mm_s[i] ? 0 : (rise > 0.0 ? 1 : -1);
  };
  for (std::size_t first = 0, end = 0; first < cells.size(); first = end) {
    const int trend = trend_of(first);
    double sum = 0.0;
    for (end = first; end < cells.size() && trend_of(end) == trend; ++end) {
      sum += 2.0 * cells[end].length_mm / (feeds_mm_s[end] + feeds_mm_s[end + 1]);
    }
    std::fill(times.begin() + static_cast<std::ptrdiff_t>(first),
              times.begin() + static_cast<std::ptrdiff_t>(end), sum);
  }
  return times;
}

double cell_time_s(double leg_s, double jerk_time_s) {
  const double ramp = std::min(jerk_time_s, 0.5 * leg_s);
  return std::min(kMaxOfRamp * ramp, kOfRamp * 0.5 * leg_s);
}

}  // namespace kerf::lookahead
