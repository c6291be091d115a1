#include "lookahead/optimum/limit_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "profiles/cell_law.hpp"

namespace kerf::lookahead {

namespace {

constexpr std::array kPlaces = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};  // shares of a cell

// The ends from within the cell: derivatives may jump there.
CellEnd path_in(const Cell& cell, double share, double s_mm, const PathAt& path) {
  if (share == 0.0 || share == 1.0) {
    return share == 0.0 ? cell.begin : cell.end;
  }
  return path(cell, cell.s_begin_mm + s_mm);
}

// What is not a number is beyond every limit.
void grow(double& worst, double share) {
  if (!(share <= worst)) {
    worst = std::isnan(share) ? kUnbounded : share;
  }
}

void look_at(const profiles::PathMotion& motion, const Cell& cell, const CellEnd& path,
             const PlanLimits& limits, Excess& worst) {
  const double v = motion.v_mm_s;
  const double a = motion.a_mm_s2;
  const double j = motion.j_mm_s3;
  grow(worst.feedrate, v / path.feedrate_mm_s);
  grow(worst.acceleration,
       std::abs(a) / (cell.allowed.acceleration * cell.along.acceleration_mm_s2));
  grow(worst.jerk, std::abs(j) / (cell.allowed.jerk * cell.along.jerk_mm_s3));
  for (std::size_t k = 0; k < 3; ++k) {
    const double q1 = path.first[k];
    const double q2 = path.second_per_mm[k];
    const double q3 = path.third_per_mm2[k];
    grow(worst.acceleration, std::abs(q1 * a + q2 * v * v) /
                                 (cell.allowed.acceleration * limits.axes[k].acceleration_mm_s2));
    grow(worst.jerk, std::abs(q1 * j + 3.0 * q2 * v * a + q3 * v * v * v) /
                         (cell.allowed.jerk * limits.axes[k].jerk_mm_s3));
  }
}

}  // namespace

double Excess::largest() const noexcept {
  return std::max({feedrate, acceleration, jerk});
}

Excess excess_of(const Cell& cell, const SquaredFeed& begin, const PathAt& path,
                 const PlanLimits& limits) {
  Excess worst;
  const auto look = [&](double place) {
    const double s = place * cell.length_mm;
    const double slope = begin.slope + begin.bend * s;
    const double b = begin.value + s * (begin.slope + 0.5 * begin.bend * s);
    const double v = std::sqrt(std::max(b, 0.0));
    look_at({.s_mm = s, .v_mm_s = v, .a_mm_s2 = 0.5 * slope, .j_mm_s3 = 0.5 * v * begin.bend}, cell,
            path_in(cell, place, s, path), limits, worst);
  };
  std::for_each(kPlaces.begin(), kPlaces.end(), look);
  const double peak = -begin.slope / (begin.bend * cell.length_mm);  // of the feedrate
  if (begin.bend < 0.0 && peak > 0.0 && peak < 1.0) {
    look(peak);
  }
  return worst;
}

Excess excess_of_rest(const Cell& cell, double v_mm_s, bool launch, const PathAt& path,
                      const PlanLimits& limits) {
  const profiles::CellLaw law = launch ? profiles::CellLaw::launch(v_mm_s, cell.length_mm)
                                       : profiles::CellLaw::landing(v_mm_s, cell.length_mm);
  Excess worst;
  for (const double place : kPlaces) {
    const profiles::PathMotion motion = law.at(place * law.duration_s());
    look_at(motion, cell, path_in(cell, place, motion.s_mm, path), limits, worst);
  }
  return worst;
}

}  // namespace kerf::lookahead
