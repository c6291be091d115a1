#include "kernel/machine_settings_check.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <kerf/kernel.hpp>

#include "kernel/machine_file_checks.hpp"
#include "kernel/machine_file_schema.hpp"
#include "kernel/machine_file_text.hpp"
#include "lookahead/path/limits.hpp"
#include "machine/simulated_world.hpp"
#include "parser/moves/move.hpp"

namespace kerf {
namespace {

using Result = tl::expected<void, SettingsFault>;

struct Numbers {
  std::string section;
  std::span<const NumberRule> rules;
  std::size_t axis = 0;

  [[nodiscard]] std::string path_to(std::size_t rule) const {
    return section + "." + std::string(rules[rule].key);
  }
};

Result check(const Numbers& numbers, MachineSettings& settings) {
  for (std::size_t i = 0; i < numbers.rules.size(); ++i) {
    if (const auto problem = range_problem(numbers.rules[i], settings, numbers.axis)) {
      return SettingsFault::of(numbers.path_to(i), *problem);
    }
  }
  return {};
}

Result check_travel(const Numbers& numbers, MachineSettings& settings) {
  if (const auto problem = travel_problem(numbers.rules, settings, numbers.axis)) {
    return SettingsFault::of(numbers.path_to(1), *problem);
  }
  return {};
}

bool has_extra_axis(const MachineSettings& settings, std::size_t axis) {
  return (settings.program.extra_axes & parser::letter_bit(parser::kAuxiliaryNames[axis])) != 0;
}

std::string path_to_extra(std::size_t axis) {
  return std::string("axes.") + "abcuvw"[axis];
}

Result check_axis_with_travel(const Numbers& numbers, MachineSettings& settings) {
  return check(numbers, settings).and_then([&] { return check_travel(numbers, settings); });
}

Result check_axes(MachineSettings& settings) {
  Result result;
  for (std::size_t axis = 0; axis < 3 && result; ++axis) {
    result =
        check_axis_with_travel({std::string("axes.") + "xyz"[axis], axis_rules(), axis}, settings);
  }
  for (std::size_t axis = 0; axis < curves::kAuxiliaryAxes && result; ++axis) {
    if (has_extra_axis(settings, axis)) {
      result = check_axis_with_travel(
          {path_to_extra(axis), extra_axis_rules(parser::is_rotary(axis)), axis}, settings);
    }
  }
  return result;
}

Result check_offsets(MachineSettings& settings) {
  for (std::size_t section = 0; section < offset_sections().size(); ++section) {
    const std::string name = "offsets." + std::string(offset_sections()[section]);
    if (auto result = check({name, offset_rules(section), section}, settings); !result) {
      return result;
    }
  }
  return {};
}

// As tool_rules() has them.
std::array<double, 6> numbers_of(const Tool& tool) {
  return {static_cast<double>(tool.number),
          static_cast<double>(tool.pocket),
          tool.diameter_mm,
          tool.offset_mm[0],
          tool.offset_mm[1],
          tool.offset_mm[2]};
}

Result check_tools(const MachineSettings& settings) {
  for (const Tool& tool : settings.program.tools.listed()) {
    const auto numbers = numbers_of(tool);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const NumberRule& rule = tool_rules()[i];
      if (const auto problem = range_problem(rule, numbers[i])) {
        return SettingsFault::of("tools.tool." + std::string(rule.key),
                                 "of T" + std::to_string(tool.number) + " " + *problem);
      }
    }
  }
  return {};
}

Result check_faces(const TouchBox& box, MachineSettings& settings) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Numbers faces{"probe", probe_rules().subspan(2 * axis, 2)};
    if (auto result = check(faces, settings); !result) {
      return result;
    }
    if (box.max_mm[axis] < box.min_mm[axis]) {
      return SettingsFault::of(faces.path_to(1), "must not be below " + faces.path_to(0));
    }
  }
  return {};
}

