#include "bench/part_run.hpp"

#include <chrono>
#include <stdexcept>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "interp/setpoint.hpp"

namespace kerf::bench {

MachineSettings machine_with(const AxisSet& axes) {
  constexpr double kVelocity_mm_s = 300.0;
  MachineSettings settings = default_machine();
  settings.limits.path = {};
  settings.limits.axes.fill({.velocity_mm_s = kVelocity_mm_s,
                             .acceleration_mm_s2 = axes.acceleration_mm_s2,
                             .jerk_mm_s3 = axes.jerk_mm_s3});
  return settings;
}

PartRun run_part(const PartProgram& program, const PartMode& mode, double feed_mm_min,
                 const AxisSet& axes, profiles::ProfileKind profile) {
  using Clock = std::chrono::steady_clock;
  const MachineSettings settings = machine_with(axes);
  Kernel kernel(settings, {.profile = profiles::Profile(profile), .start_mm = program.start_mm});
  Ticks ticks;
  const Clock::time_point began = Clock::now();
  kernel.feed("G21 G90 G17 G94 " + mode.codes + " F" + std::to_string(feed_mm_min) + "\n");
  kernel.feed(program.body);
  kernel.finish();
  interp::TickStatus status = interp::TickStatus::running;
  for (interp::Setpoint setpoint; status == interp::TickStatus::running;) {
    status = kernel.next(setpoint);
    ticks.at_mm.push_back(setpoint.position_mm);
    ticks.line.push_back(setpoint.line);
  }
  const std::chrono::duration<double> wall = Clock::now() - began;
  if (kernel.has_errors() || status != interp::TickStatus::finished) {
    throw std::runtime_error(kernel.diagnostics().empty()
                                 ? "a program starves"
                                 : to_string(kernel.diagnostics().front(), "part"));
  }
  const double end_mm = distance_mm(ticks.at_mm.back(), program.path.back().to_mm);
  if (end_mm > 0.0) {
    throw std::runtime_error("a program ends beside its end");
  }
  return {.time_s = static_cast<double>(ticks.at_mm.size() - 1) * settings.limits.period_s,
          .wall_s = wall.count(),
          .lines = program.path.size(),
          .degradations = kernel.totals().degradations.count,
          .over = largest_over_limit(ticks, settings.limits),
          .deviation = deviation(ticks, program.path)};
}

}  // namespace kerf::bench
