// The places of a block at which cells must end.
#pragma once

#include <optional>
#include <vector>

#include "lookahead/optimum/grid/block_path.hpp"
#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"
#include "lookahead/optimum/grid/sub_tick_zone.hpp"

namespace kerf::lookahead {

// How a block's junctions are passed; none: a rest, or nothing jumps there.
struct EndJunctions {
  std::optional<JunctionLimits> begin{};
  std::optional<JunctionLimits> end{};
  EndFeeds beyond{};  // what the neighbours leave where the junction itself is smooth
  SubTickZones zones{};
};

struct CellStop {
  double s_mm = 0.0;
  std::optional<JunctionLimits> junction{};  // of what jumps there
  bool rest = false;
  double slack_mm = 0.0;  // another place so near will do
};

// Ascending, both ends of the block among them: where derivatives jump or the limit curve has a
// valley, and where the zones of three ticks beside jumps end, for a cell that begins in one has no
// more than its share, and where the zones beside curves that a tick passes over whole end. Jumps
// that a third difference may see together share what is theirs.
std::vector<CellStop> cell_stops(const BlockPath& path, const EndJunctions& ends,
                                 const PlanLimits& limits);

}  // namespace kerf::lookahead
