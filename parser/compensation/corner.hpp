// How the tool gets from one offset curve to the next.
#pragma once

#include <cstdint>

#include "parser/compensation/planar.hpp"

namespace kerf::parser {

enum class CornerKind : std::uint8_t {
  smooth,     // one curve goes on in the direction of the other
  outside,    // the tool rolls about the corner on an arc of its own radius
  inside,     // both curves are cut back to the point where they meet
  too_tight,  // inside, and the curves do not meet: the tool does not fit between them
};

struct OffsetCorner {
  CornerKind kind = CornerKind::smooth;
  planar::Vec first_end_mm;     // where the first curve is left
  planar::Vec second_start_mm;  // where the second is begun; not the same at an outside corner
  double first_loses_mm = 0.0;  // along the first offset curve
  double second_loses_mm = 0.0;
};

// A programmed curve and the tool's way beside it, whole.
struct OffsetCurve {
  planar::ContourElement programmed;
  planar::ContourElement path;
};

// `left_mm` is the offset of both: positive with the tool on the left. Both are not 0 long.
OffsetCorner corner_between(const OffsetCurve& first, const OffsetCurve& second, double left_mm);

}  // namespace kerf::parser
