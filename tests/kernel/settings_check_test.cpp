// Row 52 of the faults: a limit of 0, a negative one or one that is no number, on one axis.
#include "kernel/settings_check.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/machine.hpp>

#include "curves/position.hpp"
#include "diagnostics/errors/pages.hpp"
#include "interp/setpoint.hpp"
#include "kernel/machine_file_schema.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/moves/auxiliary_axes.hpp"
#include "profiles/profile.hpp"

namespace kerf::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

MachineSettings machine_with_everything() {
  MachineSettings settings = default_machine();
  settings.program.extra_axes = parser::kAuxiliaryLetters;
  settings.limits.extra.fill(settings.limits.path);
  settings.simulation.surface.emplace();
  return settings;
}

struct Field {
  std::string name;
  const NumberRule* rule;
  std::size_t axis = 0;
};

std::vector<Field> all_fields() {
  std::vector<Field> fields;
  const auto add = [&](const std::string& section, std::span<const NumberRule> rules,
                       std::size_t axis) {
    for (const NumberRule& rule : rules) {
      fields.push_back({section + "." + std::string(rule.key), &rule, axis});
    }
  };
  add("tick", tick_rules(), 0);
  add("path", path_rules(), 0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    add(std::string("axes.") + "xyz"[axis], axis_rules(), axis);
  }
  for (std::size_t axis = 0; axis < curves::kAuxiliaryAxes; ++axis) {
    add(std::string("axes.") + "abcuvw"[axis], extra_axis_rules(axis < 3), axis);
  }
  for (std::size_t section = 0; section < offset_sections().size(); ++section) {
    add("offsets." + std::string(offset_sections()[section]), offset_rules(section), section);
  }
  add("probe", probe_rules(), 0);
  add("program", program_rules(), 0);
  return fields;
}

void expect_named(const std::vector<diagnostics::Diagnostic>& diagnostics, const std::string& field,
                  const diagnostics::ErrorPage& page) {
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].page, &page);
  EXPECT_EQ(diagnostics[0].message.find(field + ": "), 0U) << diagnostics[0].message;
}

// The kernel and the check end at once, with an error that names the field.
void expect_refused(const MachineSettings& settings, const KernelOptions& options,
                    const std::string& field,
                    const diagnostics::ErrorPage& page = errors::kImpossibleSetting) {
  SCOPED_TRACE(field);
  constexpr std::string_view kProgram = "G1 X10 F600\nM2\n";
  Kernel kernel(settings, options);
  kernel.feed(kProgram);
  kernel.finish();
  interp::Setpoint setpoint;
  EXPECT_EQ(kernel.next(setpoint), interp::TickStatus::failed);
  EXPECT_EQ(setpoint.v_mm_s, 0.0);
  EXPECT_TRUE(kernel.has_errors());
  bool given = false;
  const CheckReport report = check_program(
      [&]() -> std::string_view { return std::exchange(given, true) ? "" : kProgram; }, settings,
      options);
  expect_named(kernel.diagnostics(), field, page);
  if (&page != &errors::kMachineWithoutLimit) {  // a program may be read for any machine
    expect_named(report.diagnostics, field, page);
  }
}

// Found by reading: a bad horizon opened a clamp.
TEST(SettingsCheck, ARefusedProgramLeavesOutputsAsTheyAre) {
  KernelOptions options;
  options.horizon_s = 0.0;
  options.start_outputs.digital = 0xffU;
  options.start_outputs.tool = 7;
  options.start_outputs.flood = true;
  Kernel kernel(default_machine(), options);
  kernel.feed("G1 X10 F600\nM2\n");
  kernel.finish();
  interp::Setpoint setpoint;
  EXPECT_EQ(kernel.next(setpoint), interp::TickStatus::failed);
  EXPECT_EQ(setpoint.outputs, options.start_outputs);
}

TEST(SettingsCheck, Row52RefusesAnImpossibleValueOfEveryFieldOfTheMachine) {
  const std::vector<Field> fields = all_fields();
  ASSERT_GT(fields.size(), 200U);
  for (const auto& [name, rule, axis] : fields) {
    std::vector<double> values{kNan, 1.001 * rule->max * rule->factor + 1e-3};
    if (rule->min > 0.0) {
      values.insert(values.end(), {0.0, -0.0, -rule->max, rule->min * rule->factor / 2});
    } else {
      values.push_back(1.001 * rule->min * rule->factor - 1e-3);
    }
    for (const double infinite : {kUnbounded, -kUnbounded}) {
      if (infinite != rule->open) {
        values.push_back(infinite);
      }
    }
    for (const double value : values) {
      MachineSettings settings = machine_with_everything();
      rule->field(settings, axis) = value;
      const auto result = validate(settings);
      ASSERT_FALSE(result) << name << " = " << value;
      EXPECT_EQ(result.error().message.find(name + ": found "), 0U) << result.error().message;
    }
    MachineSettings settings = machine_with_everything();
    rule->field(settings, axis) = kNan;
    expect_refused(settings, {}, name);
  }
}

