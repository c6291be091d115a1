// Where the axis words of a block lead.
#pragma once

#include "parser/modal/running_block.hpp"
#include "parser/moves/arc_geometry.hpp"

namespace kerf::parser {

inline constexpr double kLargestCoordinate_mm = 999999.999;

// Adds two coordinates. A sum that is a decimal of nine places but for rounding becomes that
// decimal, so that millions of small steps end where one large step does: in mm and without
// offsets on the same bits.
double sum_of_decimals(double one, double other);

// The block's end point in machine coordinates: absolute or from `from_mm`, axes without a word
// keep their place. At most +-999999.999 mm.
Expected<Point> resolve_point(const RunningBlock& at, const ModalState& state,
                              const Point& from_mm);

// The axis words in mm; 0 for an axis without one.
Point axis_words_mm(const BlockWords& block, Units units);
// Refuses a block without axis words, which its code needs.
Done needs_axis_words(const RunningBlock& at);

// The word of an auxiliary axis. Precondition: the block has it.
double auxiliary_word_deg_mm(const BlockWords& block, std::size_t auxiliary_axis, Units units);

// What cutter compensation is doing with the moves: it holds a contour or is on its way out.
enum class ContourPhase : std::uint8_t { none, held, leaving };

// Where the block's words send the auxiliary axes, on the machine; those without a word stay.
Expected<AuxiliaryWords> resolve_auxiliary(const RunningBlock& at, const ModalState& state,
                                           ContourPhase phase);
// Refuses a word of an auxiliary axis. `where`: "with G5".
Done refuse_auxiliary(const RunningBlock& at, std::string_view where);

}  // namespace kerf::parser
