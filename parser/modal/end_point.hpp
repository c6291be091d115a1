// A block in the modes that it is run in, and where its words lead.
#pragma once

#include <cstdint>

#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"
#include "parser/modal/codes.hpp"
#include "parser/modal/modal_state.hpp"
#include "parser/moves/arc_geometry.hpp"

namespace kerf::parser {

struct CurveBlock {
  const Block& block;
  const BlockCodes& codes;
  const ModalState& state;
  std::uint32_t line = 0;
};

inline constexpr double kLargestCoordinate_mm = 999999.999;

// Where the sum of the doubles is a decimal of nine places but for rounding, it is that: millions
// of small steps then end where one large one does. In mm and without offsets on the same bits.
double sum_of_decimals(double one, double other);

// The block's end point in machine coordinates: absolute or from `from_mm`, axes without a word
// keep their place.
// False, with the fault: beyond +-999999.999 mm.
bool resolve_point(const CurveBlock& at, const Point& from_mm, Point& point,
                   diagnostics::Fault& fault);

// The word of an extra axis. Precondition: the block has it.
double extra_word_deg_mm(const Block& block, std::size_t extra_axis, Units units);

}  // namespace kerf::parser
