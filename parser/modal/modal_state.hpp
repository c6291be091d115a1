// What stays in force from block to block.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "parser/modal/coordinates.hpp"
#include "parser/modal/cycle_words.hpp"
#include "parser/moves/move.hpp"
#include "parser/moves/units.hpp"

namespace kerf::parser {

// Ten times the G number, so that messages can name the code.
enum class Motion : std::int16_t {
  none = 800,
  rapid = 0,
  line = 10,
  arc_clockwise = 20,
  arc_counterclockwise = 30,
  cubic_spline = 50,
  quadratic_spline = 51,
  uniform_nurbs = 52,
  nurbs = 62,
  probe_on = 382,      // G38.2: until contact, or an error
  probe_on_if = 383,   // G38.3: until contact or the end
  probe_off = 384,     // G38.4: until contact ends, or an error
  probe_off_if = 385,  // G38.5
  chip_breaking = 730,
  tap_left = 740,
  drill = 810,
  drill_with_dwell = 820,
  peck = 830,
  tap = 840,
  bore = 850,
  bore_with_stop = 860,
  back_bore = 870,
  bore_by_hand = 880,
  bore_with_dwell = 890,
};

constexpr bool is_cycle(Motion motion) {
  return motion == Motion::chip_breaking || motion == Motion::tap_left ||
         (motion >= Motion::drill && motion <= Motion::bore_with_dwell);
}

enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_revolution };  // G94, G93, G95
enum class Spindle : std::uint8_t { off, clockwise, counterclockwise };

// What the last G38 found; not set before the first one.
struct ProbeResult {
  Point position_mm{};  // in program coordinates
  AuxiliaryWords auxiliary_deg_mm{};
  bool touched = false;
};

// G96: the spindle follows the distance from the axis X = 0.
struct SurfaceSpeedMode {
  bool active = false;
  double max_per_min = 1e5;  // D of G96, revolutions; no spindle turns faster
};

// What M48 to M53 allow the operator and the machine to change while a program runs.
struct AllowedOverrides {
  bool feed = true;
  bool speed = true;
  bool adaptive_feed = false;
  bool feed_hold = true;
};

// Fanuc: #3000 or #3006 was written and nobody has acted on it yet.
struct MacroSignal {
  enum class Kind : std::uint8_t { none, alarm, stop };
  Kind kind = Kind::none;
  double number = 0.0;
};

// As M62 to M68 leave them.
struct SwitchedOutputs {
  std::uint64_t digital = 0;  // bit n: output n
  std::array<double, kAnalogOutputs> analog{};
};

struct ModalState {
  Point position_mm{};  // of the machine's axes, what the moves carry
  AuxiliaryWords auxiliary_deg_mm{};
  Coordinates coordinates;
  Point stored_local_mm{};  // of G52 or G92, for G92.3
  AuxiliaryWords stored_local_auxiliary_deg_mm{};
  bool local_active = false;
  std::int16_t cutter_compensation = 400;  // G40, as ten times the number
  double cutter_offset = 0.0;              // D, which stays in force with Fanuc
  bool tool_length_active = false;         // G43, not G49
  Motion motion = Motion::none;
  Motion beneath_cycle = Motion::none;  // Fanuc: the motion that G80 comes back to
  Plane plane = Plane::xy;
  Units units = Units::mm;
  bool incremental = false;      // G91
  bool absolute_centre = false;  // G90.1
  FeedMode feed_mode = FeedMode::per_minute;
  std::optional<double> feedrate_mm_s;           // of G94; nothing before an F
  std::optional<double> feed_per_revolution_mm;  // of G95
  bool feed_from_other_units = false;            // G20 or G21 came after F
  double feed_word = 0.0;                        // F as written
  PathMode path_mode = PathMode::exact_path;
  double blend_tolerance_mm = 0.0;  // both 0 but under G64
  double merge_tolerance_mm = 0.0;
  bool path_mode_by_program = false;  // else the machine's
  double spindle_speed = 0.0;         // S: revolutions per minute; m or feet per minute under G96
  Units speed_units = Units::mm;      // in force where S was given
  Spindle spindle = Spindle::off;
  SurfaceSpeedMode surface_speed;
  double tool = 0.0;  // selected by T, for the next M6
  bool tool_selected = false;
  std::int32_t loaded_tool = 0;  // in the spindle
  bool mist = false;
  bool flood = false;
  AllowedOverrides overrides;
  SwitchedOutputs outputs;
  double input = 0.0;                    // what the last M66 read, -1 after a wait in vain
  std::uint32_t assumed_input_line = 0;  // of the first M66 that no machine was asked; 0: none
  ProbeResult probe;
  bool to_initial_level = false;  // G98, not G99: where a canned cycle ends
  CycleState cycle;
  MacroSignal signal;
  // The second handle of the G5 just before, for a G5 that leaves out I and J.
  std::optional<std::array<double, 2>> spline_handle_mm;
};

}  // namespace kerf::parser
