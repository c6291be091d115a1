// What a program switches beside the axes: spindle, coolant, tool, outputs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "curves/position.hpp"

namespace kerf::interp {

// G96: the spindle turns so that the workpiece passes the tool at one speed. The tool's distance
// from the axis is |per_x x + per_y y + at_origin_mm| of the axes' positions.
struct SurfaceSpeed {
  double mm_s = 0.0;        // > 0 clockwise, < 0 counterclockwise; 0: not in force
  double most_rad_s = 0.0;  // what the spindle turns at most; >= 0
  double per_x = 1.0;
  double per_y = 0.0;
  double at_origin_mm = 0.0;

  friend bool operator==(const SurfaceSpeed&, const SurfaceSpeed&) = default;
};

struct Outputs {
  static constexpr std::size_t kDigital = 64;
  static constexpr std::size_t kAnalog = 8;

  double spindle_rad_s = 0.0;      // positive: M3, clockwise seen from the spindle
  SurfaceSpeed surface{};          // what spindle_rad_s follows from, tick by tick
  double spindle_angle_rad = 0.0;  // where M19 holds it
  std::int32_t tool = 0;           // in the spindle
  bool spindle_held = false;       // M19
  bool mist = false;
  bool flood = false;
  std::uint64_t digital = 0;  // bit n: output n
  std::array<double, kAnalog> analog{};

  friend bool operator==(const Outputs&, const Outputs&) = default;
};

enum class OutputChangeKind : std::uint8_t {
  spindle,       // value = rad/s, 0 stops it; or `surface`
  hold_spindle,  // value = rad
  tool_change,   // value = tool; the spindle stops
  tool_number,   // value = tool
  mist_on,
  flood_on,
  coolant_off,
  digital,  // output `index` to value 0 or 1
  analog,   // output `index` to value
  all_off,  // the program's end: spindle and coolant
};

// One change of the outputs. An index that no output has changes nothing.
struct OutputChange {
  OutputChangeKind kind = OutputChangeKind::all_off;
  std::int32_t index = 0;
  double value = 0.0;
  SurfaceSpeed surface{};
};

// A change that holds from a tick of the plan on.
struct OutputChangeAtTick {
  std::int64_t tick = 0;
  OutputChange change{};
};

void apply(const OutputChange& change, Outputs& outputs) noexcept;

// Sets the spindle's speed for this position, where a surface speed is in force.
void follow_surface(const curves::Position& position_mm, Outputs& outputs) noexcept;

static_assert(std::is_trivially_copyable_v<Outputs>);
static_assert(std::is_trivially_copyable_v<OutputChangeAtTick>);

}  // namespace kerf::interp
