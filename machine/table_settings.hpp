// The simulated table's data, one struct for each axis.
#pragma once

#include <kerf/machine.hpp>

namespace kerf::machine {

using kerf::AuxiliaryTravel;
using kerf::AxisDrive;
using kerf::TableSettings;
using kerf::Travel;

// Every number is valid (gains, lead, counts and drive limits positive, friction and integral
// not negative, feed_forward in 0..1, min < max, period in 1e-5..0.1 s) and finite where the struct
// does not say otherwise.
[[nodiscard]] bool is_valid(const TableSettings& settings) noexcept;

}  // namespace kerf::machine
