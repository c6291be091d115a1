// What only the Fanuc dialect has: a group of their own for cycles, G4 with X and U, G30 P, G10 L10
// to L13.
#include <cmath>
#include <utility>

#include "diagnostics/errors/blocks.hpp"
#include "diagnostics/errors/fanuc.hpp"
#include "diagnostics/errors/modes.hpp"
#include "parser/cycles/drill_cycle.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG4 = 40;
constexpr Tenths kG30 = 300;

}  // namespace

// G06.2 P goes to 4 on the control; a program with more is for Kerf, or wrong.
void Interpreter::warn_of_order() {
  constexpr double kHighestOfFanuc = 4.0;
  if (block_->has('P') && block_->value('P') > kHighestOfFanuc) {
    warn(block_->word('P').offset, errors::kOrderExtension,
         joined({"G6.2: P (order) ", shortest(block_->value('P')),
                 " is an extension: Fanuc takes 2 to 4"}));
  }
}

MacroSignal Interpreter::take_signal() {
  return std::exchange(state_.signal, {});
}

// Letters that codes take here and not in RS274.
Letters Interpreter::letters_of_fanuc() const {
  const Tenths other = codes_[Group::other];
  return other == kG4    ? letters('U')
         : other == kG30 ? letters('P')
         : codes_[Group::motion] == static_cast<Tenths>(Motion::quadratic_spline) &&
                 !block_->has_any(axis_letters())
             ? letters('R')  // G5.1 Q1 R: the level of contour control
             : 0;
}

// Cycles do not end the motion of group 01, they lie over it: G80 alone comes back to it, and its
// axis words are that motion's.
void Interpreter::settle_cycle_group() {
  BlockCodes::Entry& motion = codes_.by_group[static_cast<std::size_t>(Group::motion)];
  const bool in_cycle = is_cycle(state_.motion);
  if (motion.tenths == static_cast<Tenths>(Motion::none)) {
    motion = {};
    if (in_cycle) {
      set_motion(static_cast<Tenths>(state_.beneath_cycle));
    }
  } else if (is_cycle(static_cast<Motion>(motion.tenths))) {
    const Tenths beneath = codes_[Group::cycle];
    if (beneath != motion.tenths) {
      state_.beneath_cycle = static_cast<Motion>(beneath);
    } else if (!in_cycle) {
      state_.beneath_cycle = state_.motion;
    }
  }
}

// P in milliseconds, X and U in seconds.
bool Interpreter::fanuc_dwell() {
  const Word& code = code_word(*block_, codes_, Group::other);
  if (const Word* const word = leftmost(*block_, axis_letters() & ~letters('X', 'U'))) {
    return fail(
        word->offset, errors::kDwellWithAxis,
        joined({"G4 takes the time in P, X or U, not in ", named(letter_of(*block_, *word))}));
  }
  const Word* const time = leftmost(*block_, letters('P', 'X', 'U'));
  if (time == nullptr) {
    return fail(code.offset, errors::kDwellWithoutTime,
                "G4 needs P (milliseconds), X or U (seconds)");
  }
  const char letter = letter_of(*block_, *time);
  if (block_->has_any(letters('P', 'X', 'U') & ~letter_bit(letter))) {
    return fail(time->offset, errors::kDwellTwice, "G4: the time is given in two words");
  }
  if (time->value < 0.0) {
    return fail(time->offset, errors::kNegativeDwell,
                joined({"G4: ", named(letter), " must not be negative"}));
  }
  constexpr double kSecondsPerMs = 0.001;
  push_move().shape = DwellMove{time->value * (letter == 'P' ? kSecondsPerMs : 1.0)};
  return true;
}

// G30 P2 to P4: the second to the fourth reference point; without P the second. Nothing: the fault
// is set.
std::optional<HomePosition> Interpreter::reference_point() {
  const double number = block_->value_or('P', 2.0);
  if (number == 2.0) {
    return HomePosition{machine_.second_home_mm, machine_.second_home_extra_deg_mm};
  }
  if (number == 3.0 || number == 4.0) {
    return machine_.further_homes[number == 3.0 ? 0 : 1];
  }
  const Word& word = block_->word('P');
  fail(word.offset, errors::kReferencePoint,
       joined({"G30: P must be 2, 3 or 4, found ", shortest(word.value)}));
  return std::nullopt;
}

// L10 and L11: length of offset number P and its wear; L12 and L13: radius and its wear. What
// counts is their sum. G91 adds to what is there.
bool Interpreter::set_offset_memory(int kind) {
  const std::string name = joined({"G10 L", std::to_string(kind)});
  const auto number = data_number(name, 1, ToolTable::kHighestNumber);
  if (!number || !check_data_words(name, letters('R'))) {
    return false;
  }
  if (!block_->has('R')) {
    return fail(code_word(*block_, codes_, Group::other).offset, errors::kOffsetMemoryValue,
                joined({name, " needs R (the value)"}));
  }
  if (const Word* const word = leftmost(*block_, axis_letters())) {
    return fail(word->offset, errors::kOffsetMemoryValue,
                joined({name, " takes the value in R, not in ", named(letter_of(*block_, *word))}));
  }
  const Tool* const listed = table_tool(*number, block_->word('P').offset);
  if (listed == nullptr) {
    return false;
  }
  Tool tool = *listed;
  tool.number = *number;
  const double value = block_->value('R') * mm_per_unit(state_.units);
  const bool length = kind < 12;
  double& wear = length ? tool.length_wear_mm : tool.radius_wear_mm;
  double whole = length ? tool.offset_mm[2] : tool.diameter_mm / 2;
  const bool of_wear = kind == 11 || kind == 13;
  const double before = of_wear ? wear : whole - wear;
  const double after = value + (state_.incremental ? before : 0.0);
  whole += after - before;
  wear = of_wear ? after : wear;
  if (length) {
    tool.offset_mm[2] = whole;
  } else {
    tool.diameter_mm = 2 * whole;
  }
  machine_.tools.put(tool);
  return true;
}

}  // namespace kerf::parser
