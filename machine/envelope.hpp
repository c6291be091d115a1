// Soft limits: is a point, or the box that a path fills, inside the travel?
//
// Pure functions, the same for the check before motion starts and for the one at every tick.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include <kerf/machine.hpp>

#include "curves/auxiliary_axis_motion.hpp"
#include "curves/position.hpp"

namespace kerf::machine {

using Envelope = std::array<Travel, 3>;                                         // x, y, z
using AuxiliaryEnvelope = std::array<AuxiliaryTravel, curves::kAuxiliaryAxes>;  // a, b, c, u, v, w

// A path that ends or turns on the limit itself may round beyond it. One nanometre is a thousand
// times what the interpolation rounds and a thousandth of an encoder count.
inline constexpr double kTravelToleranceMm = 1e-6;

struct TravelExcess {
  std::int8_t axis = 0;   // x, y, z, a, b, c, u, v, w
  bool above = false;     // beyond max_mm, else below min_mm
  double limit_mm = 0.0;  // the limit that is passed; of a, b, c in rad
  double by_mm = 0.0;     // how far, likewise; infinite for a coordinate that is not a number
};

[[nodiscard]] Envelope envelope_of(const TableSettings& settings) noexcept;

// The axis that is farthest outside, nothing where all are inside (to kTravelToleranceMm).
[[nodiscard]] std::optional<TravelExcess> outside_travel(const Envelope& envelope,
                                                         const curves::Position& point) noexcept;
[[nodiscard]] std::optional<TravelExcess> outside_travel(const Envelope& envelope,
                                                         const curves::Extents& box) noexcept;

[[nodiscard]] std::optional<TravelExcess> outside_travel(
    const AuxiliaryEnvelope& envelope, const curves::AuxiliaryPosition& position_rad_mm) noexcept;

// "x goes 12.5 mm beyond its upper limit of 300 mm". Allocates: not for the tick.
[[nodiscard]] std::string describe(const TravelExcess& excess);

}  // namespace kerf::machine
