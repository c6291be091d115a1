#include "parser/interpreter/modes.hpp"

#include "diagnostics/errors/pages.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"

namespace kerf::parser {

namespace {

// Of G64. P alone stands for both [rs274 sets the tolerance of its naive CAM detector so]; where it
// is missing LinuxCNC cuts corners without a bound, and here the machine's own bound holds.
Done set_tolerances(const RunningBlock& at, ModalState& state, const MachineData& machine) {
  state.blend_tolerance_mm = machine.corner_tolerance_mm;
  state.merge_tolerance_mm = machine.merge_tolerance_mm;
  if (at.block.has('P')) {
    const Word& word = at.block.word('P');
    if (word.value < 0.0) {
      return fail(word.offset, errors::kNegativeBlendTolerance,
                  "G64: P (tolerance) must not be negative");
    }
    state.blend_tolerance_mm = word.value * mm_per_unit(state.units);
    state.merge_tolerance_mm = state.blend_tolerance_mm;
  }
  if (at.block.has('Q')) {
    const Word& word = at.block.word('Q');
    if (word.value < 0.0) {
      return fail(word.offset, errors::kNegativeMergeTolerance,
                  "G64: Q (merging tolerance) must not be negative");
    }
    state.merge_tolerance_mm = word.value * mm_per_unit(state.units);
  }
  return {};
}

}  // namespace

Done set_path_mode(const RunningBlock& at, ModalState& state, const MachineData& machine) {
  const Tenths code = at.codes[Group::path];
  if (code == kNoCode) {
    return {};
  }
  state.path_mode = code == 640   ? PathMode::blend
                    : code == 611 ? PathMode::exact_stop
                                  : PathMode::exact_path;
  state.path_mode_by_program = true;
  state.blend_tolerance_mm = 0.0;
  state.merge_tolerance_mm = 0.0;
  return code == 640 ? set_tolerances(at, state, machine) : Done();
}

Done dwell(const RunningBlock& at, const ModalState& state) {
  if (at.rules.dwell_in_axes) {
    return fanuc_dwell(at, state);
  }
  const Word& code = at.code_word(Group::other);
  if (!at.block.has('P')) {
    return fail(code.offset, errors::kDwellWithoutTime, "G4 needs P (seconds)");
  }
  const Word& word = at.block.word('P');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeDwell, "G4: P must not be negative");
  }
  at.push_move(state).shape = DwellMove{word.value};
  return {};
}

}  // namespace kerf::parser
