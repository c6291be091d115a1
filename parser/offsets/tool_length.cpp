#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/modal/end_point.hpp"
#include "parser/offsets/work_offsets.hpp"

namespace kerf::parser {

namespace {

// The tool whose number H gives. LinuxCNC takes the one in the spindle where there is no H or H0;
// with Fanuc H0 is no offset.
Expected<const Tool*> tool_of_h(const RunningBlock& at, const ModalState& state,
                                const ToolTable& tools) {
  if (!at.block.has('H') || (at.block.value('H') == 0.0 && !at.rules.zero_is_no_offset)) {
    return named_tool(at, tools, state.loaded_tool, at.code_word(Group::length_offset).offset);
  }
  const Word& word = at.block.word('H');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeOffsetNumber, "H must not be negative");
  }
  if (word.value != std::floor(word.value)) {
    return fail(word.offset, errors::kOffsetNumberNotWhole, "H must be a whole number");
  }
  return named_tool(at, tools, word.value, word.offset);
}

// G43 and G44 H; G43.2 H adds to the offset in force.
Done set_length_from_table(const RunningBlock& at, ModalState& state, const ToolTable& tools) {
  Expected<const Tool*> tool = tool_of_h(at, state, tools);
  if (!tool) {
    return fault_of(tool);
  }
  const Tenths code = at.codes[Group::length_offset];
  const double sign = code == 440 ? -1.0 : 1.0;  // Fanuc's G44
  Point offset = code == 432 ? state.coordinates.tool_mm() : Point{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    offset[axis] =
        code == 432 ? offset[axis] + (*tool)->offset_mm[axis] : sign * (*tool)->offset_mm[axis];
  }
  state.coordinates.set_tool(offset);
  return {};
}

}  // namespace

Done set_length_offset(const RunningBlock& at, ModalState& state, const ToolTable& tools) {
  const Tenths code = at.codes[Group::length_offset];
  if (code == kNoCode) {
    return {};
  }
  state.tool_length_active = code != 490;
  if (code == 490) {
    state.coordinates.set_tool({});
    return {};
  }
  if (code == 430 || code == 440 || (code == 432 && at.block.has('H'))) {
    return set_length_from_table(at, state, tools);
  }
  if (Done given = needs_axis_words(at); !given) {
    return given;
  }
  if (Done fine = refuse_auxiliary(at, "with G43.1 and G43.2"); !fine) {
    return fine;
  }
  const Point words = axis_words_mm(at.block, state.units);
  Point tool = state.coordinates.tool_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.block.has(axis_letter(axis))) {
      tool[axis] = words[axis] + (code == 432 ? tool[axis] : 0.0);
    }
  }
  state.coordinates.set_tool(tool);
  return {};
}

}  // namespace kerf::parser
