// What is taken over of a block with an error: see the class.
#include <algorithm>
#include <cmath>

#include "parser/interpreter/interpreter.hpp"
#include "parser/modal/word_users.hpp"
#include "parser/offsets/work_offsets.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG80 = 800;

}  // namespace

void Interpreter::recover(const RunningBlock& at) {
  const BlockWords& block = at.block;
  ModalState& state = memory_.state;
  for (std::size_t i = 0; i < block.g_count; ++i) {
    recover_code(at, block.g[i].value);
  }
  if (block.has_any(at.axis_letters()) && !is_cycle(state.motion) &&
      taker_of_axes(block, at.codes) == Group::count) {
    const Expected<Point> end = resolve_point(at, state, state.position_mm);
    const Expected<AuxiliaryWords> auxiliary_end =
        resolve_auxiliary(at, state, compensation_.phase());
    if (end && auxiliary_end) {
      state.position_mm = *end;
      state.auxiliary_deg_mm = *auxiliary_end;
    }
  }
  if (block.has('F') && block.value('F') > 0.0 && state.feed_mode == FeedMode::per_minute) {
    state.feed_word = block.value('F');
    state.feedrate_mm_s = feedrate_mm_s_from(state.feed_word, state.units);
  }
}

void Interpreter::recover_code(const RunningBlock& at, double g) {
  ModalState& state = memory_.state;
  const double tenths = std::round(std::clamp(g, 0.0, 99.0) * 10.0);
  const auto code = static_cast<Tenths>(tenths);
  if (std::fabs(g * 10.0 - tenths) > 1e-8) {
    return;
  }
  switch (code) {
    case 170:
    case 180:
    case 190:
      state.plane = plane_of(code);
      break;
    case 200:
    case 210:
      set_units(state, code == 200 ? Units::inch : Units::mm);
      break;
    case 900:
    case 910:
      state.incremental = code == 910;
      break;
    case 930:
    case 940:
    case 950:
      feed_.set_mode(state, feed_mode_of(code));
      break;
    default:
      recover_motion(at, code);
      break;
  }
}

void Interpreter::recover_motion(const RunningBlock& at, Tenths code) {
  const bool plain = code == 0 || code == 10 || code == 20 || code == 30;
  const bool ends_cycle = code == kG80 && at.codes[Group::motion] == kG80;
  if (plain || ends_cycle || is_cycle(static_cast<Motion>(code))) {
    set_motion(at, memory_.state, code);
  } else if (code >= 540 && code <= 593 && at.codes[Group::work_offset] == code) {
    select_work_offset(at.codes, memory_.state.coordinates);
  } else if (code == 400 && compensation_.on()) {
    compensation_.stop();
  }
}

}  // namespace kerf::parser
