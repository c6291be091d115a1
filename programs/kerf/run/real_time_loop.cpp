#include "programs/kerf/run/real_time_loop.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/real_time_thread.hpp"
#include "programs/kerf/run/starvation_judge.hpp"
#include "programs/kerf/run/tick_timer.hpp"

namespace kerf::program {

namespace {

constexpr std::chrono::milliseconds kPlanningPause{1};

// Keeps the queue of the kernel full until the last tick.
class PlanningThread {
 public:
  PlanningThread(Feeder& feeder, const RealTimeOrder& order)
      : feeder_(&feeder), by_(&order.by), pace_(order.pace) {
    if (!repeats()) {
      feeder_->pump();  // the first tick finds its motion planned
    }
    thread_ = std::thread([this] { work(); });
  }
  ~PlanningThread() {
    over_.store(true, std::memory_order_relaxed);
    end_pace();
    thread_.join();
  }
  PlanningThread(const PlanningThread&) = delete;
  PlanningThread& operator=(const PlanningThread&) = delete;

  // The tool comes to rest on the path, and the program is over.
  void stop() noexcept { stops_.store(true, std::memory_order_relaxed); }
  // Nothing more is planned: memory may be used up.
  [[nodiscard]] bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  // Precondition: failed().
  [[noreturn]] void rethrow() const { std::rethrow_exception(error_); }

 private:
  void work() noexcept {
    try {
      if (repeats()) {
        feeder_->pump();  // here: it may wait for ticks
      }
      while (!over_.load(std::memory_order_relaxed)) {
        stop_if_asked();
        by_->carry_out();
        feeder_->pump();
        if (!repeats()) {
          std::this_thread::sleep_for(kPlanningPause);
        }
      }
    } catch (...) {
      error_ = std::current_exception();
      failed_.store(true, std::memory_order_release);
      end_pace();
    }
  }

  void stop_if_asked() {
    const bool is_asked = repeats() ? pace_->next_is_end()
                                    : stop_requested() || stops_.load(std::memory_order_relaxed);
    if (!is_asked || std::exchange(has_stopped_, true)) {
      return;
    }
    if (pace_ != nullptr) {
      pace_->note_end();
    }
    by_->end_run();
    feeder_->stop();
  }

  [[nodiscard]] bool repeats() const noexcept { return pace_ != nullptr && pace_->is_repeated(); }
  void end_pace() {
    if (pace_ != nullptr) {
      pace_->end();
    }
  }

  Feeder* feeder_;
  Operator* by_;
  PlanPace* pace_;
  bool has_stopped_ = false;
  std::exception_ptr error_;
  std::atomic<bool> failed_{false};
  std::atomic<bool> over_{false};
  std::atomic<bool> stops_{false};
  std::thread thread_;
};

bool is_starved(const Controller& controller) noexcept {
  const WaitsFor what = controller.waits_for();
  return what == WaitsFor::text || what == WaitsFor::planning;
}

// Idle before the program is no end. To be asked before the tick: a start that comes after it
// would be taken for a program that has ended.
bool is_end_where_idle(const RealTimeOrder& order) noexcept {
  return order.by.has_started() || order.by.has_stopped() || stop_requested();
}

bool is_over(ControllerState state, bool ends_idle, const RealTimeOrder& order) noexcept {
  return (state == ControllerState::idle && ends_idle) || state == ControllerState::fault ||
         (state == ControllerState::emergency_stop && !order.controller.drives_on());
}

// The axes of a machine that has a fault come to rest, which is written to until then: by its own
// brakes, or by the setpoints where it still follows. One that does not say so is left alone after
// a time in which any would.
class Aftermath {
 public:
  explicit Aftermath(double period_s) noexcept
      : left_(static_cast<std::int64_t>(kLongest_s / period_s)) {}

  [[nodiscard]] bool is_over(const TickStage& ticks, double v_mm_s) noexcept {
    const bool brakes = ticks.follows() && v_mm_s > 0.0;
    return !brakes && (!ticks.is_stopping() || --left_ <= 0);
  }

 private:
  static constexpr double kLongest_s = 2.0;

  std::int64_t left_;
};

// The ticks, in the thread that calls them.
class Ticks {
 public:
  Ticks(const RealTimeOrder& order, const RunStage& stage, RunOutcome& outcome)
      : order_(order),
        stage_(stage),
        outcome_(outcome),
        judge_(stage.waits_for_text),
        aftermath_(order.period_s),
        max_delay_s_(order.max_late_periods > 0 ? order.period_s * order.max_late_periods
                                                : std::numeric_limits<double>::infinity()) {}

