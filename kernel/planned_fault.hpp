// What breaks in the simulated table, and when.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace kerf {

enum class TableFault : std::uint8_t {
  encoder_frozen,
  encoder_jump,  // by jump_mm
  encoder_not_a_number,
  drive_trip,
  drive_weak,   // what is left of the motor's force does not move the axis for long
  axis_jammed,  // it stands at once
  home_switch_closed,
  home_switch_open,
  lower_limit_switch,  // closes
  upper_limit_switch,
  emergency_loop,  // opens
  spindle_stuck,   // does not come to its speed
  probe_closed,
  door_open
};
inline constexpr std::array<std::string_view, 14> kTableFaultNames{
    "encoder_frozen",     "encoder_jump",       "encoder_not_a_number", "drive_trip",
    "drive_weak",         "axis_jammed",        "home_switch_closed",   "home_switch_open",
    "lower_limit_switch", "upper_limit_switch", "emergency_loop",       "spindle_stuck",
    "probe_closed",       "door_open"};

struct PlannedFault {
  TableFault what = TableFault::encoder_frozen;
  std::int8_t axis = -1;  // x, y, z; -1 where none is meant
  double at_s = 0.0;      // of the machine's time, from the first setpoint
  double jump_mm = 2.0;   // of encoder_jump
};

struct FaultWords {
  std::string_view kind;
  std::string_view axis{};  // its letter; empty: none
};

// Error: what is wrong with the words.
[[nodiscard]] tl::expected<PlannedFault, std::string> planned_fault(const FaultWords& words);

}  // namespace kerf
