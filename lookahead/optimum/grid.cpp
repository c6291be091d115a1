#include "lookahead/optimum/grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lookahead/optimum/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

// Of the estimated motion that a cell lasts, on a curve and where only the motion changes.
constexpr double kCellTicks = 1.0;
constexpr double kPlainCellTicks = 1.5;
constexpr double kGrowth = 0.08;  // of a cell over its distance from where something happens
// Turning takes part in the limits where it takes this share of one.
constexpr double kTurning = 0.05;
// Of a cell over the radius, the shortest that a piece asks for in ticks and pieces, and how fast
// cells grow beside it.
constexpr double kOfRadius = 0.15;
constexpr double kOfTick = 0.25;
constexpr double kOfPiece = 0.5;
constexpr double kFeatureGrowth = 0.15;
constexpr double kShortest = 0.2;  // between two ends of cells, of what is asked for there
// No cell is shorter, whatever the path does: sharper features are passed at next to no feedrate.
constexpr double kLeastCell_mm = 1e-9;
constexpr double kLeastShare = 1e-3;  // on a block that is hardly longer itself
constexpr double kFlat = 1e-6;
constexpr double kFarAway = 1e3;   // of a block's length: finite, to be interpolated
constexpr double kNearest = 1e-5;  // of a block's length
constexpr double kFarther = 1.5;

// The estimate over s, how far each place is from where the feedrate changes, and how long a cell
// may be there so that it follows the path's turning.
struct Scan {
  std::vector<double> places_mm;
  std::vector<double> feeds_mm_s;
  std::vector<double> quiet_mm;
  std::vector<double> feature_mm;
  double cell_ticks = kCellTicks;

  [[nodiscard]] double least_mm() const {
    return std::min(kLeastCell_mm, kLeastShare * places_mm.back());
  }
  // A function of values at the places, linear between them.
  [[nodiscard]] double at(const std::vector<double>& values, double s_mm) const {
    const auto after = std::upper_bound(places_mm.begin(), places_mm.end(), s_mm);
    const auto i = static_cast<std::size_t>(after - places_mm.begin());
    if (i == 0 || i == places_mm.size()) {
      return i == 0 ? values.front() : values.back();
    }
    const double share = (s_mm - places_mm[i - 1]) / (places_mm[i] - places_mm[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
  }
  // How long a cell at this place may be.
  [[nodiscard]] double cell_mm(double s_mm, const PlanLimits& limits) const {
    const double of_motion =
        std::max(cell_ticks * limits.period_s * at(feeds_mm_s, s_mm), kGrowth * at(quiet_mm, s_mm));
    return std::max(least_mm(), std::min(at(feature_mm, s_mm), of_motion));
  }
};

Cell cell_between(const BlockPath& path, double from_mm, double to_mm) {
  const double inside = 1e-9 * (to_mm - from_mm);  // its own side of a jump
  return {.s_begin_mm = from_mm,
          .length_mm = to_mm - from_mm,
          .begin = path.at(from_mm + inside),
          .end = path.at(to_mm - inside),
          .along = path.along(),
          .along_from = path.along_from()};
}

bool is_quiet(const Cell& cell, double v_mm_s, double cap_mm_s, const PlanLimits& limits) {
  if (std::abs(v_mm_s - cap_mm_s) > kFlat * cap_mm_s) {
    return false;
  }
  const double v2 = v_mm_s * v_mm_s;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(cell.begin.second_per_mm[k]) * v2 > kTurning * limits.axes[k].acceleration_mm_s2 ||
        std::abs(cell.begin.third_per_mm2[k]) * v2 * v_mm_s >
            kTurning * limits.axes[k].jerk_mm_s3) {
      return false;
    }
  }
  return true;
}

// The jerk's ramp is longer than the estimate's: as far again as a change of acceleration takes.
double ramp_mm(const Cell& cell, double v_mm_s, const PlanLimits& limits) {
  const double a = tangential_acceleration_mm_s2(cell, cell.begin, limits);
  const double j = tangential_jerk_mm_s3(cell, cell.begin, limits);
  const double time = std::min(a / j, std::sqrt(v_mm_s / j));
  return 4.0 * v_mm_s * time;
}

// Beside an end that is passed slowly the estimate rises steeply: places ever closer to it.
void add_places_beside_ends(const EndFeeds& ends, std::vector<double>& places_mm) {
  const double length = places_mm.back();
  const std::size_t count = places_mm.size();
  for (double d = kNearest * length; d < 0.5 * length; d *= kFarther) {
    if (ends.v_begin_mm_s < kUnbounded && d < places_mm[1]) {
      places_mm.push_back(d);
    }
    if (ends.v_end_mm_s < kUnbounded && length - d > places_mm[count - 2]) {
      places_mm.push_back(length - d);
    }
  }
  std::sort(places_mm.begin(), places_mm.end());
}

// Where nothing is near: no value is infinite, since they are interpolated.
std::vector<double> far_away(const Scan& scan) {
  return std::vector<double>(scan.places_mm.size(), kFarAway * scan.places_mm.back());
}

// From any place on, values rise with the distance by no more than this.
void limit_growth(const std::vector<double>& places_mm, double growth,
                  std::vector<double>& values) {
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    values[i + 1] = std::min(values[i + 1], values[i] + growth * (places_mm[i + 1] - places_mm[i]));
  }
  for (std::size_t i = values.size() - 1; i-- > 0;) {
    values[i] = std::min(values[i], values[i + 1] + growth * (places_mm[i + 1] - places_mm[i]));
  }
}

