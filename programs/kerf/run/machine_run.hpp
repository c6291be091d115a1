// A program run on the machine, by the clock and under an operator's commands.
#pragma once

#include <string>

#include "programs/kerf/driver/driver.hpp"
#include "programs/kerf/run/motion_stage.hpp"

namespace kerf::program {

// Without the control channel that was asked for nothing moves. Returns what the planning side did
// (PlanRecord), where the ticks are not those of the program alone; else nothing.
std::string run_machine(MotionStage& stage, Driver& driver);

}  // namespace kerf::program
