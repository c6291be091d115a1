// The default table. programs/machines/table.toml says the same; a test compares every field.
#include "kernel/machine_file.hpp"

namespace kerf {

MachineSettings default_machine() {
  MachineSettings settings{};
  settings.limits.period_s = 0.001;
  settings.limits.chord_tolerance_mm = 0.001;
  settings.limits.path = {.velocity_mm_s = 250.0, .acceleration_mm_s2 = 2500.0, .jerk_mm_s3 = 50e3};
  settings.limits.axes.fill(settings.limits.path);
  settings.table.period_s = settings.limits.period_s;
  settings.table.axes.fill({.travel = {.min_mm = -300.0, .max_mm = 300.0},
                            .drive_velocity_mm_s = 500.0,
                            .drive_acceleration_mm_s2 = 20e3,
                            .screw_lead_mm = 10.0,
                            .counts_per_rev = 10'000.0,
                            .position_gain_per_s = 150.0,
                            .velocity_gain_per_s = 1500.0,
                            .velocity_integral_per_s2 = 0.0,
                            .feed_forward = 1.0,
                            .coulomb_friction_mm_s2 = 300.0,
                            .viscous_friction_per_s = 5.0,
                            .max_following_error_mm = 5.0});
  settings.table.axes[2].travel = {.min_mm = -200.0, .max_mm = 200.0};
  return settings;
}

}  // namespace kerf
