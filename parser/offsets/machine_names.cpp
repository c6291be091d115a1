// The predefined names of MachineValues: #<_x>, #<_feed> and their like.
#include <algorithm>
#include <array>

#include "parser/offsets/machine_values.hpp"

namespace kerf::parser {

namespace {

constexpr double kVersion = 2.9;  // of the LinuxCNC whose language this is

double flag(bool set) {
  return set ? 1.0 : 0.0;
}

double code_of(Plane plane) {
  return plane == Plane::xy ? 170.0 : plane == Plane::zx ? 180.0 : 190.0;
}

// Ten times the G number of a work offset.
double code_of_system(std::size_t system) {
  return system < 6 ? 540.0 + 10.0 * static_cast<double>(system)
                    : 590.0 + static_cast<double>(system - 5);
}

// The axis that the letter after `prefix` names, X to W; nothing where `name` is something else.
std::optional<std::size_t> axis_behind(std::string_view prefix, std::string_view name) {
  constexpr std::string_view kLetters = "xyzabcuvw";
  if (name.size() != prefix.size() + 1 || name.substr(0, prefix.size()) != prefix) {
    return std::nullopt;
  }
  const std::size_t axis = kLetters.find(name.back());
  return axis == std::string_view::npos ? std::nullopt : std::optional(axis);
}

struct Entry {
  std::string_view name;
  double (*value)(const ModalState&);
};

constexpr std::array kModes{
    Entry{"_motion_mode", [](const ModalState& s) { return static_cast<double>(s.motion); }},
    Entry{"_plane", [](const ModalState& s) { return code_of(s.plane); }},
    Entry{"_ccomp", [](const ModalState& s) { return static_cast<double>(s.cutter_compensation); }},
    Entry{"_metric", [](const ModalState& s) { return flag(s.units == Units::mm); }},
    Entry{"_imperial", [](const ModalState& s) { return flag(s.units == Units::inch); }},
    Entry{"_absolute", [](const ModalState& s) { return flag(!s.incremental); }},
    Entry{"_incremental", [](const ModalState& s) { return flag(s.incremental); }},
    Entry{"_inverse_time",
          [](const ModalState& s) { return flag(s.feed_mode == FeedMode::inverse_time); }},
    Entry{"_units_per_minute",
          [](const ModalState& s) { return flag(s.feed_mode == FeedMode::per_minute); }},
    Entry{"_units_per_rev",
          [](const ModalState& s) { return flag(s.feed_mode == FeedMode::per_revolution); }},
    Entry{"_coord_system",
          [](const ModalState& s) { return code_of_system(s.coordinates.system()); }},
    Entry{"_tool_offset", [](const ModalState& s) { return flag(s.tool_length_active); }},
    Entry{"_retract_r_plane", [](const ModalState& s) { return flag(!s.to_initial_level); }},
    Entry{"_retract_old_z", [](const ModalState& s) { return flag(s.to_initial_level); }},
    Entry{"_spindle_rpm_mode", [](const ModalState& s) { return flag(!s.surface_speed.active); }},
    Entry{"_spindle_css_mode", [](const ModalState& s) { return flag(s.surface_speed.active); }},
    Entry{"_ijk_absolute_mode", [](const ModalState& s) { return flag(s.absolute_centre); }},
    Entry{"_lathe_diameter_mode", [](const ModalState&) { return 0.0; }},
    Entry{"_lathe_radius_mode", [](const ModalState&) { return 1.0; }},
    Entry{"_feed", [](const ModalState& s) { return s.feed_word; }},
};

constexpr std::array kMachine{
    Entry{"_rpm", [](const ModalState& s) { return s.spindle_speed; }},
    Entry{"_spindle_on", [](const ModalState& s) { return flag(s.spindle != Spindle::off); }},
    Entry{"_spindle_cw", [](const ModalState& s) { return flag(s.spindle == Spindle::clockwise); }},
    Entry{"_mist", [](const ModalState& s) { return flag(s.mist); }},
    Entry{"_flood", [](const ModalState& s) { return flag(s.flood); }},
    Entry{"_speed_override", [](const ModalState& s) { return flag(s.overrides.speed); }},
    Entry{"_feed_override", [](const ModalState& s) { return flag(s.overrides.feed); }},
    Entry{"_adaptive_feed", [](const ModalState& s) { return flag(s.overrides.adaptive_feed); }},
    Entry{"_feed_hold", [](const ModalState& s) { return flag(s.overrides.feed_hold); }},
    Entry{"_current_tool", [](const ModalState& s) { return static_cast<double>(s.loaded_tool); }},
    Entry{"_selected_tool", [](const ModalState& s) { return s.tool; }},
    Entry{"_vmajor", [](const ModalState&) { return kVersion; }},
    Entry{"_vminor", [](const ModalState&) { return 0.0; }},
    Entry{"_task", [](const ModalState&) { return 0.0; }},
    Entry{"_remap_level", [](const ModalState&) { return 0.0; }},
};

template <std::size_t kSize>
std::optional<double> value_in(const std::array<Entry, kSize>& table, std::string_view name,
                               const ModalState& state) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const Entry& entry) { return entry.name == name; });
  return found == table.end() ? std::nullopt : std::optional(found->value(state));
}

}  // namespace

std::optional<double> MachineValues::name(std::string_view name) const {
  if (name.empty() || name.front() != '_') {
    return std::nullopt;
  }
  if (const auto place_found = place(name)) {
    return place_found;
  }
  if (const auto found = value_in(kModes, name, memory_->state)) {
    return found;
  }
  if (const auto found = value_in(kMachine, name, memory_->state)) {
    return found;
  }
  return special(name);
}

// What more than the modal state is needed for.
std::optional<double> MachineValues::special(std::string_view name) const {
  const auto pocket = [this](double tool) {
    const Tool* const listed = memory_->machine.tools.find(static_cast<std::int32_t>(tool));
    return listed != nullptr ? static_cast<double>(listed->pocket) : 0.0;
  };
  if (name == "_line") {
    return static_cast<double>(memory_->line);
  }
  if (name == "_call_level") {
    return static_cast<double>(memory_->open_calls);
  }
  if (name == "_current_pocket") {
    return pocket(memory_->state.loaded_tool);
  }
  if (name == "_selected_pocket") {
    return memory_->state.tool_selected ? pocket(memory_->state.tool) : -1.0;
  }
  return std::nullopt;
}

// #<_x> in the program's coordinates, #<_abs_x> in the machine's.
std::optional<double> MachineValues::place(std::string_view name) const {
  const ModalState& state = memory_->state;
  const auto value = [&](std::size_t axis, const Point& point_mm,
                         const AuxiliaryWords& auxiliary_deg_mm) {
    const double unit = mm_per_unit(state.units);
    return axis < 3              ? point_mm[axis] / unit
           : is_rotary(axis - 3) ? auxiliary_deg_mm[axis - 3]
                                 : auxiliary_deg_mm[axis - 3] / unit;
  };
  if (const auto axis = axis_behind("_abs_", name)) {
    return value(*axis, state.position_mm, state.auxiliary_deg_mm);
  }
  const auto axis = axis_behind("_", name);
  if (!axis) {
    return std::nullopt;
  }
  return value(*axis, state.coordinates.to_program(state.position_mm),
               state.coordinates.auxiliary_to_program(state.auxiliary_deg_mm));
}

}  // namespace kerf::parser
