// What a probe touches on a simulated table.
#pragma once

#include <optional>

#include "parser/moves/move.hpp"

namespace kerf::parser {

using kerf::TouchBox;

// The point is in the block or on its face, but for rounding.
bool touches(const TouchBox& box, const Point& tip_mm);

// Where the way from `from_mm` straight to `to_mm` meets the block; nothing where it does not.
// Precondition: `from_mm` does not touch it.
std::optional<Point> first_contact(const TouchBox& box, const Point& from_mm, const Point& to_mm);

// Where the way leaves the block; nothing where it ends in it. Precondition: `from_mm` touches it.
std::optional<Point> last_contact(const TouchBox& box, const Point& from_mm, const Point& to_mm);

}  // namespace kerf::parser
