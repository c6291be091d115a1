#include "programs/kerf/run/run_loop.hpp"

#include <optional>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/planning_beside.hpp"
#include "programs/kerf/run/starvation_judge.hpp"

namespace kerf::program {

namespace {

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

RunOutcome run_without_clock(Kernel& kernel, const RunStage& stage) {
  RunOutcome outcome;
  StarvationJudge judge(stage.waits_for_text);
  std::optional<PlanningBeside> beside;
  if (stage.plans_beside) {
    beside.emplace(kernel, stage.feeder);
  }
  for (TickRecord record;;) {
    if (beside) {
      beside->reach_tick();
    } else {
      plan_for_tick(kernel, stage);
    }
    Setpoint setpoint;
    kernel.set_program_inputs(stage.ticks.program_inputs());
    const TickStatus status = kernel.tick(setpoint);
    record = stage.ticks.take(setpoint, kernel.detail());
    stage.recorder.add(record);
    stage.progress.set_done(record.motion.s_mm);
    outcome.trace_ended = stage.recorder.trace_ended();
    judge.count(status == TickStatus::starved, outcome);
    if (status == TickStatus::finished || status == TickStatus::failed || outcome.hung ||
        stage.ticks.fault().kind != machine::DriveFault::none || outcome.trace_ended) {
      break;
    }
    if (record.tick >= stage.last_tick) {
      outcome.too_long_at_line = record.line;
      break;
    }
  }
  if (beside) {
    beside->finish();
  }
  return outcome;
}

}  // namespace kerf::program
