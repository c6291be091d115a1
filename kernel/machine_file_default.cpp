// The default table. programs/machines/table.toml says the same; a test compares every field.
#include <kerf/machine.hpp>

namespace kerf {
inline namespace v0 {

MachineSettings default_machine() {
  MachineSettings settings{};
  settings.limits.period_s = 0.001;
  settings.limits.chord_tolerance_mm = 0.001;
  settings.limits.path = {.velocity_mm_s = 250.0, .acceleration_mm_s2 = 2500.0, .jerk_mm_s3 = 50e3};
  settings.limits.axes.fill(settings.limits.path);
  settings.table.period_s = settings.limits.period_s;
  for (AxisDrive& axis : settings.table.axes) {  // the servo's data are the defaults
    axis.travel = {.min_mm = -500.0, .max_mm = 500.0};
  }
  settings.table.axes[2].travel = {.min_mm = -200.0, .max_mm = 200.0};
  settings.program = default_program_data();
  TouchBox table_top;
  table_top.max_mm[2] = -150.0;
  settings.simulation.surface = table_top;
  settings.program.path_control = {.mode = PathMode::blend,
                                   .corner_tolerance_mm = settings.program.corner_tolerance_mm,
                                   .merge_tolerance_mm = settings.program.merge_tolerance_mm};
  return settings;
}

}  // namespace v0
}  // namespace kerf
