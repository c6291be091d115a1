#include "parser/offsets/reference_points.hpp"

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

void push_rapid(const RunningBlock& at, ModalState& state, const Point& end_mm,
                const AuxiliaryWords& auxiliary_deg_mm) {
  if (end_mm == state.position_mm && auxiliary_deg_mm == state.auxiliary_deg_mm) {
    return;
  }
  Move& move = at.push_move(state);
  move.shape = LineMove{end_mm};
  move.rapid = true;
  carry_auxiliary(at, state, move, auxiliary_deg_mm);
  state.position_mm = end_mm;
}

Done go_home(const RunningBlock& at, ModalState& state, const HomePosition& home,
             ContourPhase phase) {
  if (is_cycle(state.motion)) {
    return fail(at.code_word(Group::other).offset, errors::kHomeInCycle,
                joined({at.name_of(Group::other),
                        " while a canned cycle is active: cancel with G80 first"}));
  }
  if (!at.block.has_any(at.axis_letters())) {
    push_rapid(at, state, home.mm, home.extra_deg_mm);
    return {};
  }
  Expected<Point> via = resolve_point(at, state, state.position_mm);
  if (!via) {
    return fault_of(via);
  }
  Expected<AuxiliaryWords> auxiliary_via = resolve_auxiliary(at, state, phase);
  if (!auxiliary_via) {
    return fault_of(auxiliary_via);
  }
  push_rapid(at, state, *via, *auxiliary_via);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    (*via)[axis] = at.block.has(axis_letter(axis)) ? home.mm[axis] : (*via)[axis];
  }
  for (std::size_t axis = 0; axis < kAuxiliaryAxes; ++axis) {
    if (at.block.has(kAuxiliaryNames[axis])) {
      (*auxiliary_via)[axis] = home.extra_deg_mm[axis];
    }
  }
  push_rapid(at, state, *via, *auxiliary_via);
  return {};
}

}  // namespace kerf::parser
