// The places of a block at which cells must end.
#pragma once

#include <optional>
#include <vector>

#include "lookahead/optimum/grid/block_path.hpp"
#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"
#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// The highest feedrate over a length beside a junction.
struct SubTickZone {
  double feedrate_mm_s = kUnbounded;
  double length_mm = 0.0;  // 0: no zone
};

// curve: it joins `beside`, at no more than v_junction_mm_s.
struct SubTickBlock {
  const Block& curve;
  const BlockEnd& junction;  // of `beside`
  const Block& beside;
  double v_junction_mm_s = 0.0;
};

// A sub-tick block is one that a tick may pass over whole. Its bound (sub_tick_feedrate_mm_s) is
// for a tick's mean feedrate, and a tick that passes over all of it may speed up away from it, or
// slow down towards it. So the bound also applies beside it, over the length of one tick at that
// bound: a tick that sees all of the block and leaves the zone would take longer than a tick. There
// is no zone where the feedrate that the junction allows keeps the bound even with full
// acceleration. Weakness: where `beside` is shorter than the zone, the block after it is not bound.
SubTickZone sub_tick_zone(const SubTickBlock& sub_tick, const PlanLimits& limits);

struct SubTickZones {
  SubTickZone begin{};
  SubTickZone end{};
};

// Bounds the cells of a block that lie in its zones.
void bind_zones(const SubTickZones& zones, std::vector<Cell>& cells);

// How a block's junctions are passed; none: a rest, or nothing jumps there.
struct EndJunctions {
  std::optional<JunctionLimits> begin{};
  std::optional<JunctionLimits> end{};
  EndFeeds beyond{};  // feedrates that the neighbours allow where the junction itself is smooth
  SubTickZones zones{};
};

struct CellStop {
  double s_mm = 0.0;
  std::optional<JunctionLimits> junction{};  // where something jumps there
  bool rest = false;
  double slack_mm = 0.0;  // another place so near will do
};

// Ascending, both ends of the block among them: the places where derivatives jump or the limit
// curve has a valley, the ends of the zones of three ticks beside jumps (a cell that begins in one
// has no more than its share), and the ends of the zones beside sub-tick blocks. Jumps that one
// third difference may see together share the limits.
std::vector<CellStop> cell_stops(const BlockPath& path, const EndJunctions& ends,
                                 const PlanLimits& limits);

}  // namespace kerf::lookahead
