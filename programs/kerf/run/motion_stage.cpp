#include "programs/kerf/run/motion_stage.hpp"

#include <cstdint>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/run/motion_report.hpp"

namespace kerf::program {

namespace {

PlotCaption plot_caption(const FileReport& report) {
  const PlanReport& plan = *report.plan;
  return {
      .title = report.file,
      .subtitle = fmt::format("{} \u00b7 {:.1f} mm in {} \u00b7 {}", clock_time(plan.cycle_time_s),
                              plan.path_length_mm, counted(plan.blocks, "block"), report.profile),
      .period_s = report.period_s,
      .limits = report.limits.path,
      .chord_tolerance_mm = report.limits.chord_tolerance_mm,
      .deviation = plan.deviates() ? std::optional(plan.deviation) : std::nullopt,
      .feed_unit = report.feed_unit};
}

}  // namespace

RunStage MotionStage::stage_with(Feeder& feeder) {
  return {feeder,
          ticks_,
          outputs_.recorder(),
          progress_,
          report_.live,
          static_cast<std::int64_t>(order_.options.max_time_s / report_.period_s)};
}

void MotionStage::finish(const End& end) {
  report_motion(report_, end.kernel, ticks_.statistics(), end.outcome);
  report_.motion->time = ticks_.time_split();
  if (const auto& parts = outputs_.recorder().parts) {
    report_.motion->parts = parts->parts();
  }
  if (const auto& speed = outputs_.recorder().speed) {
    report_.speed = speed->report();
  }
  report_end(end);
  if (report_.machine_fault) {
    report_.machine_fault->needs_homing |= end.is_unhomed;
  }
  const bool is_part = end.outcome.has_enough;
  const auto& trace = outputs_.recorder().trace;
  report_.trace_reader_gone = is_part && trace && trace->reader_gone();
  const bool is_whole = report_.status == ExitStatus::done && !report_.start && !is_part;
  if (is_whole && order_.path.extents) {
    // Of the curves: ticks need not meet their extremes.
    report_.plan->extents = *order_.path.extents;
    report_.plan->extra_extents = order_.path.extra_extents;
  }
  // A run that is stopped has done what its trace says; a dry run has not shown what it was to
  // show.
  const bool is_cut = order_.options.command != Subcommand::run &&
                      (stop_requested() || end.outcome.too_long_at_line || is_part);
  for (const auto& error : {outputs_.close_trace(end.outcome.dropped_records, is_cut),
                            outputs_.write_plot(plot_caption(report_), is_cut)}) {
    if (error) {
      report_.fail(ExitStatus::io_error, *error);
    }
  }
  write_flight();
}

// Of a run that the machine ended, or an operator in an emergency.
void MotionStage::write_flight() {
  const auto& file = order_.options.flight_file;
  if (!file || (report_.status != ExitStatus::machine_fault &&
                report_.status != ExitStatus::emergency_stop)) {
    return;
  }
  if (const auto error =
          ticks_.flight().write({.path = *file,
                                 .period_s = report_.period_s,
                                 .columns = {.axes = extra_axes(report_.extra_axes)}})) {
    report_.fail(ExitStatus::io_error, *error);
  }
}

// The gravest reason first.
void MotionStage::report_end(const End& end) {
  if (const auto fault = end.kernel.fault()) {
    report_.fail(*fault);
  } else if (end.outcome.hung) {
    report_.fail({.line = 0, .what = "the program is read and nothing is planned"});
  } else if (ticks_.fault().kind != machine::DriveFault::none) {
    report_.machine_fault = fault_report(ticks_.fault(), report_.period_s);
    report_.fail(ExitStatus::machine_fault, describe(ticks_.fault(), report_.period_s));
  } else if (end.outcome.gap) {
    report_.machine_fault = fault_report("no_tick", *end.outcome.gap, report_.period_s);
    report_.fail(ExitStatus::machine_fault, describe(*end.outcome.gap, report_.period_s));
  } else if (end.outcome.too_late) {
    report_.machine_fault = fault_report("late_tick", *end.outcome.too_late, report_.period_s);
    report_.fail(ExitStatus::machine_fault,
                 describe_delay(*end.outcome.too_late, report_.period_s));
  } else if (ticks_.emergency()) {
    report_.fail(ExitStatus::emergency_stop, describe(*ticks_.emergency(), report_.period_s));
  } else if (!end.no_home.empty()) {
    report_.machine_fault = {
        .kind = "homing", .axis = {}, .t_s = ticks_.statistics().cycle_time_s()};
    report_.fail(ExitStatus::machine_fault, end.no_home);
  } else if (end.is_emergency) {
    report_.status = ExitStatus::emergency_stop;
  } else if (stop_requested()) {
    report_.status = *stop_requested();
  } else if (end.is_stopped) {
    report_.status = ExitStatus::stopped;
  } else {
    report_program(end);
  }
}

// Of one that nobody ended.
void MotionStage::report_program(const End& end) {
  if (end.outcome.too_long_at_line) {
    report_.fail_too_long({*end.outcome.too_long_at_line, order_.options.max_time_s});
  } else if (end.feeder.error()) {
    report_.fail(ExitStatus::io_error, *end.feeder.error());
  } else if (end.kernel.has_errors()) {
    report_.take(end.kernel.diagnostics());
    report_.status =
        end.kernel.left_travel() ? ExitStatus::machine_fault : ExitStatus::program_error;
  } else if (report_.live) {
    report_.take(end.kernel.diagnostics());
  }
}

}  // namespace kerf::program
