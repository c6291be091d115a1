// A program's ticks from the first to the last, by the clock.
#pragma once

#include <kerf/controller.hpp>

#include "programs/kerf/control/operator.hpp"
#include "programs/kerf/run/run_loop.hpp"

namespace kerf::program {

struct RealTimeOrder {
  Controller& controller;
  Operator& by;
  double period_s = 0.001;
  bool realtime = false;     // with RealTimeThread
  int max_late_periods = 0;  // a tick that is later stops the program on the path; 0: none does
  PlanPace* pace = nullptr;  // a run once more has no other clock
};

// The same ticks as without a clock, one every period_s of CLOCK_MONOTONIC, in this thread;
// planning and recording each have a thread of their own. A late tick is counted, and the ticks
// after it keep their distance: lost time is not caught up. A gap (TickTimer) is a fault that ends
// the run at once. With a pace that is repeated the ticks come as soon as planning lets them.
//
// The run is over once the controller is idle or in fault, or at rest after an emergency stop.
RunOutcome run_in_real_time(const RealTimeOrder& order, const RunStage& stage);

}  // namespace kerf::program
