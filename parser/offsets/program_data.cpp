#include "parser/offsets/program_data.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/modal/end_point.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// As the system would place it with its origin at zero, so that the tool's place gets the
// coordinates of the words, and keeps those that the system gives it now where there is no word.
void place_origin(const RunningBlock& at, const ModalState& state, std::size_t system,
                  WorkOffset& offset) {
  const Point words = axis_words_mm(at.block, state.units);
  Coordinates now = state.coordinates;
  now.select(system);
  Point program = now.to_program(state.position_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    program[axis] = at.block.has(axis_letter(axis)) ? words[axis] : program[axis];
  }
  Coordinates there = state.coordinates;
  there.set_work(system, {.origin_mm = {}, .rotation_deg = offset.rotation_deg});
  there.select(system);
  const Point origin = difference(state.position_mm, there.to_machine(program));
  const bool turns = there.turned() && at.block.has_any(letters('X', 'Y'));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool written = at.block.has(axis_letter(axis)) || (turns && axis < 2);
    offset.origin_mm[axis] = written ? origin[axis] : offset.origin_mm[axis];
  }
}

void write_origin(const RunningBlock& at, const ModalState& state, WorkOffset& offset) {
  const Point words = axis_words_mm(at.block, state.units);
  const bool adds = at.rules.offset_memory && state.incremental;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.block.has(axis_letter(axis))) {
      offset.origin_mm[axis] = words[axis] + (adds ? offset.origin_mm[axis] : 0.0);
    }
  }
}

// L2 puts the origin of a work offset somewhere, L20 so that the tool's place gets the coordinates
// of the words. P1 is G54 ... P9 G59.3, P0 the one in force.
Done set_work_data(const RunningBlock& at, ModalState& state, bool from_position) {
  const std::string_view name = from_position ? "G10 L20" : "G10 L2";
  Expected<int> number = data_number(at, name, {0, static_cast<int>(Coordinates::kSystems)});
  if (!number) {
    return fault_of(number);
  }
  if (Done fine = check_data_words(at.block, name, from_position ? Letters{0} : letters('R'));
      !fine) {
    return fine;
  }
  Coordinates& coordinates = state.coordinates;
  const std::size_t system =
      *number == 0 ? coordinates.system() : static_cast<std::size_t>(*number - 1);
  WorkOffset offset = coordinates.work(system);
  if (at.block.has('R')) {
    offset.rotation_deg = at.block.value('R');
  }
  if (from_position) {
    place_origin(at, state, system, offset);
  } else {
    write_origin(at, state, offset);
  }
  set_auxiliary_origin(at, state, offset, from_position);
  coordinates.set_work(system, offset);
  return {};
}

// The offset with which the tool's place gets the coordinates of the words.
Point offset_from_position(const RunningBlock& at, const ModalState& state, const Tool& listed,
                           bool in_g59_3) {
  const Point words = axis_words_mm(at.block, state.units);
  Coordinates there = state.coordinates;
  there.set_tool({});
  if (in_g59_3) {
    there.set_local({});
    there.select(Coordinates::kSystems - 1);
  }
  Point program = there.to_program(difference(state.position_mm, listed.offset_mm));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    program[axis] = at.block.has(axis_letter(axis)) ? words[axis] : program[axis];
  }
  return difference(state.position_mm, there.to_machine(program));
}

