// The machine's outputs beside its axes: spindle, coolant, tool, digital and analog outputs.
#pragma once

#include <cstdint>
#include <type_traits>

#include <kerf/setpoint.hpp>

#include "curves/position.hpp"

namespace kerf::interp {

using kerf::Outputs;
using kerf::SurfaceSpeed;

enum class OutputChangeKind : std::uint8_t {
  spindle,       // value = rad/s, 0 stops it; or `surface`
  hold_spindle,  // value = rad
  tool_change,   // value = tool; the spindle stops
  tool_number,   // value = tool
  mist_on,
  flood_on,
  coolant_off,
  speed_override,  // value = 1: the spindle follows its override; 0: it does not
  adaptive_feed,   // the same of the machine's share of the feedrate
  feed_stop,       // the same of the machine's feed stop
  digital,         // output `index` to value 0 or 1
  analog,          // output `index` to value
  all_off,         // the program's end: spindle and coolant
};

// One change of the outputs. An index that no output has changes nothing.
struct OutputChange {
  OutputChangeKind kind = OutputChangeKind::all_off;
  std::int32_t index = 0;
  double value = 0.0;
  SurfaceSpeed surface{};
};

void apply(const OutputChange& change, Outputs& outputs) noexcept;

// Sets the spindle's speed for this position, where a surface speed is in force.
void follow_surface(const curves::Position& position_mm, Outputs& outputs) noexcept;

// For outputs that are given away; those that are kept have the programmed speed.
void override_spindle(double share, Outputs& outputs) noexcept;

static_assert(std::is_trivially_copyable_v<Outputs>);
static_assert(std::is_trivially_copyable_v<OutputChange>);

}  // namespace kerf::interp
