#include "programs/kerf/run/machine_run.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/control/channel.hpp"
#include "programs/kerf/control/keys.hpp"
#include "programs/kerf/control/message_printer.hpp"
#include "programs/kerf/control/status_line.hpp"
#include "programs/kerf/run/journal_thread.hpp"
#include "programs/kerf/run/last_words.hpp"
#include "programs/kerf/run/real_time_loop.hpp"

namespace kerf::program {

namespace {

// A system that was asked for real time is to keep it.
int max_late_periods(const Options& options) {
  constexpr int kOfRealTime = 10;
  return options.driver.max_late_periods.value_or(options.realtime ? kOfRealTime : 0);
}

bool waits_for_start(const MotionOrder& order) {
  return order.plan != nullptr ? order.plan->waits_for_start : order.options.waits_for_start;
}

bool homes(const MotionOrder& order) {
  return order.plan != nullptr ? order.plan->homes : order.options.homes;
}

tl::expected<void, Refusal> begin(Operator& by, const MotionOrder& order) {
  static_cast<void>(by.give(kerf::Command::enable));  // it is off: not refused
  if (homes(order)) {
    return waits_for_start(order) ? by.give(kerf::Command::home) : by.home_and_start();
  }
  return waits_for_start(order) ? tl::expected<void, Refusal>() : by.give(kerf::Command::start);
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
          .machine_has_inputs = driver.has_inputs(),
          .tools = stage.order().settings.program.tools,
          .break_down = [&driver](const PlannedFault& fault) { return driver.break_down(fault); },
          .others_answer = stage.order().has_keys,
          .waits_for_start = waits_for_start(stage.order())};
}

// None: a run that leaves no record, or text that comes as it runs, which nobody can have come
// again.
void choose_pace(const MotionOrder& order, const FileReport& report, bool is_attended,
                 std::optional<PlanPace>& pace) {
  if (order.plan != nullptr) {
    pace.emplace(*order.plan, PlanPace::Does::repeats);
  } else if (!order.options.record_file.empty() && !report.live) {
    PlanRecord record;
    record.is_attended = is_attended;
    record.waits_for_start = order.options.waits_for_start;
    record.homes = order.options.homes;
    const auto& start = order.kernel_options.start_in_program;
    record.start_waits = start && start->waits;
    pace.emplace(std::move(record), PlanPace::Does::notes);
  }
}

// Nothing: the ticks are those of the program alone. Not so where a door stopped it or a search for
// the home switches went on, each at the tick at which planning saw it, nor where the machine asked
// for an emergency stop. A fault may end what a door held.
std::string kept_of(const std::optional<PlanPace>& pace, const RunOutcome& outcome,
                    const Operator& by) {
  const PlanRecord record = pace ? pace->record() : PlanRecord();
  const bool is_kept = record.has_orders() || outcome.starved_ticks > 0 || by.has_stopped() ||
                       record.homes || by.status().state == ControllerState::emergency_stop ||
                       by.status().state == ControllerState::fault;
  return is_kept ? record.bytes() : std::string();
}

MessagePrinter::Waits written_waits(const MotionOrder& order) {
  using Waits = MessagePrinter::Waits;
  return !order.has_keys        ? Waits::none
         : order.shows_progress ? Waits::all_but_block_ends
                                : Waits::all;
}

// With all who look at it, and the keys.
RunOutcome run_watched(MotionStage& stage, Controller& controller, Operator& by, Feeder& feeder,
                       PlanPace* pace) {
  const MotionOrder& order = stage.order();
  FileReport& report = stage.report();
  std::optional<JournalThread> journal;
  if (order.journal != nullptr) {
    journal.emplace(by, *order.journal);
  }
  const MessagePrinter messages(controller, report.file, written_waits(order));
  std::optional<Keys> keys;
  if (order.has_keys) {
    keys.emplace(by);
  }
  if (order.has_keys && order.shows_progress) {
    fmt::print(stderr, "{}\n", Keys::kWhatTheyDo);
  }
  if (order.has_keys && waits_for_start(order)) {
    fmt::print(stderr, "waiting for the start: Enter starts the program\n");
  }
  const auto bar = stage.progress_bar([&controller] { return status_line(controller.status()); },
                                      ProgressBar::Left::not_said);  // the status says it
  RunOutcome outcome = run_in_real_time({.controller = controller,
                                         .by = by,
                                         .period_s = report.period_s,
                                         .realtime = order.options.realtime,
                                         .max_late_periods = max_late_periods(order.options),
                                         .pace = pace},
                                        stage.stage_with(feeder));
  controller.plan();  // what the program said last
  return outcome;
}

std::string run_with(std::optional<ControlEndpoint> control, MotionStage& stage, Driver& driver) {
  const MotionOrder& order = stage.order();
  FileReport& report = stage.report();
  const bool is_attended =
      order.plan != nullptr ? order.plan->is_attended : order.has_keys || control.has_value();
  std::optional<PlanPace> pace;
  choose_pace(order, report, is_attended, pace);
  KernelOptions options = order.kernel_options;
  // An operator's line may change offsets.
  options.checks_travel = options.checks_travel || waits_for_start(order);
  if (pace) {
    options.plan_clock = [&pace](std::int64_t ticks) { return pace->look(ticks); };
  }
  Controller controller(order.settings, options);
  Operator by(controller, is_attended, pace ? &*pace : nullptr,
              driver.has_inputs() ? order.settings.program.feed_inputs : FeedInputNumbers{});
  by.begin_with(stage.inputs());
  if (const auto begun = begin(by, order); !begun) {
    report.fail(ExitStatus::machine_fault, std::string(begun.error().reason));
    return {};
  }
  ControllerPlanning planning(controller);
  Feeder feeder = stage.feeder(planning);
  std::optional<ControlChannel> channel;
  if (control) {
    channel.emplace(*std::move(control), by, channel_order(stage, driver));
  }
  const RunOutcome outcome = run_watched(stage, controller, by, feeder, pace ? &*pace : nullptr);
  Kernel none(order.settings, options);
  const ControllerStatus last = controller.status();
  const std::string no_home =
      last.state == ControllerState::fault ? last_message(controller) : std::string();
  stage.finish({.kernel = by.has_started() ? *controller.program() : none,
                .feeder = feeder,
                .outcome = outcome,
                .is_stopped = by.has_stopped(),
                .no_home = no_home,
                .is_unhomed = last.unhomed != 0,
                .is_emergency = last.state == ControllerState::emergency_stop});
  if (by.has_door_stopped()) {
    report.warnings.emplace_back("the door was opened, and nobody could let the run go on");
  }
  if (channel) {
    channel->close();
    by.carry_out();  // what came too late is refused
    channel->finish(report.status, last_words(report, no_home));
  }
  return kept_of(pace, outcome, by);
}

}  // namespace

std::string run_machine(MotionStage& stage, Driver& driver) {
  std::optional<ControlEndpoint> control;
  if (stage.order().options.control) {
    auto opened = open_control(*stage.order().options.control);
    if (!opened) {
      stage.report().fail(ExitStatus::io_error, opened.error());
      return {};
    }
    control = *std::move(opened);
  }
  return run_with(std::move(control), stage, driver);
}

}  // namespace kerf::program