  void run(RecorderThread& recorder, PlanningThread& planning) {
    TickTimer timer(order_.period_s);
    bool is_over = false;
    while (!is_over) {
      const double gap_s = repeats() ? 0.0 : timer.wait();
      const std::int64_t begin_ns = TickTimer::now_ns();
      if (gap_s > 0.0) {
        outcome_.gap = TickGap{.duration_s = gap_s, .line = record_.line, .tick = record_.tick};
        order_.controller.fail();
        break;
      }
      stop_where_late(timer, planning);
      // Without planning the ticks still have a whole way to rest.
      is_over = tick(recorder, planning) || (planning.failed() && !(setpoint_.v_mm_s > 0.0));
      outcome_.tick_times.add(TickTimer::now_ns() - begin_ns);
    }
    if (planning.failed()) {
      stage_.ticks.disable();
      planning.rethrow();
    }
    if (state_ == ControllerState::idle && !outcome_.gap) {
      stage_.ticks.hear_out(setpoint_, [&] { static_cast<void>(repeats() ? 0.0 : timer.wait()); });
    }
    stage_.ticks.disable();
    outcome_.late_ticks = timer.late();
    outcome_.delays = timer.delays();
  }

 private:
  void stop_where_late(const TickTimer& timer, PlanningThread& planning) noexcept {
    if (timer.delay_s() > max_delay_s_ && !outcome_.too_late) {
      outcome_.too_late =
          TickGap{.duration_s = timer.delay_s(), .line = record_.line, .tick = record_.tick};
      planning.stop();
    }
  }
  // True: it was the last one.
  bool tick(RecorderThread& recorder, PlanningThread& planning) noexcept {
    Controller& controller = order_.controller;
    follow_emergency();
    Setpoint& setpoint = setpoint_;
    controller.set_program_inputs(stage_.ticks.program_inputs());
    controller.set_door(stage_.ticks.inputs().door_open);
    const bool ends_idle = is_end_where_idle(order_);
    const ControllerState state = state_ = controller.tick(setpoint);
    if (controller.has_new_place()) {
      stage_.ticks.enable({.mm = setpoint.position_mm, .extra_rad_mm = setpoint.extra_rad_mm});
    }
    stage_.ticks.set_unhomed(controller.unhomed());
    record_ = stage_.ticks.take(setpoint, controller.detail());
    controller.set_home_switches(stage_.ticks.inputs().home);
    order_.by.hear(stage_.ticks.inputs());
    recorder.push(record_);
    stage_.progress.set_done(record_.motion.s_mm);
    if (stage_.ticks.emergency()) {
      emergency_stop();
    }
    judge_.count(is_starved(controller), outcome_);
    if (stage_.ticks.fault().kind != machine::DriveFault::none) {
      if (stage_.ticks.stops_on_path()) {
        planning.stop();
      } else if (!std::exchange(has_failed_, true)) {  // an emergency stop after it stays
        controller.fail();
      }
    }
    return (is_over(state, ends_idle, order_) &&
            aftermath_.is_over(stage_.ticks, setpoint.v_mm_s)) ||
           outcome_.hung;
  }

  // After a fault nothing is driven any more.
  void emergency_stop() noexcept {
    if (state_ != ControllerState::fault) {
      order_.controller.emergency_stop();
    }
  }
  // One that the machine does not ask for: it is in no record of what the machine says.
  void follow_emergency() noexcept {
    const std::int64_t tick = record_.tick + 1;
    const bool is_repeated = order_.pace != nullptr && order_.pace->begin_tick(tick);
    if (emergency_stop_requested() || is_repeated) {
      emergency_stop();
    }
    if (order_.pace != nullptr && !was_emergency_ &&
        (emergency_stop_requested() || order_.by.has_emergency())) {
      was_emergency_ = true;
      order_.pace->note_emergency(tick);
    }
  }
  [[nodiscard]] bool repeats() const noexcept {
    return order_.pace != nullptr && order_.pace->is_repeated();
  }

  const RealTimeOrder& order_;
  const RunStage& stage_;
  RunOutcome& outcome_;
  ControllerState state_ = ControllerState::off;  // at the latest tick
  Setpoint setpoint_{};                           // of that
  bool was_emergency_ = false;
  bool has_failed_ = false;
  StarvationJudge judge_;
  Aftermath aftermath_;
  double max_delay_s_;
  TickRecord record_{};
};

}  // namespace

RunOutcome run_in_real_time(const RealTimeOrder& order, const RunStage& stage) {
  expect_emergency_stop();
  RunOutcome outcome;
  const bool has_clock = order.pace == nullptr || !order.pace->is_repeated();
  RecorderThread recorder(stage.recorder, has_clock);
  {
    PlanningThread planning(stage.feeder, order);
    // After the other threads: they are not for real time.
    std::optional<RealTimeThread> real_time;
    if (order.realtime) {
      real_time.emplace();
      outcome.not_permitted = real_time->refusals();
    }
    Ticks(order, stage, outcome).run(recorder, planning);
  }
  recorder.finish();
  outcome.dropped_records = recorder.dropped();
  return outcome;
}

}  // namespace kerf::program
