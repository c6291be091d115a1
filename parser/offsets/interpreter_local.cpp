// G52 and G92.
#include "parser/interpreter/interpreter.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG52 = 520;

}  // namespace

// G52 X5 puts the local origin to X5 of the work offset; G92 X5 names the tool's place X5.
bool Interpreter::set_local_offset() {
  if (dialect_ == Dialect::fanuc && block_->has('S') && !block_->has_any(axis_letters())) {
    return true;  // the highest speed of G96
  }
  if (!needs_axis_words() || !check_unshaped()) {
    return false;
  }
  const Point words = axis_words_mm();
  const Point here = state_.coordinates.to_program(state_.position_mm);
  Point local = state_.coordinates.local_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block_->has(axis_letter(axis))) {
      local[axis] =
          codes_[Group::other] == kG52 ? words[axis] : local[axis] + here[axis] - words[axis];
    }
  }
  const ExtraWords extra_here = state_.coordinates.extra_to_program(state_.extra_deg_mm);
  ExtraWords extra = state_.coordinates.local_extra_deg_mm();
  for (std::size_t axis = 0; axis < kExtraAxes; ++axis) {
    if (block_->has(kExtraNames[axis])) {
      const double word = extra_word_deg_mm(*block_, axis, state_.units);
      extra[axis] = codes_[Group::other] == kG52 ? word : extra[axis] + extra_here[axis] - word;
    }
  }
  state_.coordinates.set_local(local, extra);
  state_.stored_local_mm = local;
  state_.stored_local_extra_deg_mm = extra;
  state_.local_active = true;
  return true;
}

// G92.1 forgets the local offset, G92.2 lays it aside, G92.3 takes it up again.
void Interpreter::change_local_offset() {
  const Tenths code = codes_[Group::local_offset];
  if (code == kNoCode) {
    return;
  }
  if (code == 921) {
    state_.stored_local_mm = {};
    state_.stored_local_extra_deg_mm = {};
  }
  state_.local_active = code == 923;
  if (code == 923) {
    state_.coordinates.set_local(state_.stored_local_mm, state_.stored_local_extra_deg_mm);
  } else {
    state_.coordinates.set_local({});
  }
}

}  // namespace kerf::parser
