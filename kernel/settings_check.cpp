#include "kernel/settings_check.hpp"

#include <limits>
#include <string>

#include "kernel/machine_file_schema.hpp"
#include "kernel/machine_settings_check.hpp"
#include "profiles/sigmoid.hpp"

namespace kerf {
namespace {

using Result = tl::expected<void, SettingsFault>;

Result check_option(const NumberRule& rule, double found) {
  if (const auto problem = range_problem(rule, found)) {
    return SettingsFault::of(std::string(rule.key), *problem);
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
  if (options.profile.kind > ProfileKind::time_optimal) {
    return SettingsFault::of("profile.kind", "expected a kind of profile");
  }
  if (options.dialect.value_or(Dialect::rs274) > Dialect::fanuc) {
    return SettingsFault::of("dialect", "expected rs274 or fanuc");
  }
  if (options.reads_apart && options.tells_operator) {
    return SettingsFault::of("reads_apart", "expected false where tells_operator is true");
  }
  return check_option(shape, options.profile.sigmoid_shape.value_or(shape.min))
      .and_then([&] {
        return check_option({"window_blocks", 2, double{kMaxWindowBlocks}, nullptr},
                            static_cast<double>(options.window_blocks));
      })
      .and_then([&] {
        return check_option({"horizon_s", 1e-5, 3600.0, nullptr}, options.horizon_s);
      })
      .and_then([&] {
        const NominalTime nominal = options.nominal.value_or(NominalTime{});
        constexpr double kMax_s = std::numeric_limits<double>::max();
        return check_option({"nominal.motion_s", 0.0, kMax_s, nullptr}, nominal.motion_s)
            .and_then([&] {
              return check_option({"nominal.rest_s", 0.0, kMax_s, nullptr}, nominal.rest_s);
            })
            .and_then([&] {
              return check_option({"nominal.rapid_s", 0.0, kMax_s, nullptr}, nominal.rapid_s);
            })
            .and_then([&] {
              return check_option({"nominal.steady_s", 0.0, kMax_s, nullptr}, nominal.steady_s);
            })
            .and_then([&] {
              return check_option({"nominal.spindle_s", 0.0, kMax_s, nullptr}, nominal.spindle_s);
            })
            .and_then([&] {
              return check_option({"nominal.spindle_alone_s", 0.0, kMax_s, nullptr},
                                  nominal.spindle_alone_s);
            });
      })
      .and_then([&] { return check_start(options); });
}

tl::expected<void, SettingsError> without_page(const Result& result) {
  return result.map_error(
      [](const SettingsFault& fault) { return SettingsError{.message = fault.message}; });
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
  const auto is_within = [](double value, double min, double max) {
    return min <= value && value <= max;
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
  KernelOptions options;
  if (check_start(given)) {
    options.start_mm = given.start_mm;
    options.start_extra_rad_mm = given.start_extra_rad_mm;
  }
  options.start_outputs = given.start_outputs;
  options.begins_with = given.begins_with;
  options.tells_operator = given.tells_operator;
  return options;
}

}  // namespace kerf
