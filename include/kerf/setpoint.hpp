// What a machine is told at one tick.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <kerf/axes.hpp>

namespace kerf {
inline namespace v0 {

/// What limits the feed. One byte that the planner sets where it knows it. Of an axis the values
/// are those of X plus the axis' number in XYZABCUVW.
enum class Constraint : std::uint8_t {
  rest,           ///< a dwell, an event, a wait for text or people
  programmed,     ///< F
  path_velocity,  ///< along the path, of rapids too
  path_acceleration,
  path_jerk,
  chord_error,
  junction,             ///< direction or curvature jumps between two blocks
  window_end,           ///< the look-ahead sees no farther and brakes
  x_velocity = 8,       ///< to 16
  x_acceleration = 17,  ///< to 25
  x_jerk = 26,          ///< to 34
};

inline constexpr std::size_t kConstraints = 35;
inline constexpr std::size_t kLimitedAxes = 9;

/// first: x_velocity, x_acceleration or x_jerk. axis < kLimitedAxes.
constexpr Constraint of_axis(Constraint first, std::size_t axis) noexcept {
  return static_cast<Constraint>(static_cast<std::size_t>(first) + axis);
}

/// G96: the spindle turns so that the workpiece passes the tool at one speed. The tool's distance
/// from the axis is |per_x x + per_y y + at_origin_mm| of the axes' positions.
struct SurfaceSpeed {
  double mm_s = 0.0;        ///< > 0 clockwise, < 0 counterclockwise; 0: not in force
  double most_rad_s = 0.0;  ///< what the spindle turns at most; >= 0
  double per_x = 1.0;
  double per_y = 0.0;
  double at_origin_mm = 0.0;

  friend bool operator==(const SurfaceSpeed&, const SurfaceSpeed&) = default;
};

/// What a program switches beside the axes: spindle, coolant, tool, outputs.
struct Outputs {
  static constexpr std::size_t kDigital = 64;
  static constexpr std::size_t kAnalog = 8;

  double spindle_rad_s = 0.0;      ///< positive: M3, clockwise seen from the spindle
  SurfaceSpeed surface{};          ///< what spindle_rad_s follows from, tick by tick
  double spindle_angle_rad = 0.0;  ///< where M19 holds it
  std::int32_t tool = 0;           ///< in the spindle
  bool spindle_held = false;       ///< M19
  bool mist = false;
  bool flood = false;
  std::uint64_t digital = 0;  ///< bit n: output n
  std::array<double, kAnalog> analog{};

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
  finished,  ///< this setpoint is the program's last, or repeats it
  failed,    ///< the same, of a program that ended before an error, or of a run that has a fault
};

}  // namespace v0
}  // namespace kerf
