#include "kernel/settings_check.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "diagnostics/errors/pages.hpp"
#include "kernel/machine_file_checks.hpp"
#include "kernel/machine_file_schema.hpp"
#include "kernel/machine_file_text.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/modal/tool_table.hpp"
#include "parser/modal/touch_box.hpp"
#include "profiles/sigmoid.hpp"

namespace kerf {
namespace {

struct Fault {
  std::string message;
  const diagnostics::ErrorPage* page = nullptr;
};

using Result = tl::expected<void, Fault>;

Result fail(const std::string& field, const std::string& problem,
            const diagnostics::ErrorPage& page = errors::kImpossibleSetting) {
  return tl::unexpected(Fault{field + ": " + problem, &page});
}

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
      return fail(numbers.path_to(i), *problem);
    }
  }
  return {};
}

Result check_travel(const Numbers& numbers, MachineSettings& settings) {
  if (const auto problem = travel_problem(numbers.rules, settings, numbers.axis)) {
    return fail(numbers.path_to(1), *problem);
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
          {path_to_extra(axis), extra_axis_rules(parser::turns(axis)), axis}, settings);
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

Result check_tools(const MachineSettings& settings) {
  for (const parser::Tool& tool : settings.program.tools.listed()) {
    const std::array<double, 6> values{static_cast<double>(tool.number),
                                       static_cast<double>(tool.pocket),
                                       tool.diameter_mm,
                                       tool.offset_mm[0],
                                       tool.offset_mm[1],
                                       tool.offset_mm[2]};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const NumberRule& rule = tool_rules()[i];
      if (const auto problem = range_problem(rule, values[i])) {
        return fail("tools.tool." + std::string(rule.key),
                    "of T" + std::to_string(tool.number) + " " + *problem);
      }
    }
  }
  return {};
}

Result check_probe(MachineSettings& settings) {
  if (!settings.program.touch_box) {
    return {};
  }
  const parser::TouchBox& box = *settings.program.touch_box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Numbers faces{"probe", probe_rules().subspan(2 * axis, 2)};
    if (auto result = check(faces, settings); !result) {
      return result;
    }
    if (box.max_mm[axis] < box.min_mm[axis]) {
      return fail(faces.path_to(1), "must not be below " + faces.path_to(0));
    }
  }
  return {};
}

Result check_inputs(const MachineSettings& settings) {
  for (const InputRule& rule : input_rules()) {
    const auto number = settings.program.feed_inputs.*rule.field;
    if (const auto problem = number ? input_problem(rule, *number) : std::nullopt) {
      return fail("inputs." + std::string(rule.number.key), *problem);
    }
  }
  return {};
}

Result check_path_mode(const MachineSettings& settings) {
  constexpr double kMost_mm = 1e3;
  const PathControl& path = settings.program.path_control;
  for (const double tolerance_mm : {path.corner_tolerance_mm, path.merge_tolerance_mm}) {
    if (!(tolerance_mm >= 0.0 && tolerance_mm <= kMost_mm)) {
      return fail("program.path_mode", "found a tolerance of " + text_of(tolerance_mm) +
                                           " mm, expected 0 to " + text_of(kMost_mm));
    }
  }
  return {};
}

// What a plan needs beside possible numbers.
Result check_bounds(MachineSettings& settings) {
  for (std::size_t axis = 0; axis < curves::kAuxiliaryAxes; ++axis) {
    for (const NumberRule& rule : extra_axis_rules(parser::turns(axis)).last(3)) {
      if (has_extra_axis(settings, axis) && rule.field(settings, axis) == rule.open) {
        return fail(path_to_extra(axis) + "." + std::string(rule.key),
                    "expected a limit, which this axis must have", errors::kMachineWithoutLimit);
      }
    }
  }
  const char* const quantity = lookahead::unbounded(settings.limits);
  for (const BoundRule& rule : bound_rules()) {
    if (quantity != nullptr && rule.quantity == quantity) {
      return fail("path." + std::string(rule.key),
                  "nothing bounds the " + std::string(quantity) +
                      ", expected a limit here or in every axis",
                  errors::kMachineWithoutLimit);
    }
  }
  return {};
}

