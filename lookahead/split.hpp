// Blocks to spans: a curve is cut at the valleys of the feedrate it allows.
#pragma once

#include <vector>

#include "lookahead/block.hpp"
#include "lookahead/span.hpp"

namespace kerf::lookahead {

// The spans of a block in order; the junction at the last one's end is still open (a stop).
std::vector<Span> split(const Block& block);
// The same with what turning asks of the axes, which lowers the ceiling and stays with each span.
// Precondition: the block is a NURBS with its ceiling; turning is not empty.
std::vector<Span> split(const Block& block, const Turning& turning, const PlanLimits& limits);
// The same for a block without a ceiling, which is one span.
Span whole_span(const Block& block);

}  // namespace kerf::lookahead
