// A program run on the machine, by the clock and under an operator's commands.
#pragma once

#include "programs/kerf/driver/driver.hpp"
#include "programs/kerf/run/motion_stage.hpp"

namespace kerf::program {

// Without the control channel that was asked for nothing moves.
void run_machine(MotionStage& stage, Driver& driver);

}  // namespace kerf::program
