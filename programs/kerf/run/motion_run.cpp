#include "programs/kerf/run/motion_run.hpp"

#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/control/channel.hpp"
#include "programs/kerf/control/keys.hpp"
#include "programs/kerf/control/message_printer.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/io/progress_bar.hpp"
#include "programs/kerf/run/motion_report.hpp"
#include "programs/kerf/run/output_files.hpp"
#include "programs/kerf/run/run_loop.hpp"

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
      .deviation = plan.deviates() ? std::optional(plan.deviation) : std::nullopt};
}

class MotionRun {
 public:
  MotionRun(const MotionOrder& order, TextFeed& text, OutputFiles& outputs, FileReport& report)
      : order_(order),
        text_(text),
        outputs_(outputs),
        report_(report),
        ticks_(order.settings, order.kernel_options.start_mm) {}

  void dry_run() {
    Kernel kernel(order_.settings, order_.kernel_options);
    KernelPlanning planning(kernel);
    Feeder feeder(planning, text_, progress_);
    RunOutcome outcome;
    {
      const auto bar = progress_bar([] { return std::string("running  "); });
      outcome = run_without_clock(kernel, stage_with(feeder));
    }
    finish({kernel, feeder, outcome});
  }

  void run(std::optional<ControlEndpoint> control) {
    Controller controller(order_.settings, order_.kernel_options);
    Operator by(controller);
    // Neither is refused: it is off, and then idle.
    static_cast<void>(by.give(kerf::Command::enable));
    static_cast<void>(by.give(kerf::Command::start));
    ControllerPlanning planning(controller);
    Feeder feeder(planning, text_, progress_);
    RunOutcome outcome;
    std::optional<ControlChannel> channel;
    if (control) {
      channel.emplace(*std::move(control), by,
                      ControlChannel::Order{.file = report_.file,
                                            .extra = report_.extra_axes,
                                            .feed_inputs = order_.settings.program.feed_inputs,
                                            .others_answer = order_.has_keys});
    }
    {
      const MessagePrinter messages(controller, report_.file);
      std::optional<Keys> keys;
      if (order_.has_keys) {
        keys.emplace(by);
      }
      if (order_.has_keys && order_.shows_progress) {
        fmt::print(stderr, "{}\n", Keys::kWhatTheyDo);
      }
      const auto bar = progress_bar([&controller] { return status_line(controller.status()); });
      outcome = run_in_real_time({controller, by, report_.period_s}, stage_with(feeder));
      controller.plan();  // what the program said last
    }
    finish({.kernel = *controller.program(),
            .feeder = feeder,
            .outcome = outcome,
            .is_stopped = by.has_stopped(),
            .is_emergency = controller.status().state == ControllerState::emergency_stop});
    if (channel) {
      by.carry_out();  // what came too late is refused
      channel->finish(report_.status);
    }
  }

 private:
  struct End {
    const Kernel& kernel;
    const Feeder& feeder;
    const RunOutcome& outcome;
    bool is_stopped = false;  // by an operator
    bool is_emergency = false;
  };

  [[nodiscard]] ProgressBar progress_bar(std::function<std::string()> label) const {
    return {std::move(label), [this] { return progress_.share(); }, order_.shows_progress};
  }
  RunStage stage_with(Feeder& feeder) {
    return {feeder,
            ticks_,
            outputs_.recorder(),
            progress_,
            report_.live,
            static_cast<std::int64_t>(order_.options.max_time_s / report_.period_s)};
  }

  void finish(const End& end) {
    report_motion(report_, end.kernel, ticks_.statistics(), end.outcome);
    if (const auto& speed = outputs_.recorder().speed) {
      report_.speed = speed->report();
    }
    report_end(end);
    const bool trace_ended = end.outcome.trace_ended;
    report_.trace_reader_gone = trace_ended && outputs_.recorder().trace->reader_gone();
    if (report_.status == ExitStatus::done && order_.path.extents && !trace_ended) {
      // Of the curves: ticks need not meet their extremes.
      report_.plan->extents = *order_.path.extents;
      report_.plan->extra_extents = order_.path.extra_extents;
    }
    // A run that is stopped has done what its trace says; a dry run has not shown what it was to
    // show.
    const bool is_cut = order_.options.command != Command::run &&
                        (stop_requested() || end.outcome.too_long_at_line || trace_ended);
    for (const auto& error : {outputs_.close_trace(end.outcome.dropped_records, is_cut),
                              outputs_.write_plot(plot_caption(report_), is_cut)}) {
      if (error) {
        report_.fail(ExitStatus::io_error, *error);
      }
    }
  }

  // The gravest reason first.
  void report_end(const End& end) {
    if (const auto fault = end.kernel.fault()) {
      report_.fail(*fault);
    } else if (end.outcome.hung) {
      report_.fail({.line = 0, .what = "the program is read and nothing is planned"});
    } else if (ticks_.fault().kind != machine::Fault::none) {
      report_.fail(ExitStatus::machine_fault, describe(ticks_.fault(), report_.period_s));
    } else if (end.outcome.gap) {
      report_.fail(ExitStatus::machine_fault, describe(*end.outcome.gap, report_.period_s));
    } else if (end.is_emergency) {
      report_.status = ExitStatus::emergency_stop;
    } else if (stop_requested()) {
      report_.status = *stop_requested();
    } else if (end.is_stopped) {
      report_.status = ExitStatus::stopped;
    } else if (end.outcome.too_long_at_line) {
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

  const MotionOrder& order_;
  TextFeed& text_;
  OutputFiles& outputs_;
  FileReport& report_;
  Progress progress_;
  TickStage ticks_;
};

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
  std::optional<ControlEndpoint> control;
  if (order.options.control) {
    auto opened = open_control(*order.options.control);
    if (!opened) {
      report.fail(ExitStatus::io_error, opened.error());
      return;
    }
    control = *std::move(opened);
  }
  MotionRun run(order, text, *outputs, report);
  if (order.options.command == Command::run) {
    run.run(std::move(control));
  } else {
    run.dry_run();
  }
}

}  // namespace kerf::program
