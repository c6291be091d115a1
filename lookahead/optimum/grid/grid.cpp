#include "lookahead/optimum/grid/grid.hpp"

#include <algorithm>
#include <cstddef>

#include "lookahead/optimum/grid/grid_scan.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kShortest = 0.2;  // between two ends of cells, of what is asked for there

// Cells between two places too close for the path's resolution would be noise: the second is moved
// onto the first. Where no cell needs to end just there, another place near by will do.
std::vector<CellStop> apart(const std::vector<CellStop>& stops, const GridScan& seen) {
  const double length = seen.length_mm();
  std::vector<CellStop> kept{stops.front()};
  for (std::size_t i = 1; i + 1 < stops.size(); ++i) {
    CellStop stop = stops[i];
    const double shortest = kShortest * seen.cell_mm(stop.s_mm);
    if (stop.slack_mm == 0.0 &&
        stop.s_mm - kept.back().s_mm < std::min(shortest, kept.back().slack_mm)) {
      kept.pop_back();
    }
    const double room = std::max(std::min(shortest, stop.slack_mm), seen.min_mm());
    if (length - stop.s_mm < room) {
      stop.s_mm = length;
    }
    CellStop& before = kept.back();
    if (stop.s_mm - before.s_mm >= room) {
      kept.push_back(stop);
      continue;
    }
    before.rest |= stop.rest;
    if (stop.junction &&
        (!before.junction || stop.junction->feedrate_mm_s < before.junction->feedrate_mm_s)) {
      before.junction = stop.junction;
    }
  }
  kept.push_back(stops.back());
  return kept;
}

// No longer than a cell may be at either of its ends. Where that is far shorter at its end, it is
// shorter than it would be at a nearer one.
double cell_from_mm(const GridScan& seen, double s_mm, double stop_mm) {
  double length = std::min(seen.cell_mm(s_mm), stop_mm - s_mm);
  double at_end = seen.cell_mm(s_mm + length);
  while (at_end < 0.5 * length) {
    length *= 0.5;
    at_end = seen.cell_mm(s_mm + length);
  }
  return std::min(length, at_end);
}

// Up to the next stop, evenly where few are left.
double cell_end_mm(const GridScan& seen, double s_mm, double stop_mm) {
  const double length = cell_from_mm(seen, s_mm, stop_mm);
  const double left = stop_mm - s_mm;
  if (left < 1.5 * length) {
    return stop_mm;
  }
  return s_mm + (left < 2.5 * length ? 0.5 * left : length);
}

// From stop to stop. boundaries: how many cells end at or before each stop.
std::vector<Cell> cells_between(const BlockPath& path, const std::vector<CellStop>& stops,
                                const GridScan& seen, std::vector<std::size_t>& boundaries) {
  std::vector<Cell> cells;
  double s = 0.0;
  for (const CellStop& stop : stops) {
    bool begins = true;  // at the stop before, where something may jump
    while (s < stop.s_mm) {
      const double next = cell_end_mm(seen, s, stop.s_mm);
      cells.push_back(cell_between(path, {s, next}, begins ? nullptr : &cells.back()));
      begins = false;
      s = next;
    }
    boundaries.push_back(cells.size());
    if (stop.rest && !cells.empty()) {
      cells.back().rest_after = true;
    }
  }
  cells.back().ends_block = true;
  return cells;
}

EndFeeds feeds_of(const EndJunctions& ends) {
  EndFeeds feeds = ends.beyond;
  if (ends.begin) {
    feeds.v_begin_mm_s = std::min(feeds.v_begin_mm_s, ends.begin->feedrate_mm_s);
  }
  if (ends.end) {
    feeds.v_end_mm_s = std::min(feeds.v_end_mm_s, ends.end->feedrate_mm_s);
  }
  return feeds;
}

}  // namespace

std::vector<Cell> parts_of(const Cell& cell, const std::vector<double>& lengths_mm,
                           const PathAt& path) {
  std::vector<Cell> parts(lengths_mm.size(), cell);
  const auto inside = [&](double s_mm) {
    PathSample sample = path(cell, s_mm);
    sample.bind_feedrate(cell.sub_tick_mm_s, Constraint::chord_error);
    return sample;
  };
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    Cell& part = parts[i];
    Cell& next = parts[i + 1];
    part.length_mm = lengths_mm[i];
    part.ends_block = part.rest_after = false;
    next.s_begin_mm = part.s_end_mm();
    next.length_mm = cell.s_end_mm() - next.s_begin_mm;
    part.end = next.begin = inside(next.s_begin_mm);
  }
  return parts;
}

EndFeeds end_feeds_of(const BlockPath& path, const PlanLimits& limits) {
  const std::vector<double> places = path.scan_places();
  std::vector<Cell> cells;
  cells.reserve(places.size());
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const bool may_jump = i == 0 || path.joins_pieces(places[i]);
    cells.push_back(
        cell_between(path, {places[i], places[i + 1]}, may_jump ? nullptr : &cells.back()));
  }
  const std::vector<double> feeds = estimate_feeds(cells, {}, limits);
  return {.v_begin_mm_s = feeds.front(), .v_end_mm_s = feeds.back()};
}

std::vector<Cell> grid_of(const BlockPath& path, const EndJunctions& ends,
                          const PlanLimits& limits) {
  std::vector<CellStop> stops = cell_stops(path, ends, limits);
  const GridScan seen(path, feeds_of(ends), stops, limits);
  stops = apart(stops, seen);
  std::vector<std::size_t> boundaries;
  std::vector<Cell> cells = cells_between(path, stops, seen, boundaries);
  const auto share = [&](std::size_t i) {
    if (stops[i].junction && !stops[i].rest) {
      share_limits(cells, boundaries[i], *stops[i].junction, limits);
    }
  };
  // The ends last: what a rest there gives back to the cells is not what jumps within take.
  for (std::size_t i = 1; i + 1 < stops.size(); ++i) {
    share(i);
  }
  share(0);
  share(stops.size() - 1);
  bind_zones(ends.zones, cells);
  return cells;
}

}  // namespace kerf::lookahead
