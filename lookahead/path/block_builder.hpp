// Turns path segments into blocks: a curve with its limits and the feedrate allowed at each point.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "lookahead/path/block.hpp"
#include "lookahead/path/feed_override.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::lookahead {

// plan: the kind of profile that the velocity limit curve is for (Planner::scan_for). Error: an
// axis moves for which the machine has no limits.
tl::expected<Block, smoothing::PathError> block_of(smoothing::PathSegment segment,
                                                   const PlanLimits& limits,
                                                   ScanFor plan = ScanFor::bounded_jerk);

// The limits of the block anew, under an override.
void set_limits(const FeedOverride& by, const PlanLimits& limits, ScanFor plan, Block& block);
// The same for this feedrate, infinity for that of a rapid.
void set_limits(double feedrate_mm_s, const PlanLimits& limits, ScanFor plan, Block& block);

// Appends the blocks of a move as programmed (smoothing/segment_builder.hpp). Error: the
// curve is not valid, with the line to blame.
tl::expected<void, smoothing::PathError> append_blocks(const parser::Move& move,
                                                       const PlanLimits& limits,
                                                       std::vector<Block>& blocks,
                                                       ScanFor plan = ScanFor::bounded_jerk);

}  // namespace kerf::lookahead
