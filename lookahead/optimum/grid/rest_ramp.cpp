#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kCellTicks = 1.0;
// Of a cell over its distance from the rest: a tick long, but within these.
constexpr double kGrowth = 0.08;
constexpr double kRampGrowth = 0.2;
// Shares of a ramp from rest to the feedrate allowed, and of all the way, that a cell takes at
// most.
constexpr double kRampStep = 0.05;
constexpr double kWayStep = 1.0 / 40.0;
// The launch lasts no longer than so many ticks and such shares.
constexpr double kLaunchTicks = 12.0;
constexpr double kLaunchSteps = 6.0;
constexpr double kLaunchOfRise = 0.5;  // of the time in which the jerk builds the acceleration up
constexpr double kFirstOfCell = 0.2;
// Bound the number of parts, and keep what is at their ends apart.
constexpr double kShortestOfCell = 1e-6;
constexpr double kShortest_mm = 1e-11;

struct RestRamp {
  double jerk_mm_s3 = 0.0;
  double feedrate_mm_s = 0.0;
  double step_s = 0.0;
  double launch_s = 0.0;

  [[nodiscard]] double first_mm() const {
    const double t = launch_s;
    return jerk_mm_s3 * t * t * t / 6.0;
  }
  // How long a cell at this distance from the rest may be.
  [[nodiscard]] double cell_mm(double distance_mm) const {
    const double root = std::cbrt(6.0 * distance_mm);
    const double v = 0.5 * std::cbrt(jerk_mm_s3) * root * root;
    return std::clamp(std::min(v, feedrate_mm_s) * step_s, kGrowth * distance_mm,
                      kRampGrowth * distance_mm);
  }
};

// From rest to rest over a length under a jerk alone takes this long: four ramps, v = J t^2 / 16.
double from_rest_to_rest_s(double length_mm, double jerk_mm_s3) {
  return std::cbrt(32.0 * length_mm / jerk_mm_s3);
}

RestRamp rest_ramp(const std::vector<Cell>& cells, RestAt where, const PlanLimits& limits) {
  const Cell& cell = cells.front();
  const PathSample& end = where == RestAt::begin ? cell.begin : cell.end;
  const double jerk = tangential_jerk_mm_s3(cell, end, limits);
  const double v = curvature_feedrate_mm_s(cell, end, limits);
  double length = 0.0;
  for (const Cell& each : cells) {
    length += each.length_mm;
  }
  const double of_ramp_s = kRampStep * std::sqrt(2.0 * v / jerk);
  const double of_way_s = kWayStep * from_rest_to_rest_s(length, jerk);
  const double rise_s = tangential_acceleration_mm_s2(cell, end, limits) / jerk;
  return {
      .jerk_mm_s3 = jerk,
      .feedrate_mm_s = v,
      .step_s = std::min({kCellTicks * limits.period_s, of_ramp_s, of_way_s}),
      .launch_s = std::min({kLaunchTicks * limits.period_s,
                            kLaunchSteps * std::min(of_ramp_s, of_way_s), kLaunchOfRise * rise_s})};
}

// How a cell is to be divided. distances: of its ends from the rest.
std::vector<double> lengths_between(const RestRamp& ramp, const curves::Stretch& distances) {
  const double to_mm = distances.end_mm;
  std::vector<double> lengths;
  double d = distances.begin_mm;
  while (d < to_mm) {
    const double h =
        d == 0.0 ? std::min(std::max({ramp.first_mm(), kShortestOfCell * to_mm, kShortest_mm}),
                            kFirstOfCell * to_mm)
                 : ramp.cell_mm(d);
    const bool last = to_mm - d < 1.5 * h;
    lengths.push_back(last ? to_mm - d : h);
    d = last ? to_mm : d + h;
  }
  return lengths;
}

}  // namespace

void refine_to_rest(std::vector<Cell>& cells, RestAt where, const PathAt& path,
                    const PlanLimits& limits) {
  assert(!cells.empty());
  if (where == RestAt::end) {
    std::reverse(cells.begin(), cells.end());
  }
  const RestRamp ramp = rest_ramp(cells, where, limits);
  std::vector<Cell> refined;
  refined.reserve(cells.size());
  double distance = 0.0;
  for (const Cell& cell : cells) {
    const double end = distance + cell.length_mm;
    std::vector<double> lengths = lengths_between(ramp, {distance, end});
    distance = end;
    if (lengths.size() == 1) {
      refined.push_back(cell);
      continue;
    }
    if (where == RestAt::end) {
      std::reverse(lengths.begin(), lengths.end());
    }
    const std::size_t first = refined.size();
    for (Cell& part : parts_of(cell, lengths, path)) {
      part.continues = refined.size() > first ? where == RestAt::end : cell.continues;
      refined.push_back(part);
    }
    if (where == RestAt::end) {
      std::reverse(refined.begin() + static_cast<std::ptrdiff_t>(first), refined.end());
    }
  }
  cells = std::move(refined);
  if (where == RestAt::end) {
    std::reverse(cells.begin(), cells.end());
  }
}

}  // namespace kerf::lookahead
