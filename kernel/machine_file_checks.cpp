#include "kernel/machine_file_checks.hpp"

#include <algorithm>
#include <cmath>

#include <kerf/machine.hpp>

#include "kernel/machine_file_text.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf {
namespace {

constexpr std::string_view kDriveVelocity = "drive_velocity_mm_s";
constexpr std::string_view kDriveAcceleration = "drive_acceleration_mm_s2";

void raise(double& possible, double planned) {
  if (std::isfinite(planned)) {
    possible = std::max(possible, 2.0 * planned);
  }
}

std::optional<KeyProblem> home_problem(const AxisHoming& homing, const Travel& travel) {
  const bool has_home = std::isfinite(homing.home_mm);
  const double home_mm = has_home ? homing.home_mm : homing.switch_mm;
  if (!std::isfinite(homing.switch_mm) || (home_mm >= travel.min_mm && home_mm <= travel.max_mm)) {
    return std::nullopt;
  }
  const std::string message = "found " + text_of(home_mm) + ", expected a place within the travel";
  return has_home ? KeyProblem{"home_mm", message}
                  : KeyProblem{"home_switch_mm",
                               message + ", or home_mm, where the axis goes from there"};
}

}  // namespace

void raise_silent_drive(MachineSettings& settings, std::size_t axis,
                        const std::function<bool(std::string_view)>& has_key) {
  const lookahead::MotionLimits& limits = settings.limits.axes[axis];
  const lookahead::MotionLimits& path = settings.limits.path;
  AxisDrive& drive = settings.table.axes[axis];
  if (!has_key(kDriveVelocity)) {
    raise(drive.drive_velocity_mm_s,
          std::isfinite(limits.velocity_mm_s) ? limits.velocity_mm_s : path.velocity_mm_s);
  }
  if (!has_key(kDriveAcceleration)) {
    raise(drive.drive_acceleration_mm_s2, std::isfinite(limits.acceleration_mm_s2)
                                              ? limits.acceleration_mm_s2
                                              : path.acceleration_mm_s2);
  }
}

std::optional<std::string> travel_problem(std::span<const NumberRule> rules,
                                          MachineSettings& settings, std::size_t axis) {
  const double lower = rules[0].field(settings, axis);
  const double upper = rules[1].field(settings, axis);
  if (lower < upper) {
    return std::nullopt;
  }
  return "found " + text_of(upper / rules[1].factor) + ", expected more than " +
         std::string(rules[0].key) + ", " + text_of(lower / rules[0].factor);
}

std::vector<KeyProblem> check_axis(const MachineSettings& settings, std::size_t axis,
                                   const std::function<bool(std::string_view)>& has_key) {
  const lookahead::MotionLimits& limits = settings.limits.axes[axis];
  const AxisDrive& drive = settings.table.axes[axis];
  std::vector<KeyProblem> problems;
  const auto blame = [&](std::string_view key, double found, const std::string& expected) {
    problems.push_back({key, "found " + text_of(found) + ", expected " + expected});
  };
  if (std::isfinite(limits.velocity_mm_s) && drive.drive_velocity_mm_s < limits.velocity_mm_s) {
    blame(kDriveVelocity, drive.drive_velocity_mm_s,
          "at least max_velocity_mm_s, " + text_of(limits.velocity_mm_s));
  }
  if (std::isfinite(limits.acceleration_mm_s2) &&
      drive.drive_acceleration_mm_s2 < limits.acceleration_mm_s2) {
    blame(kDriveAcceleration, drive.drive_acceleration_mm_s2,
          "at least max_acceleration_mm_s2, " + text_of(limits.acceleration_mm_s2));
  }
  if (settings.manual.homing[axis].search_mm_s == 0.0) {
    blame("home_search_mm_s", 0.0, "a number that is not 0: its sign is the direction");
  }
  if (const auto problem = home_problem(settings.manual.homing[axis], drive.travel)) {
    problems.push_back(*problem);
  }
  // An outer loop faster than the inner one oscillates, and with an integral it may be unstable.
  if (drive.position_gain_per_s > drive.velocity_gain_per_s) {
    if (has_key("position_gain_per_s")) {
      blame("position_gain_per_s", drive.position_gain_per_s,
            "at most velocity_gain_per_s, " + text_of(drive.velocity_gain_per_s));
    } else {
      blame("velocity_gain_per_s", drive.velocity_gain_per_s,
            "at least position_gain_per_s, " + text_of(drive.position_gain_per_s));
    }
  }
  return problems;
}

}  // namespace kerf
