// G10: the program writes work offsets and the tool table.
#include <cmath>

#include "diagnostics/errors/offsets.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

bool Interpreter::set_data() {
  const Word& code = code_word(*block_, codes_, Group::other);
  if (!block_->has('L')) {
    return fail(code.offset, errors::kG10WithoutKind, "G10 needs L");
  }
  const Word& kind = block_->word('L');
  if (kind.value == 20.0 && dialect_ == Dialect::fanuc) {
    return set_extended_data();
  }
  if (kind.value == 2.0 || kind.value == 20.0) {
    return set_work_data(kind.value == 20.0);
  }
  if (dialect_ == Dialect::fanuc && kind.value >= 10.0 && kind.value <= 13.0 &&
      kind.value == std::floor(kind.value)) {
    return set_offset_memory(static_cast<int>(kind.value));
  }
  if (kind.value == 1.0 || kind.value == 10.0 || kind.value == 11.0) {
    return set_tool_data(static_cast<int>(kind.value));
  }
  return fail(
      kind.offset, errors::kG10UnknownKind,
      joined({"G10: L", shortest(kind.value), " is not known (L1, L2, L10, L11, L20 are)"}));
}

// Words that only some kinds of G10 use.
bool Interpreter::check_data_words(std::string_view name, Letters usable) {
  const Letters extra = letters('I', 'J', 'Q', 'R', 'K') & ~usable;
  if (const Word* const word = leftmost(*block_, extra)) {
    return fail(word->offset, errors::kG10UnusedWord,
                joined({named(letter_of(*block_, *word)), " is not used by ", name}));
  }
  return true;
}

// P in the range; the fault is set where it is not.
std::optional<int> Interpreter::data_number(std::string_view name, int least, int most) {
  const std::string range =
      joined({" must be ", std::to_string(least), " to ", std::to_string(most)});
  if (!block_->has('P')) {
    fail(code_word(*block_, codes_, Group::other).offset, errors::kG10Number,
         joined({name, " needs P, which", range}));
    return std::nullopt;
  }
  const Word& word = block_->word('P');
  if (word.value != std::floor(word.value) || word.value < least || word.value > most) {
    fail(word.offset, errors::kG10Number,
         joined({name, ": P", range, ", found ", shortest(word.value)}));
    return std::nullopt;
  }
  return static_cast<int>(word.value);
}

// L2 puts the origin of a work offset somewhere, L20 so that the tool's place gets the coordinates
// of the words. P1 is G54 ... P9 G59.3, P0 the one in force.
bool Interpreter::set_work_data(bool from_position) {
  const std::string_view name = from_position ? "G10 L20" : "G10 L2";
  const auto number = data_number(name, 0, static_cast<int>(Coordinates::kSystems));
  if (!number || !check_data_words(name, from_position ? Letters{0} : letters('R'))) {
    return false;
  }
  Coordinates& coordinates = state_.coordinates;
  const std::size_t system =
      *number == 0 ? coordinates.system() : static_cast<std::size_t>(*number - 1);
  WorkOffset offset = coordinates.work(system);
  if (block_->has('R')) {
    offset.rotation_deg = block_->value('R');
  }
  const Point words = axis_words_mm();
  const bool adds = dialect_ == Dialect::fanuc && state_.incremental;
  if (from_position) {
    Point program = coordinates.to_program(state_.position_mm);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      program[axis] = block_->has(axis_letter(axis)) ? words[axis] : program[axis];
    }
    // As the system would place it with its origin at zero.
    Coordinates there = coordinates;
    there.set_work(system, {.origin_mm = {}, .rotation_deg = offset.rotation_deg});
    there.select(system);
    const Point origin = difference(state_.position_mm, there.to_machine(program));
    const bool turns = there.turned() && block_->has_any(letters('X', 'Y'));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool written = block_->has(axis_letter(axis)) || (turns && axis < 2);
      offset.origin_mm[axis] = written ? origin[axis] : offset.origin_mm[axis];
    }
  } else {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (block_->has(axis_letter(axis))) {
        offset.origin_mm[axis] = words[axis] + (adds ? offset.origin_mm[axis] : 0.0);
      }
    }
  }
  set_extra_origin(offset, from_position);
  coordinates.set_work(system, offset);
  return true;
}

// Fanuc's L20 writes the offset of G54.1 P.
bool Interpreter::set_extended_data() {
  const auto number = data_number("G10 L20", 1, static_cast<int>(Coordinates::kExtended));
  if (!number || !check_data_words("G10 L20", 0)) {
    return false;
  }
  const std::size_t system = Coordinates::kSystems + static_cast<std::size_t>(*number - 1);
  WorkOffset offset = state_.coordinates.work(system);
  const Point words = axis_words_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block_->has(axis_letter(axis))) {
      offset.origin_mm[axis] = words[axis] + (state_.incremental ? offset.origin_mm[axis] : 0.0);
    }
  }
  set_extra_origin(offset, false);
  state_.coordinates.set_work(system, offset);
  return true;
}

// L1 writes the offsets of a tool. L10 and L11 do so such that the tool's place would get the
// coordinates of the words once the offset is taken up: in the work offset in force (L10), or in
// G59.3 without G52 and G92 (L11). What is in force does not change before the next G43.
bool Interpreter::set_tool_data(int kind) {
  const std::string name = joined({"G10 L", std::to_string(kind)});
  const auto number = data_number(name, 1, ToolTable::kHighestNumber);
  if (!number || !check_data_words(name, letters('R', 'I', 'J', 'Q')) ||
      !refuse_extra(joined({"with ", name}))) {
    return false;
  }
  const Tool* const listed = table_tool(*number, block_->word('P').offset);
  if (listed == nullptr) {
    return false;
  }
  Tool tool = *listed;
  tool.number = *number;
  Point offset = axis_words_mm();
  if (kind != 1) {
    Coordinates there = state_.coordinates;
    there.set_tool({});
    if (kind == 11) {
      there.set_local({});
      there.select(Coordinates::kSystems - 1);
    }
    Point program = there.to_program(difference(state_.position_mm, listed->offset_mm));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      program[axis] = block_->has(axis_letter(axis)) ? offset[axis] : program[axis];
    }
    offset = difference(state_.position_mm, there.to_machine(program));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    tool.offset_mm[axis] = block_->has(axis_letter(axis)) ? offset[axis] : tool.offset_mm[axis];
  }
  if (block_->has('R')) {
    tool.diameter_mm = 2.0 * block_->value('R') * mm_per_unit(state_.units);
  }
  tool.front_angle_deg = block_->value_or('I', tool.front_angle_deg);
  tool.back_angle_deg = block_->value_or('J', tool.back_angle_deg);
  if (block_->has('Q')) {
    const Word& word = block_->word('Q');
    if (word.value != std::floor(word.value) || word.value < 0.0 || word.value > 9.0) {
      return fail(word.offset, errors::kToolOrientation,
                  joined({name, ": Q must be 0 to 9, found ", shortest(word.value)}));
    }
    tool.orientation = static_cast<std::int32_t>(block_->value('Q'));
  }
  machine_.tools.put(tool);
  return true;
}

}  // namespace kerf::parser
