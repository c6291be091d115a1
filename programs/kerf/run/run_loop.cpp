#include "programs/kerf/run/run_loop.hpp"

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/planning_beside.hpp"
#include "programs/kerf/run/starvation_judge.hpp"
#include "programs/kerf/run/ticks_ahead.hpp"

namespace kerf::program {

namespace {

using Tick = TicksAhead::Tick;

// From a tick to the machine and what is recorded of it.
class TickTaker {
 public:
  TickTaker(const RunStage& stage, RunOutcome& outcome)
      : stage_(stage), outcome_(outcome), starvation_(stage.waits_for_text) {}

  // True: it was the last one.
  bool take(const Tick& tick) {
    const TickRecord record = stage_.ticks.take(tick.setpoint, tick.detail);
    stage_.recorder.add(record);
    stage_.progress.set_done(record.motion.s_mm);
    outcome_.has_enough = stage_.recorder.has_enough();
    starvation_.count(tick.status == TickStatus::starved, outcome_);
    if (tick.status == TickStatus::finished) {
      stage_.ticks.hear_out(tick.setpoint, [] {});
    }
    if (tick.status == TickStatus::finished || tick.status == TickStatus::failed || outcome_.hung ||
        stage_.ticks.fault().kind != machine::DriveFault::none || outcome_.has_enough) {
      return true;
    }
    if (record.tick >= stage_.last_tick) {
      outcome_.too_long_at_line = record.line;
      return true;
    }
    return false;
  }

 private:
  const RunStage& stage_;
  RunOutcome& outcome_;
  StarvationJudge starvation_;
};

void plan_for_tick(Kernel& kernel, const RunStage& stage) {
  if (stop_requested()) {
    stage.feeder.stop();
  }
  stage.feeder.pump();
  if (stage.recorder.page != nullptr) {
    stage.recorder.page->add_notes(kernel);
  }
  kernel.reach_tick();
}

}  // namespace

RunOutcome run_in_one_thread(Kernel& kernel, const RunStage& stage) {
  RunOutcome outcome;
  TickTaker taker(stage, outcome);
  Tick tick;
  do {
    plan_for_tick(kernel, stage);
    kernel.set_program_inputs(stage.ticks.program_inputs());
    tick.status = kernel.tick(tick.setpoint);
    tick.detail = kernel.detail();
  } while (!taker.take(tick));
  return outcome;
}

RunOutcome run_in_threads(Kernel& kernel, const RunStage& stage, TickJudge& judge) {
  RunOutcome outcome;
  TickTaker taker(stage, outcome);
  PlanningBeside planning(kernel, stage.feeder);
  {
    TicksAhead ticks(kernel, planning);
    for (bool is_last = false; !is_last;) {
      const Tick& tick = ticks.next([&] { return stage.ticks.program_inputs(); });
      if (tick.status == TickStatus::starved) {
        judge.starve();
      }
      judge.add(tick.setpoint, tick.detail.chord_error_mm);
      is_last = taker.take(tick);
    }
  }
  planning.await_plan();
  outcome.figures = judge.figures();
  return outcome;
}

}  // namespace kerf::program
