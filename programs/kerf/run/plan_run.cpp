#include "programs/kerf/run/plan_run.hpp"

#include <string>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/progress_bar.hpp"
#include "programs/kerf/run/plan_only.hpp"

namespace kerf::program {

namespace {

PlanReport report_of(const PlannedProgram& planned, const CheckedPath& path, double period_s) {
  const PlanTotals& totals = planned.totals;
  return {.cycle_time_s = static_cast<double>(totals.ticks) * period_s,
          .ticks = totals.ticks,
          .path_length_mm = totals.path_length_mm,
          .blocks = totals.blocks,
          .extents = path.extents.value_or(curves::Extents{}),
          .extra_extents = path.extra_extents,
          .deviation = planned.deviation,
          .path_controls = planned.path_controls,
          .waits = planned.waits};
}

void explain(const BlockWatch& watch, std::uint32_t line, FileReport& report) {
  if (!watch.block()) {
    report.fail(ExitStatus::program_error,
                fmt::format("{}: line {} is never run", report.file, line));
    return;
  }
  report.block = BlockReport{.line = line,
                             .block = *watch.block(),
                             .begin_s = watch.begin_s().value_or(report.plan->cycle_time_s),
                             .duration_s = watch.duration_s()};
}

}  // namespace

void run_plan(const PlanRunOrder& order, ProgramFile& file, FileReport& report) {
  const Options& options = order.options;
  Progress progress;
  const ProgressBar bar([] { return std::string("planning"); },
                        [&] { return progress.read_share(); }, order.shows_progress);
  BlockWatch watch({.line = options.explained_line, .period_s = report.period_s});
  const auto planned = plan_only(file,
                                 {.settings = order.settings,
                                  .options = order.kernel_options,
                                  .max_time_s = options.max_time_s},
                                 progress, watch);
  if (!planned) {
    report.fail(ExitStatus::io_error, planned.error());
  } else if (!planned->errors.empty()) {
    report.take(planned->errors);
    report.status = ExitStatus::program_error;
  } else if (planned->fault) {
    report.fail(*planned->fault);
  } else if (stop_requested()) {
    report.status = *stop_requested();
  } else if (planned->too_long_at_line) {
    report.fail_too_long({*planned->too_long_at_line, options.max_time_s});
  } else {
    report.plan = report_of(*planned, order.path, report.period_s);
    report.warnings = describe(planned->totals.degradations);
    if (options.command == Subcommand::explain) {
      explain(watch, options.explained_line, report);
    }
  }
}

}  // namespace kerf::program
