#include "lookahead/optimum/grid/grid_scan.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

// Of the estimated motion that a cell lasts.
constexpr double kMinTicks = 1.0;
constexpr double kMaxTicks = 8.0;
// Where the feedrate rises or falls for seconds, a window is to reach from a rest to the next one:
// it has no more cells than this on the way up, and as many on the way down.
constexpr double kMaxOnLeg = 1000.0;
// After a ramp to a feedrate next to none a tick goes nowhere: a block has no more cells for that.
constexpr double kMostWhereSlow = 20'000.0;
constexpr double kGrowth = 0.08;  // of a cell over its distance from where something happens
// Curvature, or a change of feedrate, takes part in the limits where it takes this share of one.
constexpr double kTakesPart = 0.05;
// Over a cell the square of what bounds the feedrate changes by so much of it: between its ends the
// bound is then their mean to within 5e-4.
constexpr double kCapChange = 0.05;
// Of a cell over the radius, the shortest that a piece asks for in ticks and pieces, and how fast
// cells grow beside it.
constexpr double kOfRadius = 0.15;
constexpr double kOfTick = 0.25;
constexpr double kOfPiece = 0.5;
constexpr double kFeatureGrowth = 0.15;
// No cell is shorter, whatever the path does: sharper features are passed at next to no feedrate.
constexpr double kMinCell_mm = 1e-9;
constexpr double kMinShare = 1e-3;  // on a block that is hardly longer itself
constexpr double kFlat = 1e-6;
constexpr double kFarAway = 1e3;   // of a block's length: finite, to be interpolated
constexpr double kNearest = 1e-5;  // of a block's length
constexpr double kFarther = 1.5;

// Beside an end that is passed slowly the estimate rises steeply: places ever closer to it.
void add_places_beside_ends(const EndFeeds& ends, std::vector<double>& places_mm) {
  const double length = places_mm.back();
  const std::size_t count = places_mm.size();
  double d = kNearest * length;
  while (d < 0.5 * length) {
    if (ends.v_begin_mm_s < kUnbounded && d < places_mm[1]) {
      places_mm.push_back(d);
    }
    if (ends.v_end_mm_s < kUnbounded && length - d > places_mm[count - 2]) {
      places_mm.push_back(length - d);
    }
    d *= kFarther;
  }
}

std::vector<double> places_of(const BlockPath& path, const EndFeeds& ends,
                              const std::vector<CellStop>& stops) {
  std::vector<double> places_mm = path.scan_places();
  add_places_beside_ends(ends, places_mm);
  for (const CellStop& stop : stops) {
    places_mm.push_back(stop.s_mm);
  }
  std::sort(places_mm.begin(), places_mm.end());
  places_mm.erase(std::unique(places_mm.begin(), places_mm.end()), places_mm.end());
  return places_mm;
}

std::vector<Cell> cells_between(const BlockPath& path, const std::vector<double>& places_mm,
                                const std::vector<CellStop>& stops) {
  std::vector<Cell> cells;
  cells.reserve(places_mm.size());
  auto stop_here = stops.begin();
  for (std::size_t i = 0; i + 1 < places_mm.size(); ++i) {
    stop_here = std::ranges::lower_bound(stop_here, stops.end(), places_mm[i], {}, &CellStop::s_mm);
    const bool jumps = stop_here != stops.end() && stop_here->s_mm == places_mm[i];
    const Cell* before = cells.empty() || jumps ? nullptr : &cells.back();
    cells.push_back(cell_between(path, {places_mm[i], places_mm[i + 1]}, before));
  }
  std::size_t at = 0;
  for (const CellStop& stop : stops) {
    while (at < cells.size() && cells[at].s_begin_mm < stop.s_mm) {
      ++at;
    }
    if (stop.junction && at < cells.size()) {
      cells[at].begin.bind_feedrate(stop.junction->feedrate_mm_s, Constraint::junction);
    }
  }
  return cells;
}

struct Feeds {
  double begin_mm_s = 0.0;
  double end_mm_s = 0.0;
};

