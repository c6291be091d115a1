#include "programs/kerf/run/motion_run.hpp"

#include <optional>
#include <thread>
#include <utility>

#include "programs/kerf/driver/driver.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/run/machine_run.hpp"
#include "programs/kerf/run/motion_stage.hpp"
#include "programs/kerf/run/reading_ahead.hpp"

namespace kerf::program {

namespace {

// The queue between the two threads is as full as it gets.
constexpr double kFarAhead_s = 3600.0;

bool may_use_threads(MotionStage& stage) {
  return std::thread::hardware_concurrency() > 1 && stage.order().page == nullptr &&
         !stage.report().live;
}

Kernel kernel_for(MotionStage& stage, const KernelOptions& options) {
  Kernel kernel(stage.order().settings, options);
  if (const double feed = stage.order().options.feed_override; feed != 1.0) {
    kernel.set_overrides({.feed = feed});
  }
  return kernel;
}

ProgressBar progress_bar(MotionStage& stage) {
  return stage.progress_bar([] { return std::string("running  "); }, ProgressBar::Left::estimated);
}

void dry_run_in_one_thread(MotionStage& stage) {
  Kernel kernel = kernel_for(stage, stage.order().kernel_options);
  KernelPlanning planning(kernel);
  Feeder feeder = stage.feeder(planning);
  RunOutcome outcome;
  {
    const auto bar = progress_bar(stage);
    outcome = run_in_one_thread(kernel, stage.stage_with(feeder));
    stage.disable();
  }
  stage.finish({kernel, feeder, outcome});
}

// Reading, planning, ticks and the machine have a thread each; the motion is the same.
void dry_run_in_threads(MotionStage& stage) {
  const MotionOrder& order = stage.order();
  KernelOptions options = order.kernel_options;
  options.horizon_s = kFarAhead_s;
  options.reads_apart = true;
  Kernel kernel = kernel_for(stage, options);
  std::optional<ReadingAhead> reading(std::in_place, kernel, stage.text(), stage.progress());
  Feeder feeder(*reading, *reading, stage.progress());
  TickJudge judge(
      {.limits = order.settings.limits, .has_extra_axes = order.settings.program.extra_axes != 0});
  RunOutcome outcome;
  {
    const auto bar = progress_bar(stage);
    outcome = run_in_threads(kernel, stage.stage_with(feeder), judge);
    stage.disable();
  }
  reading.reset();  // what it read can be asked for
  stage.finish({kernel, feeder, outcome});
}

void dry_run(MotionStage& stage) {
  if (may_use_threads(stage)) {
    dry_run_in_threads(stage);
  } else {
    dry_run_in_one_thread(stage);
  }
}

// Returns what run_machine() does.
std::string drive(MotionStage& stage, Driver& driver) {
  const MotionOrder& order = stage.order();
  if (order.options.command == Subcommand::run || order.plan != nullptr) {
    return run_machine(stage, driver);
  }
  dry_run(stage);
  return {};
}

}  // namespace

void run_motion(const MotionOrder& order, TextFeed& text, FileReport& report) {
  const bool is_run = order.options.command == Subcommand::run;
  const bool has_clock = is_run && order.plan == nullptr;
  // A dry run shows what the simulated table does.
  auto driver = Driver::open({.driver = is_run ? order.options.driver : DriverSettings{},
                              .settings = order.settings,
                              .record_file = order.options.record_file,
                              .replay_file = order.options.replay_file,
                              .has_clock = has_clock});
  if (!driver) {
    report.fail(ExitStatus::io_error, driver.error());
    return;
  }
  const curves::Extents extents = order.path.extents.value_or(curves::Extents{});
  auto outputs =
      OutputFiles::open(order.options, order.settings, order.path.cutting.value_or(extents));
  if (!outputs && stop_requested()) {  // a FIFO was waited for
    report.status = *stop_requested();
    return;
  }
  if (!outputs) {
    report.fail(ExitStatus::io_error, outputs.error());
    return;
  }
  for (const auto& warnings : {outputs->warnings(), driver->warnings()}) {
    report.warnings.insert(report.warnings.end(), warnings.begin(), warnings.end());
  }
  if (order.page != nullptr && order.page->wants_motion) {
    order.page->motion.emplace(
        TickColumns::Settings{.period_s = report.period_s,
                              .extra = extra_axes(order.settings.program.extra_axes),
                              .max_columns = order.page->max_columns,
                              .window = order.page->window},
        extents);
    order.page->motion->set_watch(order.page->watch);
    outputs->recorder().page = &*order.page->motion;
  }
  if (outputs->recorder().plot && order.path.scan) {
    outputs->recorder().plot->add_scan(*order.path.scan);
  }
  MotionStage stage(order, {.text = text, .outputs = *outputs, .report = report},
                    driver->machine());
  if (const auto error = driver->finish(drive(stage, *driver))) {
    report.fail(ExitStatus::io_error, *error);
  }
  if (const std::size_t left = driver->calls_left();
      left > 0 && report.status == ExitStatus::done && !report.trace_reader_gone) {
    report.fail(ExitStatus::machine_fault,
                "the run ended before its record, which goes on for " + counted(left, "call"));
  }
}

}  // namespace kerf::program
