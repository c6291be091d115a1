// Kerf's front door. Three nouns: MachineSettings says what the machine can do, Kernel takes G-code
// text, Setpoint is what it gives at every tick; Controller runs one program after the other, on an
// operator's commands. The interface is not stable yet: its version is
// the inline namespace v0.
#pragma once

#include <kerf/axes.hpp>
#include <kerf/check.hpp>
#include <kerf/controller.hpp>
#include <kerf/diagnostic.hpp>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <kerf/profile.hpp>
#include <kerf/program_data.hpp>
#include <kerf/program_inputs.hpp>
#include <kerf/report.hpp>
#include <kerf/setpoint.hpp>
#include <kerf/simulation.hpp>