Result check_simulation(MachineSettings& settings) {
  const std::optional<TouchSurface>& surface = settings.simulation.surface;
  if (const auto* box =
          surface && surface->shape == TouchSurface::Shape::box ? &surface->box : nullptr) {
    if (auto result = check_faces(*box, settings); !result) {
      return result;
    }
  }
  const double spindle_rad_s2 = settings.simulation.spindle_rad_s2;
  if (!(spindle_rad_s2 >= 0.0 && std::isfinite(spindle_rad_s2))) {
    return SettingsFault::of("simulation.spindle_rad_s2",
                             "found " + text_of(spindle_rad_s2) + ", expected 0 or more");
  }
  for (const double value : settings.simulation.analog) {
    if (!std::isfinite(value)) {
      return SettingsFault::of("simulation.analog",
                               "found " + text_of(value) + ", expected finite numbers");
    }
  }
  return machine::is_valid(settings.simulation)
             ? Result{}
             : SettingsFault::of("probe", "a number of the surface is impossible");
}

Result check_homing(const MachineSettings& settings) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (settings.manual.homing[axis].search_mm_s == 0.0) {
      return SettingsFault::of(std::string("axes.") + "xyz"[axis] + ".home_search_mm_s",
                               "found 0, expected a number that is not 0: its sign is the "
                               "direction");
    }
  }
  return {};
}

Result check_enumerations_and_table(const MachineSettings& settings) {
  if (const auto problem = range_problem(tick_rules().front(), settings.table.period_s)) {
    return SettingsFault::of("table.period_s", *problem);
  }
  if (settings.dialect > Dialect::fanuc) {
    return SettingsFault::of("dialect", "expected rs274 or fanuc");
  }
  return {};
}

Result check_inputs(const MachineSettings& settings) {
  for (const InputRule& rule : input_rules()) {
    const auto number = settings.program.feed_inputs.*rule.field;
    if (const auto problem = number ? input_problem(rule, *number) : std::nullopt) {
      return SettingsFault::of("inputs." + std::string(rule.number.key), *problem);
    }
  }
  return {};
}

Result check_path_mode(const MachineSettings& settings) {
  constexpr double kMax_mm = 1e3;
  const PathControl& path = settings.program.path_control;
  for (const double tolerance_mm : {path.corner_tolerance_mm, path.merge_tolerance_mm}) {
    if (!(tolerance_mm >= 0.0 && tolerance_mm <= kMax_mm)) {
      return SettingsFault::of("program.path_mode", "found a tolerance of " +
                                                        text_of(tolerance_mm) +
                                                        " mm, expected 0 to " + text_of(kMax_mm));
    }
  }
  return {};
}

// What a plan needs beside possible numbers.
Result check_bounds(MachineSettings& settings) {
  for (std::size_t axis = 0; axis < curves::kAuxiliaryAxes; ++axis) {
    for (const NumberRule& rule : extra_axis_rules(parser::is_rotary(axis)).last(3)) {
      if (has_extra_axis(settings, axis) && rule.field(settings, axis) == rule.open) {
        return SettingsFault::of(path_to_extra(axis) + "." + std::string(rule.key),
                                 "expected a limit, which this axis must have",
                                 errors::kMachineWithoutLimit);
      }
    }
  }
  const char* const quantity = lookahead::unbounded(settings.limits);
  for (const BoundRule& rule : bound_rules()) {
    if (quantity != nullptr && rule.quantity == quantity) {
      return SettingsFault::of("path." + std::string(rule.key),
                               "nothing bounds the " + std::string(quantity) +
                                   ", expected a limit here or in every axis",
                               errors::kMachineWithoutLimit);
    }
  }
  return {};
}

}  // namespace

inline namespace v0 {
bool is_possible(const Tool& tool) noexcept {
  const auto numbers = numbers_of(tool);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!(numbers[i] >= tool_rules()[i].min && numbers[i] <= tool_rules()[i].max)) {
      return false;
    }
  }
  return true;
}
}  // namespace v0

tl::expected<void, SettingsFault> check_machine(MachineSettings settings) {
  return check({"tick", tick_rules()}, settings)
      .and_then([&] {
        return check({"path", path_rules()}, settings);
      })
      .and_then([&] { return check_axes(settings); })
      .and_then([&] { return check_homing(settings); })
      .and_then([&] { return check_enumerations_and_table(settings); })
      .and_then([&] { return check_offsets(settings); })
      .and_then([&] { return check_tools(settings); })
      .and_then([&] { return check_simulation(settings); })
      .and_then([&] {
        return check({"program", program_rules()}, settings);
      })
      .and_then([&] {
        return check({"manual", manual_rules()}, settings);
      })
      .and_then([&] { return check_inputs(settings); })
      .and_then([&] { return check_path_mode(settings); })
      .and_then([&] { return check_bounds(settings); });
}

}  // namespace kerf
