#include <algorithm>
#include <cmath>

#include "lookahead/optimum/grid/cell_stops.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

namespace {

// A cell that begins so near the zone's end lies beyond it: cells do not end to the last digit
// where they are asked to.
constexpr double kNearEnd = 0.99;

void bind(const SubTickZone& zone, Cell& cell) {
  cell.sub_tick_mm_s = std::min(cell.sub_tick_mm_s, zone.feedrate_mm_s);
  cell.begin.bind_feedrate(cell.sub_tick_mm_s, Constraint::chord_error);
  cell.end.bind_feedrate(cell.sub_tick_mm_s, Constraint::chord_error);
}

// The most that a tick from the junction on is faster than the junction, in its mean. What passes
// the junction at v has no more acceleration there than has come up under the jerk since it was at
// rest.
double gain_in_tick_mm_s(const SubTickBlock& sub_tick, const PlanLimits& limits) {
  const Cell cell{.along = sub_tick.beside.along.ramp};
  const double a = tangential_acceleration_mm_s2(cell, sub_tick.junction, limits);
  const double j = tangential_jerk_mm_s3(cell, sub_tick.junction, limits);
  const double t = limits.period_s;
  return std::min(0.5 * a * t,
                  0.5 * std::sqrt(2.0 * j * sub_tick.v_junction_mm_s) * t + j * t * t / 6.0);
}

}  // namespace

SubTickZone sub_tick_zone(const SubTickBlock& sub_tick, const PlanLimits& limits) {
  const double bound = sub_tick_feedrate_mm_s(sub_tick.curve, limits);
  if (!(sub_tick.v_junction_mm_s + gain_in_tick_mm_s(sub_tick, limits) > bound)) {
    return {};
  }
  return {.feedrate_mm_s = bound, .length_mm = bound * limits.period_s};
}

void bind_zones(const SubTickZones& zones, std::vector<Cell>& cells) {
  const double length = cells.back().s_end_mm();
  for (Cell& cell : cells) {
    if (cell.s_begin_mm < kNearEnd * zones.begin.length_mm) {
      bind(zones.begin, cell);
    }
    if (length - cell.s_end_mm() < kNearEnd * zones.end.length_mm) {
      bind(zones.end, cell);
    }
  }
}

}  // namespace kerf::lookahead