// The feedrate follows what bounds it, and neither that nor curvature asks for much.
bool is_quiet(const Cell& cell, const Feeds& feeds, double acceleration_mm_s2,
              const PlanLimits& limits) {
  const auto is_bound = [&](const PathSample& end, double v_mm_s) {
    return std::abs(v_mm_s - curvature_feedrate_mm_s(cell, end, limits)) <= kFlat * v_mm_s;
  };
  const double from = feeds.begin_mm_s * feeds.begin_mm_s;
  const double to = feeds.end_mm_s * feeds.end_mm_s;
  if (std::abs(to - from) > 2.0 * cell.length_mm * kTakesPart * acceleration_mm_s2 ||
      !is_bound(cell.begin, feeds.begin_mm_s) || !is_bound(cell.end, feeds.end_mm_s)) {
    return false;
  }
  for (const auto& [end, v2] : {std::pair{&cell.begin, from}, std::pair{&cell.end, to}}) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(end->second_per_mm[k]) * v2 > kTakesPart * limits.axes[k].acceleration_mm_s2 ||
          std::abs(end->third_per_mm2[k]) * v2 * std::sqrt(v2) >
              kTakesPart * limits.axes[k].jerk_mm_s3) {
        return false;
      }
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
double feature_mm(const PathSample& end, double piece_mm, double tick_mm) {
  const double curvature = curves::vec(end.second_per_mm).norm();
  return std::min(kOfRadius / curvature, std::max(kOfPiece * piece_mm, kOfTick * tick_mm));
}

}  // namespace

Cell cell_between(const BlockPath& path, const curves::Stretch& stretch, const Cell* before) {
  assert(stretch.begin_mm < stretch.end_mm);
  const double inside = 1e-9 * (stretch.end_mm - stretch.begin_mm);  // its own side of a jump
  Cell cell{.s_begin_mm = stretch.begin_mm,
            .length_mm = stretch.end_mm - stretch.begin_mm,
            .begin = before != nullptr ? before->end : path.at(stretch.begin_mm + inside),
            .end = path.at(stretch.end_mm - inside),
            .straight = path.is_straight(),
            .along = path.along(),
            .along_from = path.along_from()};
  if (cell.begin.feedrate_mm_s == cell.end.feedrate_mm_s) {
    cell.shares.feedrate = kAimOfCruise;
  }
  return cell;
}

GridScan::GridScan(const BlockPath& path, const EndFeeds& ends, const std::vector<CellStop>& stops,
                   const PlanLimits& limits)
    : places_mm_(places_of(path, ends, stops)) {
  const std::vector<Cell> cells = cells_between(path, places_mm_, stops);
  feeds_mm_s_ = estimate_feeds(cells, ends, limits);
  const double behind_ramp_mm = kMaxTicks * limits.period_s * cells.back().end.feedrate_mm_s;
  if (path.slows() && behind_ramp_mm < length_mm() / kMostWhereSlow) {
    least_mm_ = length_mm() / kMostWhereSlow;
  }
  find_motion(cells, limits);
  find_quiet(path, cells, ends, limits);
}

void GridScan::find_motion(const std::vector<Cell>& cells, const PlanLimits& limits) {
  const std::vector<double> legs = legs_of(cells, feeds_mm_s_);
  motion_mm_.assign(places_mm_.size(), kUnbounded);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double a = tangential_acceleration_mm_s2(cells[i], cells[i].begin, limits);
    const double j = tangential_jerk_mm_s3(cells[i], cells[i].begin, limits);
    const bool is_level = std::abs(feeds_mm_s_[i + 1] - feeds_mm_s_[i]) <= kFlat * feeds_mm_s_[i];
    const double min_s =
        std::max(kMinTicks * limits.period_s, is_level ? 0.0 : legs[i] / kMaxOnLeg);
    const double max_s = std::clamp(cell_time_s(legs[i], a / j), min_s,
                                    std::max(kMaxTicks * limits.period_s, min_s));
    const double v = std::max(feeds_mm_s_[i], feeds_mm_s_[i + 1]);
    const double change = change_mm(cells[i], {.v_mm_s = v, .a_mm_s2 = a}, limits);
    for (const std::size_t place : {i, i + 1}) {
      const double at = feeds_mm_s_[place];
      motion_mm_[place] = std::min(motion_mm_[place], std::clamp(change, min_s * at, max_s * at));
    }
  }
}

