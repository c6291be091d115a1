// A block's segments for the classical schedule.
#pragma once

#include <vector>

#include "lookahead/classical/segment_junction.hpp"
#include "lookahead/classical/velocity_segment.hpp"
#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// In order, with the feedrates of the valleys between them; the junction at the last one's end is
// still open (a stop).
//
// On a curve under limits of axes it is chosen which valleys of the limit curve end a segment
// (docs/math.md, 6.2). There the acceleration is 0, which costs time on both sides; a ramp over the
// valley is no steeper than its bottom allows, which does, too. So the curve is planned with
// shallow valleys and without, from rest to rest and in motion at its ends; between places where
// both are cut the faster of two plans is taken, and planned again. A block that goes on from the
// one before it does not begin at rest and is cut at every valley. Known weakness: of a few heights
// alone, and what is best at rest and in motion together may be best in neither.
std::vector<VelocitySegment> segments_of(const Block& block, const JunctionRules& rules,
                                         bool begins_at_rest);

}  // namespace kerf::lookahead