// L1 writes the offsets of a tool. L10 and L11 do so such that the tool's place would get the
// coordinates of the words once the offset is taken up: in the work offset in force (L10), or in
// G59.3 without G52 and G92 (L11). What is in force does not change before the next G43.
Done set_tool_data(const RunningBlock& at, const ModalState& state, ToolTable& tools, int kind) {
  const std::string name = joined({"G10 L", std::to_string(kind)});
  Expected<int> number = data_number(at, name, {1, ToolTable::kHighestNumber});
  if (!number) {
    return fault_of(number);
  }
  if (Done fine = check_data_words(at.block, name, letters('R', 'I', 'J', 'Q')); !fine) {
    return fine;
  }
  if (Done fine = refuse_auxiliary(at, joined({"with ", name})); !fine) {
    return fine;
  }
  Expected<const Tool*> listed = named_tool(at, tools, *number, at.block.word('P').offset);
  if (!listed) {
    return fault_of(listed);
  }
  Tool tool = **listed;
  tool.number = *number;
  const Point offset = kind == 1 ? axis_words_mm(at.block, state.units)
                                 : offset_from_position(at, state, **listed, kind == 11);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    tool.offset_mm[axis] = at.block.has(axis_letter(axis)) ? offset[axis] : tool.offset_mm[axis];
  }
  if (at.block.has('R')) {
    tool.diameter_mm = 2.0 * at.block.value('R') * mm_per_unit(state.units);
  }
  tool.front_angle_deg = at.block.value_or('I', tool.front_angle_deg);
  tool.back_angle_deg = at.block.value_or('J', tool.back_angle_deg);
  if (at.block.has('Q')) {
    const Word& word = at.block.word('Q');
    if (word.value != std::floor(word.value) || word.value < 0.0 || word.value > 9.0) {
      return fail(word.offset, errors::kToolOrientation,
                  joined({name, ": Q must be 0 to 9, found ", shortest(word.value)}));
    }
    tool.orientation = static_cast<std::int32_t>(at.block.value('Q'));
  }
  tools.put(tool);
  return {};
}

}  // namespace

Done check_data_words(const BlockWords& block, std::string_view name, Letters usable) {
  const Letters surplus = letters('I', 'J', 'Q', 'R', 'K') & ~usable;
  if (const Word* const word = leftmost(block, surplus)) {
    return fail(word->offset, errors::kG10UnusedWord,
                joined({named(letter_of(block, *word)), " is not used by ", name}));
  }
  return {};
}

Expected<int> data_number(const RunningBlock& at, std::string_view name, NumberRange range) {
  const std::string allowed =
      joined({" must be ", std::to_string(range.least), " to ", std::to_string(range.most)});
  if (!at.block.has('P')) {
    return fail(at.code_word(Group::other).offset, errors::kG10Number,
                joined({name, " needs P, which", allowed}));
  }
  const Word& word = at.block.word('P');
  if (word.value != std::floor(word.value) || word.value < range.least || word.value > range.most) {
    return fail(word.offset, errors::kG10Number,
                joined({name, ": P", allowed, ", found ", shortest(word.value)}));
  }
  return static_cast<int>(word.value);
}

void set_auxiliary_origin(const RunningBlock& at, const ModalState& state, WorkOffset& offset,
                          bool from_position) {
  const bool adds = at.rules.offset_memory && state.incremental && !from_position;
  for (std::size_t axis = 0; axis < kAuxiliaryAxes; ++axis) {
    if (!at.block.has(kAuxiliaryNames[axis])) {
      continue;
    }
    double& origin = offset.extra_deg_mm[axis];
    const double word = auxiliary_word_deg_mm(at.block, axis, state.units);
    origin = from_position ? state.auxiliary_deg_mm[axis] -
                                 state.coordinates.local_auxiliary_deg_mm()[axis] - word
                           : word + (adds ? origin : 0.0);
  }
}

Done set_data(const RunningBlock& at, ModalState& state, ToolTable& tools) {
  const Word& code = at.code_word(Group::other);
  if (!at.block.has('L')) {
    return fail(code.offset, errors::kG10WithoutKind, "G10 needs L");
  }
  const Word& kind = at.block.word('L');
  if (kind.value == 2.0 || kind.value == 20.0) {
    return set_work_data(at, state, kind.value == 20.0);
  }
  if (kind.value == 1.0 || kind.value == 10.0 || kind.value == 11.0) {
    return set_tool_data(at, state, tools, static_cast<int>(kind.value));
  }
  return fail(
      kind.offset, errors::kG10UnknownKind,
      joined({"G10: L", shortest(kind.value), " is not known (L1, L2, L10, L11, L20 are)"}));
}

}  // namespace kerf::parser
