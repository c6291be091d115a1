#include "lookahead/optimum/grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lookahead/optimum/joint_share.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kCellTicks = 1.0;  // of the estimated motion
constexpr double kGrowth = 0.08;    // of a cell over its distance from where something happens
// Turning takes part in the limits where it takes this share of one.
constexpr double kTurning = 0.05;
constexpr double kFlat = 1e-6;
constexpr double kFarAway = 1e3;   // of a block's length: finite, to be interpolated
constexpr double kNearest = 1e-5;  // of a block's length
constexpr double kFarther = 1.5;

// The estimate over s, and how far each place is from where the feedrate changes.
struct Scan {
  std::vector<double> places_mm;
  std::vector<double> feeds_mm_s;
  std::vector<double> quiet_mm;

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
    return std::max(kCellTicks * limits.period_s * at(feeds_mm_s, s_mm),
                    kGrowth * at(quiet_mm, s_mm));
  }
};

Cell cell_between(const BlockPath& path, double from_mm, double to_mm) {
  const double inside = 1e-9 * (to_mm - from_mm);  // its own side of a jump
  return {.s_begin_mm = from_mm,
          .length_mm = to_mm - from_mm,
          .begin = path.at(from_mm + inside),
          .end = path.at(to_mm - inside),
          .along = path.along()};
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

Scan scan(const BlockPath& path, const EndFeeds& ends, const std::vector<BlockPath::Break>& breaks,
          const PlanLimits& limits) {
  Scan result{.places_mm = path.scan_places(), .feeds_mm_s = {}, .quiet_mm = {}};
  for (const BlockPath::Break& place : breaks) {
    result.places_mm.push_back(place.s_mm);
  }
  std::sort(result.places_mm.begin(), result.places_mm.end());
  result.places_mm.erase(std::unique(result.places_mm.begin(), result.places_mm.end()),
                         result.places_mm.end());
  add_places_beside_ends(ends, result.places_mm);
  std::vector<Cell> cells;
  double cap = 0.0;
  for (std::size_t i = 0; i + 1 < result.places_mm.size(); ++i) {
    cells.push_back(cell_between(path, result.places_mm[i], result.places_mm[i + 1]));
    cap = std::max(cap, cells.back().shares.feedrate * cells.back().begin.feedrate_mm_s);
  }
  std::size_t at = 0;
  for (const BlockPath::Break& place : breaks) {
    while (cells[at].s_begin_mm < place.s_mm) {
      ++at;
    }
    cells[at].begin.feedrate_mm_s = std::min(cells[at].begin.feedrate_mm_s, place.feedrate_mm_s);
  }
  result.feeds_mm_s = estimate_feeds(cells, ends, limits);
  std::vector<double>& quiet = result.quiet_mm;
  quiet.assign(result.places_mm.size(), kFarAway * path.length_mm());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_quiet(cells[i], result.feeds_mm_s[i], cap, limits) ||
        !is_quiet(cells[i], result.feeds_mm_s[i + 1], cap, limits)) {
      const double ramp = ramp_mm(cells[i], result.feeds_mm_s[i], limits);
      quiet[i] = std::min(quiet[i], -ramp);
      quiet[i + 1] = -ramp;
    }
  }
  for (std::size_t i = 0; i + 1 < quiet.size(); ++i) {
    quiet[i + 1] = std::min(quiet[i + 1], quiet[i] + cells[i].length_mm);
  }
  for (std::size_t i = quiet.size() - 1; i-- > 0;) {
    quiet[i] = std::min(quiet[i], quiet[i + 1] + cells[i].length_mm);
  }
  return result;
}

// Within a curve nothing jumps along the path.
PlanLimits of_axes(PlanLimits limits) {
  limits.path.acceleration_mm_s2 = limits.path.jerk_mm_s3 = kUnbounded;
  return limits;
}

}  // namespace

std::vector<Cell> grid_of(const BlockPath& path, const EndFeeds& ends, const PlanLimits& limits) {
  std::vector<BlockPath::Break> breaks = path.breaks(jump_limits(of_axes(limits)));
  const Scan seen = scan(path, ends, breaks, limits);
  breaks.push_back({.s_mm = path.length_mm()});
  std::vector<Cell> cells;
  std::vector<PassedJump> jumps;
  double s = 0.0;
  for (const BlockPath::Break& stop : breaks) {
    while (s < stop.s_mm) {
      const double h = std::min(seen.cell_mm(s, limits), stop.s_mm - s);
      const double length = std::min(h, seen.cell_mm(s + h, limits));
      const double left = stop.s_mm - s;
      const double next =
          left < 1.5 * length ? stop.s_mm : s + (left < 2.5 * length ? 0.5 * left : length);
      cells.push_back(cell_between(path, s, next));
      s = next;
    }
    if (stop.feedrate_mm_s < kUnbounded) {
      jumps.push_back({.boundary = cells.size(), .feedrate_mm_s = stop.feedrate_mm_s});
    }
  }
  for (const PassedJump& jump : jumps) {
    share_limits(cells, jump, limits);
  }
  return cells;
}

}  // namespace kerf::lookahead
