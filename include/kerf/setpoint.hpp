// The command for a machine at one tick.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <kerf/axes.hpp>

namespace kerf {
inline namespace v0 {

/// What limits the feedrate. The limits of an axis follow those of X in the order XYZABCUVW.
enum class Constraint : std::uint8_t {
  rest,           ///< a dwell, an event, a wait for text or people
  programmed,     ///< F
  path_velocity,  ///< along the path, of rapids too
  path_acceleration,
  path_jerk,
  chord_error,
  junction,             ///< direction or curvature jumps between two blocks; "joint" in reports
  window_end,           ///< the look-ahead sees no farther and brakes
  x_velocity = 8,       ///< to 16
  x_acceleration = 17,  ///< to 25
  x_jerk = 26,          ///< to 34
};

/// G96: the spindle turns so that the workpiece passes the tool at one speed. The tool's distance
/// from the axis is |per_x x + per_y y + at_origin_mm| of the axes' positions.
struct SurfaceSpeed {
  double mm_s = 0.0;       ///< > 0 clockwise, < 0 counterclockwise; 0: not in force
  double max_rad_s = 0.0;  ///< the spindle's highest speed; >= 0
  double per_x = 1.0;
  double per_y = 0.0;
  double at_origin_mm = 0.0;

  friend bool operator==(const SurfaceSpeed&, const SurfaceSpeed&) = default;
};

/// What a program switches beside the axes: spindle, coolant, tool, outputs.
struct Outputs {
  static constexpr std::size_t kDigital = 64;
  static constexpr std::size_t kAnalog = 8;

  /// Positive: M3, clockwise seen from the spindle; negative: M4. Under G96 as it is at this tick.
  double spindle_rad_s = 0.0;          ///< with the override
  bool follows_speed_override = true;  ///< M48, M49, M51; not while tapping
  bool follows_adaptive_feed = false;  ///< M52; not while tapping
  bool heeds_feed_stop = true;         ///< M53
  SurfaceSpeed surface{};              ///< what spindle_rad_s follows from, tick by tick
  double spindle_angle_rad = 0.0;      ///< where M19 holds it
  std::int32_t tool = 0;               ///< in the spindle; 0: none
  bool spindle_held = false;           ///< M19
  bool mist = false;
  bool flood = false;
  std::uint64_t digital = 0;             ///< bit n: output n
  std::array<double, kAnalog> analog{};  ///< as the program gave it (M67, M68 Q), no unit

  friend bool operator==(const Outputs&, const Outputs&) = default;
};

/// The command for one tick.
struct Setpoint {
  std::int64_t tick = 0;                ///< counts interpolation periods from 0
  std::uint32_t line = 0;               ///< of the block that the point belongs to
  bool rapid = false;                   ///< on a G0
  Constraint limit = Constraint::rest;  ///< what limits the feedrate from here to the next tick
  double s_mm = 0.0;                    ///< path length since the program's start, of X, Y and Z
  double v_mm_s = 0.0;  ///< along the path, as planned; 0 where only extra axes move
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;
  Position position_mm{};
  Position velocity_mm_s{};
  Position acceleration_mm_s2{};
  AuxiliaryPosition extra_rad_mm{};  ///< A, B, C, U, V, W; at rest if the machine has none
  Outputs outputs{};
};

/// How a tick went.
enum class TickStatus : std::uint8_t {
  running,   ///< the setpoint moves, dwells or passes a rest
  starved,   ///< nothing more is planned yet; the setpoint repeats the last, a rest if the plan was
             ///< kept ahead
  held,      ///< the tool is at rest in a feed hold; the setpoint repeats the last
  finished,  ///< this setpoint is the program's last, or repeats it
  failed,    ///< the same, of a program that ended before an error, or of a run that has a fault
  waiting,   ///< at rest at an M0, M1, M60 or M6, or in single block after a block, until resume()
  emergency_stop,  ///< at rest after an emergency stop; the setpoint repeats the last
};

/// What lets a program wait for an answer.
enum class WaitCause : std::uint8_t {
  none,
  program_stop,   ///< M0
  optional_stop,  ///< M1
  pallet_change,  ///< M60
  tool_change,    ///< M6
  block_end,      ///< single block
  start,          ///< in the middle of a program (KernelOptions::start)
};

}  // namespace v0
}  // namespace kerf
