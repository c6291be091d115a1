// Blocks to spans: a curve is cut at the valleys of the feedrate it allows.
#pragma once

#include <vector>

#include "lookahead/block.hpp"
#include "lookahead/span.hpp"

namespace kerf::lookahead {

// The spans of a block in order; the junction at the last one's end is still open (a stop).
std::vector<Span> split(const Block& block);
// The same for a block without a ceiling, which is one span.
Span whole_span(const Block& block);

}  // namespace kerf::lookahead
