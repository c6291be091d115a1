#include "lookahead/optimum/grid/cell_stops.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

constexpr int kCrowdRounds = 8;
constexpr double kJustBeyond = 1.0 + 1e-6;
constexpr double kZoneSlack = 0.2;

// Within a curve nothing jumps along the path.
PlanLimits of_axes(PlanLimits limits) {
  limits.path.acceleration_mm_s2 = limits.path.jerk_mm_s3 = kUnbounded;
  return limits;
}

double zone_at(const BlockPath& path, double s_mm, const JunctionLimits& junction,
               const PlanLimits& limits) {
  return kJustBeyond * zone_mm(Cell{.along = path.along()}, path.at(s_mm), junction, limits);
}

// The slower a jump is passed, the fewer others are within its ticks.
JunctionLimits inner_junction(const BlockPath& path, double s_mm, Jump jump,
                              const std::vector<BlockPath::Break>& breaks,
                              const PlanLimits& limits) {
  const PathSample here = path.at(s_mm);
  jump.allowed_mm_s = curvature_feedrate_mm_s(Cell{.along = path.along()}, here, limits);
  JunctionLimits junction;
  for (int i = 0; i < kCrowdRounds; ++i) {
    junction = junction_limits_of(jump, of_axes(limits));
    const double zone = zone_at(path, s_mm, junction, limits);
    const auto crowd = std::count_if(breaks.begin(), breaks.end(), [&](const auto& other) {
      return other.jump && std::abs(other.s_mm - s_mm) < zone;
    });
    if (crowd <= jump.crowd) {
      break;
    }
    jump.crowd = static_cast<int>(crowd);
  }
  return junction;
}

// Where the zones of three ticks beside the stops' jumps end.
void append_ends_of_zones(const BlockPath& path, const PlanLimits& limits,
                          std::vector<CellStop>& stops) {
  const std::size_t count = stops.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!stops[i].junction) {
      continue;
    }
    const double s = stops[i].s_mm;
    const double zone = zone_at(path, s, *stops[i].junction, limits);
    for (const double end : {s - zone, s + zone}) {
      if (end > 0.0 && end < path.length_mm()) {
        stops.push_back({.s_mm = end, .slack_mm = kZoneSlack * zone});
      }
    }
  }
}

}  // namespace

std::vector<CellStop> cell_stops(const BlockPath& path, const EndJunctions& ends,
                                 const PlanLimits& limits) {
  const std::vector<BlockPath::Break> breaks = path.breaks();
  std::vector<CellStop> stops{{.s_mm = 0.0, .junction = ends.begin}};
  for (const BlockPath::Break& place : breaks) {
    CellStop& stop = stops.emplace_back(CellStop{
        .s_mm = place.s_mm, .rest = place.rest, .slack_mm = place.valley ? kUnbounded : 0.0});
    if (place.jump) {
      stop.junction = inner_junction(path, place.s_mm, *place.jump, breaks, limits);
    }
  }
  for (const double s : {ends.zones.begin.length_mm, path.length_mm() - ends.zones.end.length_mm}) {
    if (s > 0.0 && s < path.length_mm()) {
      stops.push_back({.s_mm = s});
    }
  }
  stops.push_back({.s_mm = path.length_mm(), .junction = ends.end});
  append_ends_of_zones(path, limits, stops);
  std::ranges::sort(stops, {}, &CellStop::s_mm);
  return stops;
}

}  // namespace kerf::lookahead
