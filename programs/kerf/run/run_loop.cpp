#include "programs/kerf/run/run_loop.hpp"

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/starvation_judge.hpp"

namespace kerf::program {

RunOutcome run_without_clock(Kernel& kernel, const RunStage& stage) {
  RunOutcome outcome;
  StarvationJudge judge(stage.waits_for_text);
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
    kernel.set_program_inputs(stage.ticks.program_inputs());
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

}  // namespace kerf::program