// By value: the rules say where a number stands by a reference to it.
Result check_machine(MachineSettings settings) {
  return check({"tick", tick_rules()}, settings)
      .and_then([&] {
        return check({"path", path_rules()}, settings);
      })
      .and_then([&] { return check_axes(settings); })
      .and_then([&] { return check_offsets(settings); })
      .and_then([&] { return check_tools(settings); })
      .and_then([&] { return check_probe(settings); })
      .and_then([&] {
        return check({"program", program_rules()}, settings);
      })
      .and_then([&] { return check_inputs(settings); })
      .and_then([&] { return check_path_mode(settings); })
      .and_then([&] { return check_bounds(settings); });
}

Result check_option(const NumberRule& rule, double found) {
  if (const auto problem = range_problem(rule, found)) {
    return fail(std::string(rule.key), *problem);
  }
  return {};
}

Result check_start(const KernelOptions& options) {
  constexpr double kFarthest = 1e6;
  for (const double coordinate : options.start_mm) {
    if (auto result = check_option({"start_mm", -kFarthest, kFarthest, nullptr}, coordinate);
        !result) {
      return result;
    }
  }
  for (const double coordinate : options.start_extra_rad_mm) {
    if (auto result =
            check_option({"start_extra_rad_mm", -kFarthest, kFarthest, nullptr}, coordinate);
        !result) {
      return result;
    }
  }
  return {};
}

Result check_options(const KernelOptions& options) {
  using profiles::Sigmoid;
  const NumberRule shape{"profile.sigmoid_shape", Sigmoid::kSmallestShape, Sigmoid::kLargestShape,
                         nullptr};
  return check_option(shape, options.profile.sigmoid_shape.value_or(shape.min))
      .and_then([&] {
        return check_option({"window_blocks", 2, double{kMaxWindowBlocks}, nullptr},
                            static_cast<double>(options.window_blocks));
      })
      .and_then([&] {
        return check_option({"horizon_s", 1e-5, 3600.0, nullptr}, options.horizon_s);
      })
      .and_then([&] { return check_start(options); });
}

tl::expected<void, SettingsError> without_page(const Result& result) {
  return result.map_error(
      [](const Fault& fault) { return SettingsError{.message = fault.message}; });
}

}  // namespace

inline namespace v0 {

tl::expected<void, SettingsError> validate(const MachineSettings& settings) {
  return without_page(check_machine(settings));
}

tl::expected<void, SettingsError> validate(const KernelOptions& options) {
  return without_page(check_options(options));
}

bool is_possible(const Overrides& overrides) noexcept {
  const auto is_within = [](double value, double least, double most) {
    return least <= value && value <= most;
  };
  return is_within(overrides.feed, 0.0, 2.0) && is_within(overrides.rapid, 0.05, 1.0) &&
         is_within(overrides.spindle, 0.1, 2.0);
}

bool is_possible(const FeedInputs& inputs) noexcept {
  return 0.0 <= inputs.adaptive && inputs.adaptive <= 1.0;
}

}  // namespace v0

std::optional<diagnostics::Diagnostic> settings_fault(const MachineSettings& settings,
                                                      const KernelOptions& options) {
  const Result result = check_options(options).and_then([&] { return check_machine(settings); });
  if (result) {
    return std::nullopt;
  }
  return diagnostics::Diagnostic({.line = 1, .column = 1}, *result.error().page,
                                 result.error().message);
}

KernelOptions resting_options(const KernelOptions& given) {
  return check_start(given) ? KernelOptions{.start_mm = given.start_mm,
                                            .start_extra_rad_mm = given.start_extra_rad_mm}
                            : KernelOptions{};
}

}  // namespace kerf
