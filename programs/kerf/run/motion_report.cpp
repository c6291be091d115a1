#include "programs/kerf/run/motion_report.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/number_text.hpp"

namespace kerf::program {

void report_motion(FileReport& report, const Kernel& kernel, const RunStatistics& statistics,
                   const RunOutcome& outcome) {
  report.plan = PlanReport{.cycle_time_s = statistics.cycle_time_s(),
                           .ticks = statistics.ticks(),
                           .path_length_mm = statistics.path_length_mm(),
                           .blocks = kernel.totals().blocks,
                           .extents = statistics.extents(),
                           .extra_extents = statistics.extra_extents(),
                           .deviation = kernel.deviation(),
                           .path_controls = kernel.path_controls(),
                           .waits = kernel.waits()};
  const RunFigures figures = outcome.figures.value_or(kernel.figures());
  report.motion = MotionReport{.path = figures.path,
                               .axes = figures.axes,
                               .extra = figures.extra,
                               .chord_error_mm = figures.chord_error_mm,
                               .max_contour_error_mm = statistics.max_contour_error_mm(),
                               .mean_contour_error_mm = statistics.mean_contour_error_mm(),
                               .max_following_error_mm = statistics.max_following_error_mm(),
                               .starved_ticks = outcome.starved_ticks};
  if (report.command == Subcommand::run) {
    report.clock = ClockReport{.late_ticks = outcome.late_ticks,
                               .worst_delay_s = outcome.delays.worst_s(),
                               .delays = outcome.delays,
                               .tick_times = outcome.tick_times};
    for (const std::string& what : outcome.not_permitted) {
      report.warnings.push_back("not in real time: " + what);
    }
  }
  for (const LimitUse& use : limit_uses(*report.motion, report.limits, report.extra_axes)) {
    if (use.is_exceeded()) {
      report.warnings.push_back(describe(use));
    }
  }
  for (std::string& warning : describe(kernel.totals().degradations)) {
    report.warnings.push_back(std::move(warning));
  }
  if (outcome.starved_ticks > 0) {
    report.warnings.push_back(
        std::string(report.live ? "waited for text: " : "planning fell behind: ") +
        counted(outcome.starved_ticks, "tick") + " at rest");
  }
  if (outcome.late_ticks > 0) {
    report.warnings.push_back(counted(outcome.late_ticks, "tick") + " late by a period or more");
  }
}

namespace {

constexpr std::array<std::string_view, 13> kDriveFaultNames{
    "none",          "not_enabled",  "soft_limit",      "following_error", "not_finite",
    "another_run",   "no_answer",    "bad_answer",      "connection_lost", "encoder_jump",
    "drive_tripped", "limit_switch", "spindle_too_slow"};
static_assert(kDriveFaultNames.size() == static_cast<std::size_t>(machine::kLastDriveFault) + 1);

std::string axis_name(std::int8_t axis) {
  return {"xyzabcuvw"[static_cast<std::uint8_t>(axis) % machine::kAllAxes]};
}

}  // namespace

std::string describe(const MachineFault& fault, double period_s) {
  const std::string axis = fault.axis < 0 ? "" : " of axis " + axis_name(fault.axis);
  std::string what;
  switch (fault.kind) {
    case machine::DriveFault::soft_limit:
      what = "soft limit" + axis;
      break;
    case machine::DriveFault::following_error:
      what = "following error" + axis + " too large";
      break;
    case machine::DriveFault::not_finite:
      what = "position" + axis + " is not a number";
      break;
    case machine::DriveFault::another_run:
      what = "the run is another one than that of the record";
      break;
    case machine::DriveFault::no_answer:
      what = "the machine does not answer in time";
      break;
    case machine::DriveFault::bad_answer:
      what = "the machine answers what is no answer";
      break;
    case machine::DriveFault::connection_lost:
      what = "the machine is gone";
      break;
    case machine::DriveFault::encoder_jump:
      what = "encoder" + axis + " jumped";
      break;
    case machine::DriveFault::drive_tripped:
      what = "drive" + axis + " tripped";
      break;
    case machine::DriveFault::limit_switch:
      what = "limit switch" + axis + " closed";
      break;
    case machine::DriveFault::spindle_too_slow:
      what = "the spindle does not come to its speed";
      break;
    case machine::DriveFault::none:
    case machine::DriveFault::not_enabled:
      what = "drives not enabled";
      break;
  }
  return fmt::format("machine fault: {}, in line {}, at {}{}", what, fault.line,
                     clock_time(static_cast<double>(fault.tick) * period_s),
                     may_lose_place(fault.kind) ? "; home the machine: its place may be lost" : "");
}

FaultReport fault_report(const MachineFault& fault, double period_s) {
  return {.kind = kDriveFaultNames[static_cast<std::size_t>(fault.kind)],
          .axis = fault.axis < 0 ? "" : axis_name(fault.axis),
          .line = fault.line,
          .t_s = static_cast<double>(fault.tick) * period_s,
          .needs_homing = may_lose_place(fault.kind)};
}

FaultReport fault_report(std::string_view kind, const TickGap& gap, double period_s) {
  return {.kind = kind,
          .axis = {},
          .line = gap.line,
          .t_s = static_cast<double>(gap.tick) * period_s,
          .needs_homing = false};
}

std::string describe(const TickStage::EmergencyLoop& loop, double period_s) {
  return fmt::format("emergency stop: its loop is open, in line {}, at {}", loop.line,
                     clock_time(static_cast<double>(loop.tick) * period_s));
}

std::string describe_delay(const TickGap& delay, double period_s) {
  return fmt::format(
      "machine fault: a tick came {:.3f} s late; stopped on the path, from line {}, at {}",
      delay.duration_s, delay.line, clock_time(static_cast<double>(delay.tick) * period_s));
}

std::string describe(const TickGap& gap, double period_s) {
  return fmt::format("machine fault: no tick for {:.3f} s, in line {}, at {}", gap.duration_s,
                     gap.line, clock_time(static_cast<double>(gap.tick) * period_s));
}

}  // namespace kerf::program