TEST(SettingsCheck, TakesEveryFieldAtBothEndsOfItsRangeAndOpenWhereItMayBe) {
  EXPECT_TRUE(validate(machine_with_everything()));
  for (const auto& [name, rule, axis] : all_fields()) {
    std::vector<double> values{rule->min * rule->factor, rule->max * rule->factor};
    if (rule->open != 0.0) {
      values.push_back(rule->open);
    }
    for (const double value : values) {
      MachineSettings settings = machine_with_everything();
      rule->field(settings, axis) = value;
      const auto result = validate(settings);
      const bool is_end_of_travel =
          rule->key.substr(1, 3) == "in_" || rule->key.substr(1, 3) == "ax_";
      EXPECT_TRUE(result || is_end_of_travel)
          << name << " = " << value << ", " << result.error().message;
    }
  }
}

TEST(SettingsCheck, WantsTravelToHaveALength) {
  MachineSettings settings = machine_with_everything();
  settings.table.axes[1].travel = {.min_mm = 3.0, .max_mm = 3.0};
  expect_refused(settings, {}, "axes.y.max_mm");
  settings = machine_with_everything();
  settings.table.extra[2] = {.min_rad_mm = 3.0, .max_rad_mm = -3.0};
  expect_refused(settings, {}, "axes.c.max_deg");
  settings = machine_with_everything();
  auto& box = settings.simulation.surface->box;
  box.min_mm[2] = 1.0;
  box.max_mm[2] = 0.0;
  expect_refused(settings, {}, "probe.z_max_mm");
}

TEST(SettingsCheck, WantsEachQuantityBounded) {
  using lookahead::MotionLimits;
  const std::vector<std::pair<std::string, double MotionLimits::*>> quantities{
      {"max_velocity_mm_s", &MotionLimits::velocity_mm_s},
      {"max_acceleration_mm_s2", &MotionLimits::acceleration_mm_s2},
      {"max_jerk_mm_s3", &MotionLimits::jerk_mm_s3}};
  for (const auto& [key, quantity] : quantities) {
    MachineSettings settings = default_machine();
    settings.limits.path.*quantity = kUnbounded;
    EXPECT_TRUE(validate(settings));
    settings.limits.axes[2].*quantity = kUnbounded;
    expect_refused(settings, {}, "path." + key, errors::kMachineWithoutLimit);
    settings = machine_with_everything();
    settings.limits.extra[5].*quantity = kUnbounded;
    expect_refused(settings, {}, "axes.w." + key, errors::kMachineWithoutLimit);
  }
}

TEST(SettingsCheck, LooksAtToolsAndAtFurtherAxesOnlyWhereTheMachineHasThem) {
  MachineSettings settings = default_machine();
  settings.limits.extra[0].jerk_mm_s3 = -1.0;
  EXPECT_TRUE(validate(settings));
  settings.program.tools.put({.number = 7, .offset_mm = {0.0, 0.0, kNan}});
  expect_refused(settings, {}, "tools.tool.z_mm");
  settings.program.tools.put({.number = 7, .diameter_mm = -1.0});
  expect_refused(settings, {}, "tools.tool.diameter_mm");
}

TEST(SettingsCheck, RefusesAnInputThatNoMachineHas) {
  for (const std::int32_t number : {-1, 64}) {
    MachineSettings settings = default_machine();
    settings.program.feed_inputs.feed_stop = number;
    expect_refused(settings, {}, "inputs.feed_stop");
  }
}

