#include "parser/modal/end_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnostics/errors/motion.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG53 = 530;

// Where coordinates are not those of the machine. Axes without a word keep their place to the last
// bit, unless the turn makes them move with another.
Point resolved_with_offsets(const CurveBlock& at, const Point& from_mm) {
  const Coordinates& coordinates = at.state.coordinates;
  const double unit = mm_per_unit(at.state.units);
  const bool incremental = at.state.incremental;
  Point program = incremental ? Point{} : coordinates.to_program(from_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.block.has(axis_letter(axis))) {
      program[axis] = at.block.value(axis_letter(axis)) * unit;
    }
  }
  Point point =
      incremental ? coordinates.turned_to_machine(program) : coordinates.to_machine(program);
  const bool together = coordinates.turned() && at.block.has_any(letters('X', 'Y'));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool moves = at.block.has(axis_letter(axis)) || (together && axis < 2);
    if (!moves) {
      point[axis] = from_mm[axis];
    } else if (incremental) {
      point[axis] = sum_of_decimals(from_mm[axis], point[axis]);
    }
  }
  return point;
}

// In a turned coordinate system the word to blame may be that of the other axis.
diagnostics::Fault out_of_range(const Block& block, char letter) {
  const Word& word =
      block.has(letter) ? block.word(letter) : *leftmost(block, letters('X', 'Y', 'Z'));
  return {word.offset,
          joined({upper(block.text(word).substr(0, 1)), ": ", upper(block.text(word).substr(1, 40)),
                  " leads outside -999999.999..999999.999 mm"}),
          &errors::kPositionOutOfRange};
}

}  // namespace

double sum_of_decimals(double one, double other) {
  constexpr double kPlaces = 1e9;
  constexpr double kRounding = 2.0 * std::numeric_limits<double>::epsilon();
  const double sum = one + other;
  const double decimal = std::nearbyint(sum * kPlaces) / kPlaces;
  const double rounding = kRounding * std::max(std::fabs(one), std::fabs(other));
  return std::fabs(sum - decimal) <= rounding ? decimal : sum;
}

bool resolve_point(const CurveBlock& at, const Point& from_mm, Point& point,
                   diagnostics::Fault& fault) {
  const bool plain = at.state.coordinates.plain() || at.codes[Group::other] == kG53;
  point = plain ? from_mm : resolved_with_offsets(at, from_mm);
  const double unit = mm_per_unit(at.state.units);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = axis_letter(axis);
    const bool named = at.block.has(letter);
    if (plain && !named) {
      continue;
    }
    if (plain) {
      const double value = at.block.value(letter) * unit;
      point[axis] = at.state.incremental ? sum_of_decimals(from_mm[axis], value) : value;
    }
    if (!(std::fabs(point[axis]) <= kLargestCoordinate_mm)) {
      fault = out_of_range(at.block, letter);
      return false;
    }
  }
  return true;
}

double extra_word_deg_mm(const Block& block, std::size_t extra_axis, Units units) {
  return block.value(kExtraNames[extra_axis]) * (turns(extra_axis) ? 1.0 : mm_per_unit(units));
}

}  // namespace kerf::parser
