#include "programs/kerf/run/motion_run.hpp"

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/io/progress_bar.hpp"
#include "programs/kerf/run/motion_report.hpp"
#include "programs/kerf/run/output_files.hpp"
#include "programs/kerf/run/run_loop.hpp"

namespace kerf::program {

namespace {

RunOutcome run(const RunStage& stage, const MotionOrder& order, double period_s) {
  if (order.shows_progress && stage.by.has_keys()) {
    fmt::print(stderr, "{}\n", Operator::kKeys);
  }
  const ProgressBar bar([&stage] { return stage.by.status_line(stage.progress); },
                        [&stage] { return stage.progress.share(); }, order.shows_progress);
  return order.options.command == Command::run ? run_in_real_time(stage, period_s)
                                               : run_without_clock(stage);
}

struct End {
  const Kernel& kernel;
  const MachineFault& fault;
  const std::optional<std::string>& read_error;
  const RunOutcome& outcome;
  const Operator& by;
  double max_time_s;
};

// The gravest reason first.
void report_end(FileReport& report, const End& end) {
  if (const auto fault = end.kernel.fault()) {
    report.fail(*fault);
  } else if (end.outcome.hung) {
    report.fail({.line = 0, .what = "the program is read and nothing is planned"});
  } else if (end.fault.kind != machine::Fault::none) {
    report.fail(ExitStatus::machine_fault, describe(end.fault, report.period_s));
  } else if (end.outcome.gap) {
    report.fail(ExitStatus::machine_fault, describe(*end.outcome.gap, report.period_s));
  } else if (end.by.asked_for_emergency_stop()) {
    report.status = ExitStatus::emergency_stop;
  } else if (stop_requested()) {
    report.status = *stop_requested();
  } else if (end.by.asked_to_stop()) {
    report.status = ExitStatus::stopped;
  } else if (end.outcome.too_long_at_line) {
    report.fail_too_long({*end.outcome.too_long_at_line, end.max_time_s});
  } else if (end.read_error) {
    report.fail(ExitStatus::io_error, *end.read_error);
  } else if (end.kernel.has_errors()) {
    report.take(end.kernel.diagnostics());
    report.status =
        end.kernel.left_travel() ? ExitStatus::machine_fault : ExitStatus::program_error;
  } else if (report.live) {
    report.take(end.kernel.diagnostics());
  }
}

PlotCaption plot_caption(const FileReport& report) {
  const PlanReport& plan = *report.plan;
  return {
      .title = report.file,
      .subtitle = fmt::format("{} \u00b7 {:.1f} mm in {} \u00b7 {}", clock_time(plan.cycle_time_s),
                              plan.path_length_mm, counted(plan.blocks, "block"), report.profile),
      .period_s = report.period_s,
      .limits = report.limits.path,
      .deviation = plan.deviates() ? std::optional(plan.deviation) : std::nullopt};
}

}  // namespace

void run_motion(const MotionOrder& order, TextFeed& text, FileReport& report) {
  auto outputs = OutputFiles::open(order.options, order.settings,
                                   order.path.extents.value_or(curves::Extents{}));
  if (!outputs && stop_requested()) {  // a FIFO was waited for
    report.status = *stop_requested();
    return;
  }
  if (!outputs) {
    report.fail(ExitStatus::io_error, outputs.error());
    return;
  }
  report.warnings = outputs->warnings();
  const bool has_keys =
      order.options.command == Command::run && !report.live && Keyboard::has_terminal();
  KernelOptions kernel_options = order.kernel_options;
  kernel_options.waits = has_keys;
  Kernel kernel(order.settings, kernel_options);
  Progress progress;
  Feeder feeder(kernel, text, progress);
  TickStage ticks(kernel, order.settings, order.kernel_options.start_mm);
  Operator by(kernel, has_keys);
  const RunOutcome outcome =
      run({feeder, ticks, outputs->recorder(), progress, by, report.live,
           static_cast<std::int64_t>(order.options.max_time_s / report.period_s)},
          order, report.period_s);
  report_motion(report, kernel, ticks.statistics(), outcome);
  if (const auto& speed = outputs->recorder().speed) {
    report.speed = speed->report();
  }
  report_end(report,
             {kernel, ticks.fault(), feeder.error(), outcome, by, order.options.max_time_s});
  report.trace_reader_gone = outcome.trace_ended && outputs->recorder().trace->reader_gone();
  if (report.status == ExitStatus::done && order.path.extents && !outcome.trace_ended) {
    // Of the curves: ticks need not meet their extremes.
    report.plan->extents = *order.path.extents;
    report.plan->extra_extents = order.path.extra_extents;
  }
  // A run that is stopped has done what its trace says; a dry run has not shown what it was to
  // show.
  const bool is_cut = order.options.command == Command::dry_run &&
                      (stop_requested() || outcome.too_long_at_line || outcome.trace_ended);
  for (const auto& error : {outputs->close_trace(outcome.dropped_records, is_cut),
                            outputs->write_plot(plot_caption(report), is_cut)}) {
    if (error) {
      report.fail(ExitStatus::io_error, *error);
    }
  }
}

}  // namespace kerf::program
