// M70 to M73: modes saved and brought back.
#include "diagnostics/errors/switches.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/interpreter/saved_modes.hpp"

namespace kerf::parser {

void restore_modes(const SavedModes& saved, ModalState& state) {
  const ModalState& from = saved.state;
  state.plane = from.plane;
  state.units = from.units;
  state.incremental = from.incremental;
  state.absolute_centre = from.absolute_centre;
  state.feed_mode = from.feed_mode;
  state.feedrate_mm_s = from.feedrate_mm_s;
  state.feed_per_revolution_mm = from.feed_per_revolution_mm;
  state.feed_from_other_units = from.feed_from_other_units;
  state.feed_word = from.feed_word;
  state.path_mode = from.path_mode;
  state.blend_tolerance_mm = from.blend_tolerance_mm;
  state.merge_tolerance_mm = from.merge_tolerance_mm;
  state.spindle_speed = from.spindle_speed;
  state.spindle = from.spindle;
  state.surface_speed = from.surface_speed;
  state.mist = from.mist;
  state.flood = from.flood;
  state.overrides = from.overrides;
  state.coordinates.select(from.coordinates.system());
  if (from.local_active != state.local_active) {
    state.local_active = from.local_active;
    if (from.local_active) {
      state.coordinates.set_local(state.stored_local_mm, state.stored_local_extra_deg_mm);
    } else {
      state.coordinates.set_local({});
    }
  }
}

bool Interpreter::keep_modes() {
  switch (codes_[Group::state]) {
    case 700:
    case 730:
      if (codes_[Group::state] == 730 && saved_modes_.size() == 1) {
        return fail(code_word(*block_, codes_, Group::state).offset, errors::kNoReturnToRestoreAt,
                    "M73 outside a subprogram: there is no return at which it could restore");
      }
      saved_modes_.back() = SavedModes{state_, codes_[Group::state] == 730};
      return true;
    case 710:
      saved_modes_.back().reset();
      return true;
    case 720:
      if (!saved_modes_.back()) {
        return fail(code_word(*block_, codes_, Group::state).offset, errors::kNoSavedModes,
                    "M72 without M70: no modes are saved here");
      }
      bring_back(*saved_modes_.back());
      return true;
    default:
      return true;
  }
}

// Only whether there is a tool offset comes back, as with LinuxCNC: an offset that is in force may
// belong to a tool that came into the spindle meanwhile.
void Interpreter::bring_back_tool_offset(const ModalState& from) {
  if (from.tool_length_active == state_.tool_length_active) {
    return;
  }
  state_.tool_length_active = from.tool_length_active;
  if (!from.tool_length_active) {
    state_.coordinates.set_tool({});
  } else if (from.loaded_tool == state_.loaded_tool) {
    state_.coordinates.set_tool(from.coordinates.tool_mm());
  } else if (const Tool* const tool = machine_.tools.find(state_.loaded_tool)) {
    state_.coordinates.set_tool(tool->offset_mm);
  }
}

void Interpreter::bring_back(const SavedModes& saved) {
  const ModalState before = state_;
  restore_modes(saved, state_);
  bring_back_tool_offset(saved.state);
  if (compensation_.on()) {
    keep_contour_in_place(before);
  }
  if (state_.spindle != before.spindle || state_.spindle_speed != before.spindle_speed) {
    if (state_.spindle == Spindle::off) {
      push_event(EventKind::spindle_off, 0.0);
    } else {
      push_move().shape = turn_spindle(state_.spindle);
    }
  }
  if (state_.mist == before.mist && state_.flood == before.flood) {
    return;
  }
  if ((before.mist && !state_.mist) || (before.flood && !state_.flood)) {
    push_event(EventKind::coolant_off, 0.0);
  }
  if (state_.mist) {
    push_event(EventKind::mist_on, 0.0);
  }
  if (state_.flood) {
    push_event(EventKind::flood_on, 0.0);
  }
}

void Interpreter::enter_subprogram() {
  saved_modes_.emplace_back();
}

void Interpreter::leave_subprogram() {
  if (saved_modes_.size() == 1) {
    return;
  }
  const std::optional<SavedModes> saved = std::move(saved_modes_.back());
  saved_modes_.pop_back();
  if (saved && saved->restore_at_return) {
    bring_back(*saved);
  }
}

}  // namespace kerf::parser
