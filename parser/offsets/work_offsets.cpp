#include "parser/offsets/work_offsets.hpp"

#include "diagnostics/errors/pages.hpp"
#include "parser/modal/end_point.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

void select_work_offset(const BlockCodes& codes, Coordinates& coordinates) {
  const Tenths code = codes[Group::work_offset];
  if (code == kNoCode || code == 541) {
    return;
  }
  const int system = code > 590 ? 5 + code % 10 : (code - 540) / 10;
  coordinates.select(static_cast<std::size_t>(system));
}

Done set_local_offset(const RunningBlock& at, ModalState& state) {
  if (at.rules.speed_limit_in_g92 && at.block.has('S') && !at.block.has_any(at.axis_letters())) {
    return {};  // the highest speed of G96
  }
  if (Done given = needs_axis_words(at); !given) {
    return given;
  }
  if (state.coordinates.shaped()) {  // in which of the two systems would it count?
    return fail(
        at.code_word(Group::other).offset, errors::kOffsetUnderShape,
        joined({at.name_of(Group::other), " cannot be used while G51, G51.1 or G68 is active"}));
  }
  const Point words = axis_words_mm(at.block, state.units);
  const Point here = state.coordinates.to_program(state.position_mm);
  Point local = state.coordinates.local_mm();
  const bool sets = at.codes[Group::other] == 520;  // G92 moves by what the words differ
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.block.has(axis_letter(axis))) {
      local[axis] = sets ? words[axis] : local[axis] + here[axis] - words[axis];
    }
  }
  const AuxiliaryWords auxiliary_here =
      state.coordinates.auxiliary_to_program(state.auxiliary_deg_mm);
  AuxiliaryWords auxiliary = state.coordinates.local_auxiliary_deg_mm();
  for (std::size_t axis = 0; axis < kAuxiliaryAxes; ++axis) {
    if (!at.block.has(kAuxiliaryNames[axis])) {
      continue;
    }
    const double word = auxiliary_word_deg_mm(at.block, axis, state.units);
    auxiliary[axis] = sets ? word : auxiliary[axis] + auxiliary_here[axis] - word;
  }
  state.coordinates.set_local(local, auxiliary);
  state.stored_local_mm = local;
  state.stored_local_auxiliary_deg_mm = auxiliary;
  state.local_active = true;
  return {};
}

void change_local_offset(const BlockCodes& codes, ModalState& state) {
  const Tenths code = codes[Group::local_offset];
  if (code == kNoCode) {
    return;
  }
  if (code == 921) {
    state.stored_local_mm = {};
    state.stored_local_auxiliary_deg_mm = {};
  }
  state.local_active = code == 923;
  if (code == 923) {
    state.coordinates.set_local(state.stored_local_mm, state.stored_local_auxiliary_deg_mm);
  } else {
    state.coordinates.set_local({});
  }
}

}  // namespace kerf::parser
