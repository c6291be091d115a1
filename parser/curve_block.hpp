// One block of a curve as its collector sees it, and what the collectors share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "parser/arc_geometry.hpp"
#include "parser/block.hpp"
#include "parser/codes.hpp"
#include "parser/fault.hpp"
#include "parser/modal_state.hpp"
#include "parser/move.hpp"

namespace kerf::parser {

struct CurveBlock {
  const Block& block;
  const BlockCodes& codes;
  const ModalState& state;
  std::uint32_t line = 0;
};

// Orders (degree + 1) that the curves can have, and how long a curve may become in memory.
inline constexpr int kLowestOrder = 2;
inline constexpr int kHighestOrder = 10;
inline constexpr std::size_t kMostControlPoints = 20'000;
inline constexpr double kLargestCoordinate_mm = 999999.999;

// Where the sum of the doubles is a decimal of nine places but for rounding, it is that: millions
// of small steps then end where one large one does. In mm and without offsets on the same bits.
double sum_of_decimals(double one, double other);

// The block's end point in machine coordinates: absolute or from `from_mm`, axes without a word
// keep their place.
// False, with the fault: beyond +-999999.999 mm.
bool resolve_point(const CurveBlock& at, const Point& from_mm, Point& point, Fault& fault);

// The first word of `set` in the order of the line; nullptr where there is none.
const Word* leftmost(const Block& block, Letters set);
// The capital letter of a word.
char letter_of(const Block& block, const Word& word);

// The two letters of the axes of a plane.
constexpr Letters plane_letters(Plane plane) {
  return letter_bit(axis_letter(axes_of(plane).first)) |
         letter_bit(axis_letter(axes_of(plane).second));
}

// Adds a control point and the line that it comes from.
void append_point(NurbsMove& curve, const NurbsPoint& point, std::uint32_t line);

// The word that gives a control point its weight, and the page of a wrong one.
struct WeightRule {
  char letter;
  const ErrorPage* page;
};

// The code of a curve, with which each of its messages begins.
struct CurveCode {
  std::string_view name;

  // Puts a fault together from parts of its message. Returns false for the caller to return.
  bool fail(Fault& fault, std::uint32_t offset, const ErrorPage& page,
            std::initializer_list<std::string_view> parts) const;
  // 1 where the block has no such word. False, with the fault: not greater than 0.
  bool read_weight(const Block& block, const WeightRule& rule, double& weight, Fault& fault) const;
};

// For curves of two axes: either both or none of the plane's axes. `name` begins the message.
bool check_plane_axes(const CurveBlock& at, std::string_view name, Fault& fault);

// True where the curve has no extent.
bool is_a_point(const NurbsMove& curve);

}  // namespace kerf::parser