TEST(SettingsCheck, RefusesWhatTheMachineFileRefusesOrCannotSay) {
  const auto expect = [](const std::string& field,
                         const std::function<void(MachineSettings&)>& set) {
    MachineSettings settings = default_machine();
    set(settings);
    ASSERT_FALSE(validate(settings)) << field;
    expect_refused(settings, {}, field);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    expect(std::string("axes.") + "xyz"[axis] + ".home_search_mm_s",
           [=](MachineSettings& settings) { settings.manual.homing[axis].search_mm_s = 0.0; });
  }
  for (const double found : {-1.0, kUnbounded, kNan}) {
    expect("simulation.spindle_rad_s2",
           [=](MachineSettings& settings) { settings.simulation.spindle_rad_s2 = found; });
    expect("table.period_s", [=](MachineSettings& settings) { settings.table.period_s = found; });
  }
  expect("simulation.analog",
         [](MachineSettings& settings) { settings.simulation.analog[3] = kUnbounded; });
  expect("probe", [](MachineSettings& settings) {
    settings.simulation.surface.emplace().shape = TouchSurface::Shape::sphere;
    settings.simulation.surface->sphere.radius_mm = 0.0;
  });
  expect("dialect", [](MachineSettings& settings) { settings.dialect = static_cast<Dialect>(9); });
}

TEST(SettingsCheck, RefusesImpossibleOptions) {
  const auto expect = [](const std::string& field, const std::function<void(KernelOptions&)>& set) {
    KernelOptions options;
    set(options);
    ASSERT_FALSE(validate(options)) << field;
    expect_refused(default_machine(), options, field);
  };
  for (const double horizon_s : {-1.0, 0.0, 1e-9, 1e300, kUnbounded, -kUnbounded, kNan}) {
    expect("horizon_s", [=](KernelOptions& options) { options.horizon_s = horizon_s; });
  }
  for (const std::size_t blocks :
       {std::size_t{0}, std::size_t{1}, std::size_t{1'000'001}, ~std::size_t{0}}) {
    expect("window_blocks", [=](KernelOptions& options) { options.window_blocks = blocks; });
  }
  for (const double nominal_s : {-1.0, kUnbounded, kNan}) {
    expect("nominal.motion_s",
           [=](KernelOptions& options) { options.nominal = NominalTime{.motion_s = nominal_s}; });
    expect("nominal.rest_s",
           [=](KernelOptions& options) { options.nominal = NominalTime{.rest_s = nominal_s}; });
  }
  expect("reads_apart",
         [](KernelOptions& options) { options.reads_apart = options.tells_operator = true; });
  expect("profile.kind",
         [](KernelOptions& options) { options.profile.kind = static_cast<ProfileKind>(99); });
  expect("dialect", [](KernelOptions& options) { options.dialect = static_cast<Dialect>(9); });
  for (const double shape : {0.0, -1.0, 5.2, kUnbounded, kNan}) {
    expect("profile.sigmoid_shape", [=](KernelOptions& options) {
      options.profile = profiles::Profile(profiles::ProfileKind::sigmoid, shape);
    });
  }
  for (const double coordinate : {1.1e6, -1.1e6, kUnbounded, -kUnbounded, kNan}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      expect("start_mm", [=](KernelOptions& options) { options.start_mm[axis] = coordinate; });
    }
    for (std::size_t axis = 0; axis < curves::kAuxiliaryAxes; ++axis) {
      expect("start_extra_rad_mm",
             [=](KernelOptions& options) { options.start_extra_rad_mm[axis] = coordinate; });
    }
  }
}

TEST(SettingsCheck, RunsAProgramToItsEndWithTheLeastOptions) {
  for (const double horizon_s : {1e-5, 1e-3, 3600.0}) {
    Kernel kernel(default_machine(), {.window_blocks = 2, .horizon_s = horizon_s});
    kernel.feed("G1 X10 F600\nG1 Y10\nG4 P0.01\nG1 X0\nM2\n");
    kernel.finish();
    interp::Setpoint setpoint;
    int ticks = 0;
    while (kernel.next(setpoint) == interp::TickStatus::running && ticks < 10'000) {
      ++ticks;
    }
    EXPECT_LT(ticks, 10'000) << horizon_s;
    EXPECT_EQ(setpoint.position_mm, (curves::Position{0.0, 10.0, 0.0}));
  }
}

TEST(SettingsCheck, LeavesTheToolWhereItIsWhereTheMachineIsImpossible) {
  MachineSettings settings = default_machine();
  settings.limits.period_s = 0.0;
  Kernel kernel(settings, {.start_mm = {1.0, 2.0, 3.0}});
  kernel.feed("G1 X10 F600\nM2\n");
  kernel.finish();
  interp::Setpoint setpoint;
  EXPECT_EQ(kernel.next(setpoint), interp::TickStatus::failed);
  EXPECT_EQ(setpoint.position_mm, (curves::Position{1.0, 2.0, 3.0}));
}

}  // namespace
}  // namespace kerf::test