void GridScan::find_quiet(const BlockPath& path, const std::vector<Cell>& cells,
                          const EndFeeds& ends, const PlanLimits& limits) {
  const double far_away = kFarAway * length_mm();
  quiet_mm_.assign(places_mm_.size(), far_away);
  cap_mm_ = feature_mm_ = quiet_mm_;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    const Feeds feeds{feeds_mm_s_[i], feeds_mm_s_[i + 1]};
    double piece = kUnbounded;
    if (!is_quiet(cell, feeds, tangential_acceleration_mm_s2(cell, cell.begin, limits), limits)) {
      const double ramp = ramp_mm(cell, feeds.begin_mm_s, limits);
      quiet_mm_[i] = std::min(quiet_mm_[i], -ramp);
      quiet_mm_[i + 1] = -ramp;
      piece = path.piece_mm(cell.s_begin_mm);
    }
    const double from = cell.begin.feedrate_mm_s * cell.begin.feedrate_mm_s;
    const double to = cell.end.feedrate_mm_s * cell.end.feedrate_mm_s;
    const double cap = from == to ? far_away
                                  : std::min(far_away, kCapChange * std::min(from, to) *
                                                           cell.length_mm / std::abs(to - from));
    for (const auto& [end, place] : {std::pair{&cell.begin, i}, std::pair{&cell.end, i + 1}}) {
      const double feature = feature_mm(*end, piece, limits.period_s * feeds.begin_mm_s);
      feature_mm_[place] = std::min(feature_mm_[place], feature);
      cap_mm_[place] = std::min(cap_mm_[place], cap);
    }
  }
  // What lies beyond a junction may ask for a change of feedrate that begins on this side of it.
  if (ends.v_begin_mm_s < kUnbounded) {
    quiet_mm_.front() =
        std::min(quiet_mm_.front(), -ramp_mm(cells.front(), feeds_mm_s_.front(), limits));
  }
  if (ends.v_end_mm_s < kUnbounded) {
    quiet_mm_.back() =
        std::min(quiet_mm_.back(), -ramp_mm(cells.back(), feeds_mm_s_.back(), limits));
  }
  limit_growth(places_mm_, 1.0, quiet_mm_);
  if (path.slows()) {
    // A ramp is as long as what is left of the feedrate at its end: that may be next to none.
    for (std::size_t i = 0; i < cells.size(); ++i) {
      quiet_mm_[i + 1] = std::max(quiet_mm_[i + 1], -ramp_mm(cells[i], feeds_mm_s_[i + 1], limits));
    }
  }
  limit_growth(places_mm_, kFeatureGrowth, feature_mm_);
}

double GridScan::min_mm() const {
  return std::min(kMinCell_mm, kMinShare * length_mm());
}

double GridScan::cell_mm(double s_mm) const {
  const auto after = std::upper_bound(places_mm_.begin(), places_mm_.end(), s_mm);
  const auto i = static_cast<std::size_t>(after - places_mm_.begin());
  const std::size_t to = std::min(i, places_mm_.size() - 1);
  const std::size_t from = i == 0 ? 0 : i - 1;
  const double share =
      to == from ? 0.0 : (s_mm - places_mm_[from]) / (places_mm_[to] - places_mm_[from]);
  const auto at = [&](const std::vector<double>& values) {
    return values[from] + share * (values[to] - values[from]);
  };
  const double of_motion =
      std::max({at(motion_mm_), least_mm_, std::min(kGrowth * at(quiet_mm_), at(cap_mm_))});
  return std::max(min_mm(), std::min(at(feature_mm_), of_motion));
}

}  // namespace kerf::lookahead
