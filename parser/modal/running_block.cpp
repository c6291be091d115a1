#include "parser/modal/running_block.hpp"

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

std::string RunningBlock::name_of(Group group) const {
  return upper(block.text(code_word(group)));
}

std::uint32_t RunningBlock::motion_offset() const {
  if (codes.has(Group::motion)) {
    return code_word(Group::motion).offset;
  }
  const Word* const word = leftmost(block, axis_letters() | letters('I', 'J', 'K', 'R'));
  return word != nullptr ? word->offset : block.first_word;
}

Move& MoveSink::push_move(const ModalState& state) const {
  Move& move = moves.push();
  move.source = source;
  move.block = block_number;
  move.start_mm = state.position_mm;
  move.rapid = move.in_cycle = move.probes = false;
  move.feedrate_mm_s = 0.0;
  move.follows = {.feed = state.overrides.feed,
                  .spindle = state.feed_mode == FeedMode::per_revolution && state.overrides.speed,
                  .adaptive = state.overrides.adaptive_feed,
                  .feed_stop = state.overrides.feed_hold};
  if (auxiliary_axes != 0) {
    move.auxiliary = auxiliary_move(state.auxiliary_deg_mm, state.auxiliary_deg_mm);
  }
  move.mode = state.path_mode;
  move.blend_tolerance_mm = state.blend_tolerance_mm;
  move.merge_tolerance_mm = state.merge_tolerance_mm;
  move.mode_by_program = state.path_mode_by_program;
  return move;
}

void carry_auxiliary(const MoveSink& at, ModalState& state, Move& move,
                     const AuxiliaryWords& end_deg_mm) {
  if (at.auxiliary_axes != 0) {
    move.auxiliary = auxiliary_move(state.auxiliary_deg_mm, end_deg_mm);
    state.auxiliary_deg_mm = end_deg_mm;
  }
}

void set_motion(const RunningBlock& at, ModalState& state, Tenths code) {
  if (code == 53 || code == 63) {  // G5.3 and G6.3 leave no mode behind
    code = static_cast<Tenths>(Motion::none);
  }
  const auto motion = static_cast<Motion>(code);
  if (motion != Motion::cubic_spline) {
    state.spline_handle_mm.reset();
  }
  if (!is_cycle(motion)) {
    state.cycle.in_series = false;
  }
  if (motion != state.motion && !(is_cycle(state.motion) && at.rules.cycle_group)) {
    state.cycle.words = {};
  }
  state.motion = motion;
}

std::string motion_name(Motion motion) {
  return joined({"G", shortest(static_cast<double>(motion) / 10.0)});
}

std::string motion_name(const ModalState& state) {
  return motion_name(state.motion);
}

// The message names the word as the program has it.
Expected<const Tool*> named_tool(const RunningBlock& at, const ToolTable& tools, double number,
                                 std::uint32_t offset) {
  constexpr double kMax = ToolTable::kHighestNumber;
  const Tool* const tool = number <= kMax  ? tools.find(static_cast<std::int32_t>(number))
                           : tools.given() ? nullptr
                                           : tools.find(0);
  if (tool == nullptr) {
    const char letter = static_cast<char>(at.block.line[offset] & ~0x20);
    const bool named_here = letter == 'T' || letter == 'H' || letter == 'D';
    return fail(
        offset, errors::kToolNotInTable,
        joined({named(named_here ? letter : 'T'), shortest(number), " is not in the tool table"}));
  }
  return tool;
}

}  // namespace kerf::parser
