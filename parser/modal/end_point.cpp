#include "parser/modal/end_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnostics/errors/pages.hpp"
#include "parser/modal/word_users.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG53 = 530;

// Where coordinates are not those of the machine. Axes without a word keep their place to the last
// bit, unless the turn makes them move with another.
Point resolved_with_offsets(const RunningBlock& at, const ModalState& state, const Point& from_mm) {
  const Coordinates& coordinates = state.coordinates;
  const double unit = mm_per_unit(state.units);
  const bool incremental = state.incremental;
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

// Where the words lead on the machine, with G91 how far; nothing is meant for axes without a word.
AuxiliaryWords auxiliary_target(const RunningBlock& at, const ModalState& state) {
  AuxiliaryWords words{};
  for (std::size_t axis = 0; axis < kAuxiliaryAxes; ++axis) {
    words[axis] = at.block.has(kAuxiliaryNames[axis])
                      ? auxiliary_word_deg_mm(at.block, axis, state.units)
                      : 0.0;
  }
  const bool on_machine = state.incremental || at.codes[Group::other] == kG53;
  return on_machine ? words : state.coordinates.auxiliary_to_machine(words);
}

// In a turned coordinate system the word to blame may be that of the other axis.
diagnostics::Failure out_of_range(const BlockWords& block, char letter) {
  const Word& word =
      block.has(letter) ? block.word(letter) : *leftmost(block, letters('X', 'Y', 'Z'));
  return fail(
      word.offset, errors::kPositionOutOfRange,
      joined({upper(block.text(word).substr(0, 1)), ": ", upper(block.text(word).substr(1, 40)),
              " leads outside -999999.999..999999.999 mm"}));
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

Expected<Point> resolve_point(const RunningBlock& at, const ModalState& state,
                              const Point& from_mm) {
  const bool plain = state.coordinates.plain() || at.codes[Group::other] == kG53;
  Point point = plain ? from_mm : resolved_with_offsets(at, state, from_mm);
  const double unit = mm_per_unit(state.units);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = axis_letter(axis);
    const bool named = at.block.has(letter);
    if (plain && !named) {
      continue;
    }
    if (plain) {
      const double value = at.block.value(letter) * unit;
      point[axis] = state.incremental ? sum_of_decimals(from_mm[axis], value) : value;
    }
    if (!(std::fabs(point[axis]) <= kLargestCoordinate_mm)) {
      return out_of_range(at.block, letter);
    }
  }
  return point;
}

Point axis_words_mm(const BlockWords& block, Units units) {
  const double unit = mm_per_unit(units);
  return {block.value_or('X', 0.0) * unit, block.value_or('Y', 0.0) * unit,
          block.value_or('Z', 0.0) * unit};
}

Done needs_axis_words(const RunningBlock& at) {
  if (at.block.has_any(at.axis_letters())) {
    return {};
  }
  const Group taker = taker_of_axes(at.block, at.codes);
  return fail(at.code_word(taker).offset, errors::kAxisWordMissing,
              joined({at.name_of(taker), " needs at least one axis word"}));
}

double auxiliary_word_deg_mm(const BlockWords& block, std::size_t auxiliary_axis, Units units) {
  return block.value(kAuxiliaryNames[auxiliary_axis]) *
         (is_rotary(auxiliary_axis) ? 1.0 : mm_per_unit(units));
}

Expected<AuxiliaryWords> resolve_auxiliary(const RunningBlock& at, const ModalState& state,
                                           ContourPhase phase) {
  AuxiliaryWords end_deg_mm = state.auxiliary_deg_mm;
  if (!at.block.has_any(at.auxiliary_axes)) {
    return end_deg_mm;
  }
  if (phase != ContourPhase::none) {
    Done refused =
        refuse_auxiliary(at, phase == ContourPhase::held ? "while G41/G42 is active"
                                                         : "in the move that ends G41/G42");
    return fault_of(refused);
  }
  const AuxiliaryWords target = auxiliary_target(at, state);
  for (std::size_t axis = 0; axis < kAuxiliaryAxes; ++axis) {
    if (!at.block.has(kAuxiliaryNames[axis])) {
      continue;
    }
    end_deg_mm[axis] =
        state.incremental ? sum_of_decimals(end_deg_mm[axis], target[axis]) : target[axis];
    if (!(std::fabs(end_deg_mm[axis]) <= kLargestCoordinate_mm)) {
      const Word& word = at.block.word(kAuxiliaryNames[axis]);
      return fail(
          word.offset, errors::kPositionOutOfRange,
          joined({named(kAuxiliaryNames[axis]), ": ", upper(at.block.text(word).substr(1, 40)),
                  " leads outside -999999.999..999999.999", is_rotary(axis) ? " degrees" : " mm"}));
    }
  }
  return end_deg_mm;
}

Done refuse_auxiliary(const RunningBlock& at, std::string_view where) {
  const Word* const word = leftmost(at.block, at.auxiliary_axes);
  if (word == nullptr) {
    return {};
  }
  return fail(word->offset, errors::kAuxiliaryAxisHere,
              joined({named(letter_of(at.block, *word)), " cannot be used ", where}));
}

}  // namespace kerf::parser
