// Which keys a machine file may have, what their values may be, and where they go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <kerf/machine.hpp>

namespace kerf {

// One number. The bounds are included; they are wide, but keep every product that planning forms
// far from overflow.
struct NumberRule {
  std::string_view key;
  double min = 0.0;
  double max = 0.0;
  // Where the number goes; axis is 0..2 in an [axes.*] table, the place of the section in
  // offset_sections() in an [offsets.*] table, else ignored. Null in tool_rules().
  double& (*field)(MachineSettings& settings, std::size_t axis);
  double factor = 1.0;  // from the unit of the key to the one inside
  // The infinity that stands for "does not bind" in the settings (a file leaves the key out). 0:
  // the key is required.
  double open = 0.0;
};

// "found 0, expected a number from 1 to 2"; nothing where the rule allows the number, which is in
// the unit of the key.
std::optional<std::string> range_problem(const NumberRule& rule, double number);
// The same for the value in the settings.
std::optional<std::string> range_problem(const NumberRule& rule, MachineSettings& settings,
                                         std::size_t axis);

std::span<const NumberRule> tick_rules();
std::span<const NumberRule> path_rules();
std::span<const NumberRule> axis_rules();
// Of [axes.a] to [axes.c] (rotary) or [axes.u] to [axes.w], with axis 0..5: first the travel, then
// three limits that must be there.
std::span<const NumberRule> extra_axis_rules(bool rotary);

// [offsets.*]: G54 to G59.3, then the positions of G28 and G30, which have no rotation. The keys of
// the nine axes come first.
std::span<const std::string_view> offset_sections();
std::span<const NumberRule> offset_rules(std::size_t section);
std::span<const NumberRule> program_rules();
std::span<const NumberRule> manual_rules();
// The keys of one [[tools.tool]], in the order: number, pocket, diameter, x, y, z.
std::span<const NumberRule> tool_rules();
// Lower and upper face of x, y and z in turn. Precondition of the fields: the surface is a
// TouchBox.
std::span<const NumberRule> probe_rules();

// A number of an input.
struct InputRule {
  NumberRule number;
  std::optional<std::int32_t> FeedInputNumbers::*field = nullptr;
};
std::span<const InputRule> input_rules();
// "found 1.5, expected a whole number"; nothing where the rule allows it.
std::optional<std::string> input_problem(const InputRule& rule, double number);

// The keys that bound one quantity of a plan, in [path] or in [axes.*] under the same name.
struct BoundRule {
  std::string_view key;
  std::string_view quantity;  // "velocity"
};
std::span<const BoundRule> bound_rules();

}  // namespace kerf
