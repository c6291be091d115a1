#include "parser/interpreter/saved_modes.hpp"

#include <utility>

#include "diagnostics/errors/pages.hpp"

namespace kerf::parser {

namespace {

// Only whether there is a tool offset comes back, as with LinuxCNC: an offset that is in force may
// belong to a tool that came into the spindle meanwhile.
void bring_back_tool_offset(const ModalState& from, const ToolTable& tools, ModalState& state) {
  if (from.tool_length_active == state.tool_length_active) {
    return;
  }
  state.tool_length_active = from.tool_length_active;
  if (!from.tool_length_active) {
    state.coordinates.set_tool({});
  } else if (from.loaded_tool == state.loaded_tool) {
    state.coordinates.set_tool(from.coordinates.tool_mm());
  } else if (const Tool* const tool = tools.find(state.loaded_tool)) {
    state.coordinates.set_tool(tool->offset_mm);
  }
}

void restore_modes(const ModalState& from, ModalState& state) {
  state.plane = from.plane;
  state.units = from.units;
  state.incremental = from.incremental;
  state.absolute_centre = from.absolute_centre;
  state.to_initial_level = from.to_initial_level;
  state.feed_mode = from.feed_mode;
  state.feedrate_mm_s = from.feedrate_mm_s;
  state.feed_per_revolution_mm = from.feed_per_revolution_mm;
  state.feed_from_other_units = from.feed_from_other_units;
  state.feed_word = from.feed_word;
  state.path_mode = from.path_mode;
  state.blend_tolerance_mm = from.blend_tolerance_mm;
  state.merge_tolerance_mm = from.merge_tolerance_mm;
  state.path_mode_by_program = from.path_mode_by_program;
  state.spindle_speed = from.spindle_speed;
  state.speed_units = from.speed_units;
  state.spindle = from.spindle;
  state.surface_speed = from.surface_speed;
  state.mist = from.mist;
  state.flood = from.flood;
  state.coordinates.select(from.coordinates.system());
  if (from.local_active != state.local_active) {
    state.local_active = from.local_active;
    if (from.local_active) {
      state.coordinates.set_local(state.stored_local_mm, state.stored_local_auxiliary_deg_mm);
    } else {
      state.coordinates.set_local({});
    }
  }
}

}  // namespace

void SavedModes::bring_back(const ModalState& saved, const ToolTable& tools, ModalState& state) {
  restore_modes(saved, state);
  bring_back_tool_offset(saved, tools, state);
}

Expected<std::optional<ModalState>> SavedModes::run(const RunningBlock& at,
                                                    const ModalState& state) {
  const Tenths code = at.codes[Group::state];
  std::optional<Entry>& here = calls_.back();
  if (code == 730 && open_calls() == 0) {
    return fail(at.code_word(Group::state).offset, errors::kNoReturnToRestoreAt,
                "M73 outside a subprogram: there is no return at which it could restore");
  }
  if (code == 720 && !here) {
    return fail(at.code_word(Group::state).offset, errors::kNoSavedModes,
                "M72 without M70: no modes are saved here");
  }
  if (code == 700 || code == 730) {
    here = Entry{state, code == 730};
  } else if (code == 710) {
    here.reset();
  }
  return code == 720 ? std::optional(here->state) : std::nullopt;
}

void SavedModes::enter_subprogram() {
  calls_.emplace_back();
}

std::optional<ModalState> SavedModes::leave_subprogram() {
  if (open_calls() == 0) {
    return std::nullopt;
  }
  std::optional<Entry> saved = std::move(calls_.back());
  calls_.pop_back();
  return saved && saved->restore_at_return ? std::optional(std::move(saved->state)) : std::nullopt;
}

}  // namespace kerf::parser
