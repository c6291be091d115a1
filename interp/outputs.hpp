// What a program switches beside the axes: spindle, coolant, tool, outputs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kerf::interp {

struct Outputs {
  static constexpr std::size_t kDigital = 64;
  static constexpr std::size_t kAnalog = 8;

  double spindle_rad_s = 0.0;      // positive: M3, clockwise seen from the spindle
  double spindle_angle_rad = 0.0;  // where M19 holds it
  std::int32_t tool = 0;           // in the spindle
  bool spindle_held = false;       // M19
  bool mist = false;
  bool flood = false;
  std::uint64_t digital = 0;  // bit n: output n
  std::array<double, kAnalog> analog{};

  friend bool operator==(const Outputs&, const Outputs&) = default;
};

enum class SwitchKind : std::uint8_t {
  spindle,       // value = rad/s, 0 stops it
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
struct Switch {
  SwitchKind kind = SwitchKind::all_off;
  std::int32_t index = 0;
  double value = 0.0;
};

// A change that holds from a tick of the plan on.
struct SwitchAtTick {
  std::int64_t tick = 0;
  Switch change{};
};

void apply(const Switch& change, Outputs& outputs) noexcept;

static_assert(std::is_trivially_copyable_v<Outputs>);
static_assert(std::is_trivially_copyable_v<SwitchAtTick>);

}  // namespace kerf::interp
