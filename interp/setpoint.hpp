// The command for a machine at one tick, under the names of the tick side.
#pragma once

#include <kerf/setpoint.hpp>

#include "curves/position.hpp"

namespace kerf::interp {

using curves::Position;
using kerf::Setpoint;
using kerf::TickStatus;

}  // namespace kerf::interp
