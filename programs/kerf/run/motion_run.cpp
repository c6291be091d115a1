#include "programs/kerf/run/motion_run.hpp"

#include "programs/kerf/driver/driver.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/machine_run.hpp"
#include "programs/kerf/run/motion_stage.hpp"

namespace kerf::program {

namespace {

void dry_run(MotionStage& stage) {
  Kernel kernel(stage.order().settings, stage.order().kernel_options);
  KernelPlanning planning(kernel);
  Feeder feeder = stage.feeder(planning);
  RunOutcome outcome;
  {
    const auto bar =
        stage.progress_bar([] { return std::string("running  "); }, ProgressBar::Left::estimated);
    outcome = run_without_clock(kernel, stage.stage_with(feeder));
  }
  stage.finish({kernel, feeder, outcome});
}

}  // namespace

void run_motion(const MotionOrder& order, TextFeed& text, FileReport& report) {
  // A dry run shows what the simulated table does.
  const DriverSettings driver =
      order.options.command == Subcommand::run ? order.options.driver : DriverSettings{};
  auto machine = open_driver(driver, order.settings);
  if (!machine) {
    report.fail(ExitStatus::io_error, machine.error());
    return;
  }
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
  if (order.page != nullptr) {
    order.page->motion.emplace(
        TickColumns::Settings{.period_s = report.period_s,
                              .extra = extra_axes(order.settings.program.extra_axes)},
        order.path.extents.value_or(curves::Extents{}));
    outputs->recorder().page = &*order.page->motion;
  }
  if (outputs->recorder().plot && order.path.scan) {
    outputs->recorder().plot->add_scan(*order.path.scan);
  }
  MotionStage stage(order, {.text = text, .outputs = *outputs, .report = report},
                    *std::move(machine));
  if (order.options.command == Subcommand::run) {
    run_machine(stage);
  } else {
    dry_run(stage);
  }
}

}  // namespace kerf::program
