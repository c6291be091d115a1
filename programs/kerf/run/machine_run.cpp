#include "programs/kerf/run/machine_run.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/control/channel.hpp"
#include "programs/kerf/control/keys.hpp"
#include "programs/kerf/control/message_printer.hpp"
#include "programs/kerf/run/journal_thread.hpp"
#include "programs/kerf/run/real_time_loop.hpp"

namespace kerf::program {

namespace {

// A system that was asked for real time is to keep it.
int max_late_periods(const Options& options) {
  constexpr int kOfRealTime = 10;
  return options.driver.max_late_periods.value_or(options.realtime ? kOfRealTime : 0);
}

tl::expected<void, Refusal> begin(Operator& by, const Options& options) {
  static_cast<void>(by.give(kerf::Command::enable));  // it is off: not refused
  if (options.homes) {
    return options.waits_for_start ? by.give(kerf::Command::home) : by.home_and_start();
  }
  return options.waits_for_start ? tl::expected<void, Refusal>() : by.give(kerf::Command::start);
}

// What the controller said last.
std::string last_message(const Controller& controller) {
  std::array<ControllerEvent, ControllerEvent::kKept> events;
  std::string text;
  const std::size_t count = controller.events_since(1, events);
  for (std::size_t i = 0; i < count; ++i) {
    if (events[i].kind == ControllerEvent::Kind::message) {
      const auto message = controller.message(events[i].message);
      text = message ? message->text : text;
    }
  }
  return text;
}

ControlChannel::Order channel_order(MotionStage& stage, Driver& driver) {
  return {.file = stage.report().file,
          .extra = stage.report().extra_axes,
          .feed_inputs = stage.order().settings.program.feed_inputs,
          .break_down = [&driver](const PlannedFault& fault) { return driver.break_down(fault); },
          .others_answer = stage.order().has_keys};
}

void run_with(std::optional<ControlEndpoint> control, MotionStage& stage, Driver& driver) {
  const MotionOrder& order = stage.order();
  FileReport& report = stage.report();
  const bool waits = order.options.waits_for_start;
  KernelOptions options = order.kernel_options;
  options.checks_travel = options.checks_travel || waits;  // an operator's line may change offsets
  Controller controller(order.settings, options);
  Operator by(controller, order.has_keys || control.has_value());
  if (const auto begun = begin(by, order.options); !begun) {
    report.fail(ExitStatus::machine_fault, std::string(begun.error().reason));
    return;
  }
  ControllerPlanning planning(controller);
  Feeder feeder = stage.feeder(planning);
  RunOutcome outcome;
  std::optional<ControlChannel> channel;
  if (control) {
    channel.emplace(*std::move(control), by, channel_order(stage, driver));
  }
  {
    std::optional<JournalThread> journal;
    if (order.journal != nullptr) {
      journal.emplace(controller, *order.journal);
    }
    const MessagePrinter messages(controller, report.file);
    std::optional<Keys> keys;
    if (order.has_keys) {
      keys.emplace(by);
    }
    if (order.has_keys && order.shows_progress) {
      fmt::print(stderr, "{}\n", Keys::kWhatTheyDo);
    }
    const auto bar = stage.progress_bar([&controller] { return status_line(controller.status()); },
                                        ProgressBar::Left::not_said);  // the status says it
    outcome = run_in_real_time({.controller = controller,
                                .by = by,
                                .period_s = report.period_s,
                                .realtime = order.options.realtime,
                                .max_late_periods = max_late_periods(order.options)},
                               stage.stage_with(feeder));
    controller.plan();  // what the program said last
  }
  Kernel none(order.settings, options);
  const ControllerStatus last = controller.status();
  stage.finish(
      {.kernel = by.has_started() ? *controller.program() : none,
       .feeder = feeder,
       .outcome = outcome,
       .is_stopped = by.has_stopped(),
       .no_home = last.state == ControllerState::fault ? last_message(controller) : std::string(),
       .is_unhomed = last.unhomed != 0,
       .is_emergency = last.state == ControllerState::emergency_stop});
  if (channel) {
    by.carry_out();  // what came too late is refused
    channel->finish(report.status);
  }
}

}  // namespace

void run_machine(MotionStage& stage, Driver& driver) {
  std::optional<ControlEndpoint> control;
  if (stage.order().options.control) {
    auto opened = open_control(*stage.order().options.control);
    if (!opened) {
      stage.report().fail(ExitStatus::io_error, opened.error());
      return;
    }
    control = *std::move(opened);
  }
  run_with(std::move(control), stage, driver);
}

}  // namespace kerf::program
