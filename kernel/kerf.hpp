// Kerf's front door. Three nouns: MachineSettings says what the machine can do, Kernel takes G-code
// text, Setpoint is what it gives at every tick.
#pragma once

#include "kernel/check.hpp"
#include "kernel/kernel.hpp"
#include "kernel/machine_file.hpp"
#include "kernel/settings.hpp"
#include "kernel/settings_check.hpp"

namespace kerf {

using interp::Setpoint;
using interp::TickStatus;
using profiles::Profile;
using profiles::ProfileKind;

}  // namespace kerf
