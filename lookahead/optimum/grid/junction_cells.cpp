// What junctions leave to the cells beside them.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kSupportTicks = 3.0;  // of a third difference
// The feedrate is not below 0 before a junction or after it, so at feedrate v the acceleration is
// sqrt(2 J v) at the most. Where the path bends J may be more than on a straight line; so much
// more.
constexpr double kMostOfJerk = 2.0;

}  // namespace

double zone_mm(const Cell& cell, const curves::PathDerivatives& end, const JunctionLimits& junction,
               const PlanLimits& limits) {
  const JumpShares& shares = junction.shares;
  const double t = kSupportTicks * limits.period_s;
  const double v = junction.feedrate_mm_s;
  const double j = tangential_jerk_mm_s3(cell, end, limits);
  const double a = std::min(shares.tangential * tangential_acceleration_mm_s2(cell, end, limits),
                            std::sqrt(2.0 * kMostOfJerk * j * v));
  return t * (v + t * (a + 0.5 * t * shares.cells * j));
}

namespace {

// cell, end: beside the jump.
void bind_beside(const JunctionLimits& junction, Cell& cell, PathSample& end) {
  end.bind_feedrate(junction.feedrate_mm_s, Constraint::junction);
  // The share taken off again: the cap holds whatever the share.
  double& a = cell.along.acceleration_mm_s2;
  a = std::min(a, junction.acceleration_mm_s2 / junction.acceleration_share);
}

void keep_free(BlockSide side, Cell& cell) {
  if (side != BlockSide::none) {
    cell.beside = side;
    cell.instead = {.allowed = cell.allowed,
                    .acceleration_mm_s2 = cell.along.acceleration_mm_s2,
                    .jumps_per_mm_s = cell.jumps_per_mm_s};
  }
}

void exchange(Cell& cell) {
  std::swap(cell.allowed, cell.instead.allowed);
  std::swap(cell.along.acceleration_mm_s2, cell.instead.acceleration_mm_s2);
  std::swap(cell.jumps_per_mm_s, cell.instead.jumps_per_mm_s);
  cell.relaxed = !cell.relaxed;
  cell.shares.acceleration = kAim * cell.allowed.acceleration;
  cell.shares.jerk = kAim * cell.allowed.jerk;
}

double leave_rest(const JunctionLimits& junction, const PlanLimits& limits, Cell& cell) {
  for (std::size_t k = 0; k < cell.jumps_per_mm_s.size(); ++k) {
    cell.jumps_per_mm_s[k] += junction.jumps_per_mm_s[k];
  }
  const JumpShares& shares = junction.shares;
  if (shares.tangential < 1.0 && cell.allowed.jerk > shares.cells) {
    cell.along.acceleration_mm_s2 = std::min(
        cell.along.acceleration_mm_s2, shares.tangential / junction.acceleration_share *
                                           tangential_acceleration_mm_s2(cell, cell.begin, limits));
  }
  cell.allowed.acceleration = std::min(cell.allowed.acceleration, junction.acceleration_share);
  cell.allowed.jerk = std::min(cell.allowed.jerk, shares.cells);
  cell.shares.acceleration = kAim * cell.allowed.acceleration;
  cell.shares.jerk = kAim * cell.allowed.jerk;
  return cell.length_mm;
}

}  // namespace

void share_limits(std::vector<Cell>& cells, std::size_t boundary, const JunctionLimits& junction,
                  const PlanLimits& limits) {
  assert(boundary <= cells.size());
  const BlockSide side = boundary == 0              ? BlockSide::begin
                         : boundary == cells.size() ? BlockSide::end
                                                    : BlockSide::none;
  if (boundary > 0) {
    Cell& last = cells[boundary - 1];
    const double zone = zone_mm(last, last.end, junction, limits);
    double way = 0.0;
    for (std::size_t i = boundary; i-- > 0 && way < zone;) {
      keep_free(side, cells[i]);
      way += leave_rest(junction, limits, cells[i]);
    }
    bind_beside(junction, last, last.end);
  }
  if (boundary < cells.size()) {
    Cell& first = cells[boundary];
    const double zone = zone_mm(first, first.begin, junction, limits);
    double way = 0.0;
    for (std::size_t i = boundary; i < cells.size() && way < zone; ++i) {
      keep_free(side, cells[i]);
      way += leave_rest(junction, limits, cells[i]);
    }
    bind_beside(junction, first, first.begin);
  }
}

void relax_beside_rest(std::vector<Cell>& cells, BlockSide side) {
  const std::uint64_t block = side == BlockSide::begin ? cells.front().block : cells.back().block;
  for (Cell& cell : cells) {
    if (cell.block == block && cell.beside == side && !cell.relaxed) {
      exchange(cell);
    }
  }
}

void bind_beside_junction(Cell& cell) {
  if (cell.relaxed) {
    exchange(cell);
  }
}

}  // namespace kerf::lookahead
