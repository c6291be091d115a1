#include "web/kernel/what_if.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace kerf::browser {

namespace {

void scale(MotionLimits& limits, const WhatIf& by) {
  limits.velocity_mm_s *= by.velocity;
  limits.acceleration_mm_s2 *= by.acceleration;
  limits.jerk_mm_s3 *= by.jerk;
}

std::optional<double> number_or_none(const nlohmann::json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

}  // namespace

WhatIf what_if_of(const nlohmann::json& question) {
  return {.velocity = question.at("velocity").get<double>(),
          .acceleration = question.at("acceleration").get<double>(),
          .jerk = question.at("jerk").get<double>(),
          .overrides = {.feed = question.at("feed").get<double>(),
                        .rapid = question.at("rapid").get<double>()},
          .corner_tolerance_mm = number_or_none(question.at("corner_tolerance_mm")),
          .merge_tolerance_mm = number_or_none(question.at("merge_tolerance_mm"))};
}

std::optional<SettingsError> change(MachineSettings& settings, const WhatIf& what_if) {
  if (!is_possible(what_if.overrides) || what_if.overrides.feed == 0.0) {
    return SettingsError{.message = "no such override: feed 1 to 200 %, rapid 5 to 100 %"};
  }
  MachineLimits& limits = settings.limits;
  scale(limits.path, what_if);
  for (MotionLimits& axis : limits.axes) {
    scale(axis, what_if);
  }
  for (MotionLimits& axis : limits.extra) {
    scale(axis, what_if);
  }
  limits.normal_acceleration_mm_s2 *= what_if.acceleration;
  limits.normal_jerk_mm_s3 *= what_if.jerk;
  for (AxisDrive& drive : settings.table.axes) {
    drive.drive_velocity_mm_s *= std::max(1.0, what_if.velocity);
    drive.drive_acceleration_mm_s2 *= std::max(1.0, what_if.acceleration);
  }
  if (what_if.corner_tolerance_mm) {
    ProgramData& program = settings.program;
    program.corner_tolerance_mm = *what_if.corner_tolerance_mm;
    program.merge_tolerance_mm = what_if.merge_tolerance_mm.value_or(program.corner_tolerance_mm);
    if (program.path_control.mode == PathMode::blend) {
      program.path_control.corner_tolerance_mm = program.corner_tolerance_mm;
      program.path_control.merge_tolerance_mm = program.merge_tolerance_mm;
    }
  }
  const auto valid = validate(settings);
  return valid ? std::nullopt : std::optional(valid.error());
}

}  // namespace kerf::browser
