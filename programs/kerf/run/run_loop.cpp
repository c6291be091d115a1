#include "programs/kerf/run/run_loop.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/tick_timer.hpp"

namespace kerf::program {

namespace {

constexpr std::uint64_t kHungTicks = 100'000;
constexpr std::chrono::milliseconds kPlanningPause{1};

// Keeps the queue of the kernel full until the last tick.
class PlanningThread {
 public:
  PlanningThread(Feeder& feeder, Operator& by) : feeder_(&feeder), by_(&by) {
    feeder_->pump();  // the first tick finds its motion planned
    thread_ = std::thread([this] { work(); });
  }
  ~PlanningThread() {
    over_.store(true, std::memory_order_relaxed);
    thread_.join();
  }
  PlanningThread(const PlanningThread&) = delete;
  PlanningThread& operator=(const PlanningThread&) = delete;

  // Nothing more is planned: memory may be used up.
  [[nodiscard]] bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  // Precondition: failed().
  [[noreturn]] void rethrow() const { std::rethrow_exception(error_); }

 private:
  void work() noexcept {
    try {
      while (!over_.load(std::memory_order_relaxed)) {
        if (stop_requested()) {
          feeder_->stop();
        }
        by_->carry_out();
        feeder_->pump();
        std::this_thread::sleep_for(kPlanningPause);
      }
    } catch (...) {
      error_ = std::current_exception();
      failed_.store(true, std::memory_order_release);
    }
  }

  Feeder* feeder_;
  Operator* by_;
  std::exception_ptr error_;
  std::atomic<bool> failed_{false};
  std::atomic<bool> over_{false};
  std::thread thread_;
};

// Counts ticks that find nothing planned.
class Judge {
 public:
  explicit Judge(bool waits_for_text) noexcept : waits_for_text_(waits_for_text) {}

  void count(bool is_starved, RunOutcome& outcome) noexcept {
    starved_in_a_row_ = is_starved ? starved_in_a_row_ + 1 : 0;
    outcome.starved_ticks += is_starved ? 1 : 0;
    outcome.hung = starved_in_a_row_ >= kHungTicks && !waits_for_text_;
  }

 private:
  bool waits_for_text_;
  std::uint64_t starved_in_a_row_ = 0;
};

bool is_starved(const Controller& controller) noexcept {
  const WaitsFor what = controller.waits_for();
  return what == WaitsFor::text || what == WaitsFor::planning;
}

bool is_over(ControllerState state, const Controller& controller) noexcept {
  return state == ControllerState::idle || state == ControllerState::fault ||
         (state == ControllerState::emergency_stop && !controller.drives_on());
}

// The axes of a machine that has a fault come to rest, which is written to until then. One that
// does not say so is left alone after a time in which any would.
class Aftermath {
 public:
  explicit Aftermath(double period_s) noexcept
      : left_(static_cast<std::int64_t>(kLongest_s / period_s)) {}

  [[nodiscard]] bool is_over(const TickStage& ticks) noexcept {
    return !ticks.is_stopping() || --left_ <= 0;
  }

 private:
  static constexpr double kLongest_s = 2.0;

  std::int64_t left_;
};

}  // namespace

RunOutcome run_without_clock(Kernel& kernel, const RunStage& stage) {
  RunOutcome outcome;
  Judge judge(stage.waits_for_text);
  for (TickRecord record;;) {
    if (stop_requested()) {
      stage.feeder.stop();
    }
    stage.feeder.pump();
    if (stage.recorder.page != nullptr) {
      stage.recorder.page->add_notes(kernel);
    }
    kernel.reach_tick();
    Setpoint setpoint;
    const TickStatus status = kernel.tick(setpoint);
    record = stage.ticks.take(setpoint, kernel.detail());
    stage.recorder.add(record);
    stage.progress.set_done(record.motion.s_mm);
    outcome.trace_ended = stage.recorder.trace_ended();
    judge.count(status == TickStatus::starved, outcome);
    if (status == TickStatus::finished || status == TickStatus::failed || outcome.hung ||
        stage.ticks.fault().kind != machine::DriveFault::none || outcome.trace_ended) {
      return outcome;
    }
    if (record.tick >= stage.last_tick) {
      outcome.too_long_at_line = record.line;
      return outcome;
    }
  }
}

RunOutcome run_in_real_time(const RealTimeOrder& order, const RunStage& stage) {
  expect_emergency_stop();
  RunOutcome outcome;
  RecorderThread recorder(stage.recorder);
  {
    const PlanningThread planning(stage.feeder, order.by);
    TickTimer timer(order.period_s);
    Judge judge(stage.waits_for_text);
    Aftermath aftermath(order.period_s);
    for (TickRecord record;;) {
      if (const double gap_s = timer.wait(); gap_s > 0.0) {
        outcome.gap = TickGap{.duration_s = gap_s, .line = record.line, .tick = record.tick};
        break;
      }
      if (emergency_stop_requested()) {
        order.controller.emergency_stop();
      }
      Setpoint setpoint;
      const ControllerState state = order.controller.tick(setpoint);
      record = stage.ticks.take(setpoint, order.controller.detail());
      recorder.push(record);
      stage.progress.set_done(record.motion.s_mm);
      judge.count(is_starved(order.controller), outcome);
      if (stage.ticks.fault().kind != machine::DriveFault::none) {
        order.controller.fail();
      }
      if ((is_over(state, order.controller) && aftermath.is_over(stage.ticks)) || outcome.hung) {
        break;
      }
      if (planning.failed()) {
        planning.rethrow();
      }
    }
    stage.ticks.disable();
    outcome.late_ticks = timer.late();
    outcome.worst_delay_s = timer.worst_delay_s();
  }
  recorder.finish();
  outcome.dropped_records = recorder.dropped();
  return outcome;
}

}  // namespace kerf::program
