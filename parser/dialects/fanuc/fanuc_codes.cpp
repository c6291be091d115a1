#include "parser/dialects/fanuc/fanuc_codes.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/modal/end_point.hpp"
#include "parser/offsets/program_data.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG4 = 40;
constexpr Tenths kG30 = 300;

// Fanuc's L20 writes the offset of G54.1 P.
Done set_extended_data(const RunningBlock& at, ModalState& state) {
  Expected<int> number = data_number(at, "G10 L20", {1, static_cast<int>(Coordinates::kExtended)});
  if (!number) {
    return fault_of(number);
  }
  if (Done fine = check_data_words(at.block, "G10 L20", 0); !fine) {
    return fine;
  }
  const std::size_t system = Coordinates::kSystems + static_cast<std::size_t>(*number - 1);
  WorkOffset offset = state.coordinates.work(system);
  const Point words = axis_words_mm(at.block, state.units);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.block.has(axis_letter(axis))) {
      offset.origin_mm[axis] = words[axis] + (state.incremental ? offset.origin_mm[axis] : 0.0);
    }
  }
  set_auxiliary_origin(at, state, offset, false);
  state.coordinates.set_work(system, offset);
  return {};
}

// L10 and L11: length of offset number P and its wear; L12 and L13: radius and its wear. What
// counts is their sum. G91 adds to what is there.
Done set_offset_memory(const RunningBlock& at, const ModalState& state, ToolTable& tools,
                       int kind) {
  const std::string name = joined({"G10 L", std::to_string(kind)});
  Expected<int> number = data_number(at, name, {1, ToolTable::kHighestNumber});
  if (!number) {
    return fault_of(number);
  }
  if (Done fine = check_data_words(at.block, name, letters('R')); !fine) {
    return fine;
  }
  if (!at.block.has('R')) {
    return fail(at.code_word(Group::other).offset, errors::kOffsetMemoryValue,
                joined({name, " needs R (the value)"}));
  }
  if (const Word* const word = leftmost(at.block, at.axis_letters())) {
    return fail(
        word->offset, errors::kOffsetMemoryValue,
        joined({name, " takes the value in R, not in ", named(letter_of(at.block, *word))}));
  }
  Expected<const Tool*> listed = named_tool(at, tools, *number, at.block.word('P').offset);
  if (!listed) {
    return fault_of(listed);
  }
  Tool tool = **listed;
  tool.number = *number;
  const double value = at.block.value('R') * mm_per_unit(state.units);
  const bool length = kind < 12;
  double& wear = length ? tool.length_wear_mm : tool.radius_wear_mm;
  double whole = length ? tool.offset_mm[2] : tool.diameter_mm / 2;
  const bool of_wear = kind == 11 || kind == 13;
  const double before = of_wear ? wear : whole - wear;
  const double after = value + (state.incremental ? before : 0.0);
  whole += after - before;
  wear = of_wear ? after : wear;
  if (length) {
    tool.offset_mm[2] = whole;
  } else {
    tool.diameter_mm = 2 * whole;
  }
  tools.put(tool);
  return {};
}

}  // namespace

void warn_of_order(const RunningBlock& at) {
  if (at.block.has('P') && at.block.value('P') > at.rules.usual_order) {
    at.warn(at.block.word('P').offset, errors::kOrderExtension,
            joined({"G6.2: P (order) ", shortest(at.block.value('P')),
                    " is an extension: Fanuc takes 2 to 4"}));
  }
}

Letters letters_of_fanuc(const RunningBlock& at) {
  const Tenths other = at.codes[Group::other];
  return other == kG4    ? letters('U')
         : other == kG30 ? letters('P')
         : at.codes[Group::motion] == static_cast<Tenths>(Motion::quadratic_spline) &&
                 !at.block.has_any(at.axis_letters())
             ? letters('R')  // G5.1 Q1 R: the level of contour control
             : 0;
}

void settle_cycle_group(const RunningBlock& at, BlockCodes& codes, ModalState& state) {
  BlockCodes::Entry& motion = codes.by_group[static_cast<std::size_t>(Group::motion)];
  const bool in_cycle = is_cycle(state.motion);
  if (motion.tenths == static_cast<Tenths>(Motion::none)) {
    motion = {};
    if (in_cycle) {
      set_motion(at, state, static_cast<Tenths>(state.beneath_cycle));
    }
  } else if (is_cycle(static_cast<Motion>(motion.tenths))) {
    const Tenths beneath = codes[Group::cycle];
    if (beneath != motion.tenths) {
      state.beneath_cycle = static_cast<Motion>(beneath);
    } else if (!in_cycle) {
      state.beneath_cycle = state.motion;
    }
  }
}

Done fanuc_dwell(const RunningBlock& at, const ModalState& state) {
  const Word& code = at.code_word(Group::other);
  if (const Word* const word = leftmost(at.block, at.axis_letters() & ~letters('X', 'U'))) {
    return fail(
        word->offset, errors::kDwellWithAxis,
        joined({"G4 takes the time in P, X or U, not in ", named(letter_of(at.block, *word))}));
  }
  const Word* const time = leftmost(at.block, letters('P', 'X', 'U'));
  if (time == nullptr) {
    return fail(code.offset, errors::kDwellWithoutTime,
                "G4 needs P (milliseconds), X or U (seconds)");
  }
  const char letter = letter_of(at.block, *time);
  if (at.block.has_any(letters('P', 'X', 'U') & ~letter_bit(letter))) {
    return fail(time->offset, errors::kDwellTwice, "G4: the time is given in two words");
  }
  if (time->value < 0.0) {
    return fail(time->offset, errors::kNegativeDwell,
                joined({"G4: ", named(letter), " must not be negative"}));
  }
  constexpr double kSecondsPerMs = 0.001;
  at.push_move(state).shape = DwellMove{time->value * (letter == 'P' ? kSecondsPerMs : 1.0)};
  return {};
}

Expected<HomePosition> second_reference_point(const BlockWords& block, const MachineData& machine) {
  const double number = block.value_or('P', 2.0);
  if (number == 2.0) {
    return HomePosition{machine.second_home_mm, machine.second_home_extra_deg_mm};
  }
  if (number == 3.0 || number == 4.0) {
    return machine.further_homes[number == 3.0 ? 0 : 1];
  }
  const Word& word = block.word('P');
  return fail(word.offset, errors::kReferencePoint,
              joined({"G30: P must be 2, 3 or 4, found ", shortest(word.value)}));
}

Done set_fanuc_data(const RunningBlock& at, ModalState& state, ToolTable& tools) {
  const double kind = at.block.value_or('L', 0.0);
  if (kind == 20.0) {
    return set_extended_data(at, state);
  }
  if (kind >= 10.0 && kind <= 13.0 && kind == std::floor(kind)) {
    return set_offset_memory(at, state, tools, static_cast<int>(kind));
  }
  return set_data(at, state, tools);
}

}  // namespace kerf::parser