// What a feature of the path asks of the cells around it, were it far shorter than a tick.
double feature_mm(const CellEnd& end, double piece_mm, double tick_mm) {
  const double curvature = curves::vec(end.second_per_mm).norm();
  return std::min(kOfRadius / curvature, std::max(kOfPiece * piece_mm, kOfTick * tick_mm));
}

Scan scan(const BlockPath& path, const EndFeeds& ends, const std::vector<CellStop>& stops,
          const PlanLimits& limits) {
  Scan result{.places_mm = path.scan_places(), .feeds_mm_s = {}, .quiet_mm = {}, .feature_mm = {}};
  result.cell_ticks = path.piece_mm(0.0) == kUnbounded ? kPlainCellTicks : kCellTicks;
  add_places_beside_ends(ends, result.places_mm);
  for (const CellStop& stop : stops) {
    result.places_mm.push_back(stop.s_mm);
  }
  std::sort(result.places_mm.begin(), result.places_mm.end());
  result.places_mm.erase(std::unique(result.places_mm.begin(), result.places_mm.end()),
                         result.places_mm.end());
  std::vector<Cell> cells;
  double cap = 0.0;
  for (std::size_t i = 0; i + 1 < result.places_mm.size(); ++i) {
    cells.push_back(cell_between(path, result.places_mm[i], result.places_mm[i + 1]));
    cap = std::max(cap, cells.back().shares.feedrate * cells.back().begin.feedrate_mm_s);
  }
  std::size_t at = 0;
  for (const CellStop& stop : stops) {
    while (at < cells.size() && cells[at].s_begin_mm < stop.s_mm) {
      ++at;
    }
    if (stop.passage && at < cells.size()) {
      cells[at].begin.bind_feedrate(stop.passage->feedrate_mm_s, SpeedLimit::joint);
    }
  }
  result.feeds_mm_s = estimate_feeds(cells, ends, limits);
  result.quiet_mm = far_away(result);
  result.feature_mm = far_away(result);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double v = result.feeds_mm_s[i];
    double piece = kUnbounded;
    if (!is_quiet(cells[i], v, cap, limits) ||
        !is_quiet(cells[i], result.feeds_mm_s[i + 1], cap, limits)) {
      const double ramp = ramp_mm(cells[i], v, limits);
      result.quiet_mm[i] = std::min(result.quiet_mm[i], -ramp);
      result.quiet_mm[i + 1] = -ramp;
      piece = path.piece_mm(cells[i].s_begin_mm);
    }
    for (const auto& [end, place] :
         {std::pair{&cells[i].begin, i}, std::pair{&cells[i].end, i + 1}}) {
      double& feature = result.feature_mm[place];
      feature = std::min(feature, feature_mm(*end, piece, limits.period_s * v));
    }
  }
  limit_growth(result.places_mm, 1.0, result.quiet_mm);
  limit_growth(result.places_mm, kFeatureGrowth, result.feature_mm);
  return result;
}

// Cells between two places too close for the path's resolution would be noise: the second is moved
// onto the first. Where no cell needs to end just there, another place near by will do.
std::vector<CellStop> apart(const std::vector<CellStop>& stops, const Scan& seen,
                            const PlanLimits& limits) {
  const double length = seen.places_mm.back();
  std::vector<CellStop> kept{stops.front()};
  for (std::size_t i = 1; i + 1 < stops.size(); ++i) {
    CellStop stop = stops[i];
    const double shortest = kShortest * seen.cell_mm(stop.s_mm, limits);
    if (stop.slack_mm == 0.0 &&
        stop.s_mm - kept.back().s_mm < std::min(shortest, kept.back().slack_mm)) {
      kept.pop_back();
    }
    const double room = std::max(std::min(shortest, stop.slack_mm), seen.least_mm());
    if (length - stop.s_mm < room) {
      stop.s_mm = length;
    }
    CellStop& before = kept.back();
    if (stop.s_mm - before.s_mm >= room) {
      kept.push_back(stop);
      continue;
    }
    before.rest |= stop.rest;
    if (stop.passage &&
        (!before.passage || stop.passage->feedrate_mm_s < before.passage->feedrate_mm_s)) {
      before.passage = stop.passage;
    }
  }
  kept.push_back(stops.back());
  return kept;
}

EndFeeds feeds_of(const EndPassages& ends) {
  return {.v_begin_mm_s = ends.begin ? ends.begin->feedrate_mm_s : kUnbounded,
          .v_end_mm_s = ends.end ? ends.end->feedrate_mm_s : kUnbounded};
}

}  // namespace

std::vector<Cell> grid_of(const BlockPath& path, const EndPassages& ends,
                          const PlanLimits& limits) {
  std::vector<CellStop> stops = cell_stops(path, ends, limits);
  const Scan seen = scan(path, feeds_of(ends), stops, limits);
  stops = apart(stops, seen, limits);
  std::vector<Cell> cells;
  std::vector<std::size_t> boundaries;
  double s = 0.0;
  for (const CellStop& stop : stops) {
    while (s < stop.s_mm) {
      const double h = std::min(seen.cell_mm(s, limits), stop.s_mm - s);
      const double length = std::min(h, seen.cell_mm(s + h, limits));
      const double left = stop.s_mm - s;
      const double next =
          left < 1.5 * length ? stop.s_mm : s + (left < 2.5 * length ? 0.5 * left : length);
      cells.push_back(cell_between(path, s, next));
      s = next;
    }
    boundaries.push_back(cells.size());
    if (stop.rest && !cells.empty()) {
      cells.back().rest_after = true;
    }
  }
  cells.back().ends_block = true;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (stops[i].passage && !stops[i].rest) {
      share_limits(cells, boundaries[i], *stops[i].passage, limits);
    }
  }
  return cells;
}

}  // namespace kerf::lookahead
