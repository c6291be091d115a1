// What the parser hands on: one motion or one event, modal state resolved, in mm, seconds and mm/s.
#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include <kerf/program_data.hpp>

#include "diagnostics/source_position.hpp"
#include "parser/moves/auxiliary_axes.hpp"

namespace kerf::parser {

using Point = std::array<double, 3>;  // x, y, z in mm

// To where it starts: X, Y and Z rest, and only the auxiliary axes move.
struct LineMove {
  Point end_mm{};
};

// The plane of an arc names its axes in right-handed order: (first, second, normal).
enum class Plane : std::uint8_t { xy, zx, yz };

// A circular arc or, where the normal axis moves too, a helix.
// The radius at the start and at the end may differ by what the control tolerates.
struct ArcMove {
  Plane plane = Plane::xy;
  Point centre_mm{};  // the component along the normal axis is not used
  Point end_mm{};
  bool clockwise = false;  // seen against the direction of the normal axis, as G2 is
  int turns = 1;  // 1: up to one full circle (end = start: exactly one); n: n - 1 circles more
};

struct NurbsPoint {
  Point position_mm{};
  double weight = 1.0;
};

// A curve as written. Whether it is one (knots, counts, weights, place of the first point) is
// checked where it is built; knot_lines and point_lines say which line to blame.
struct NurbsMove {
  int degree = 3;  // order - 1
  std::vector<NurbsPoint> points;
  std::vector<double> knots;
  std::vector<std::uint32_t> point_lines;
  std::vector<std::uint32_t> knot_lines;
};

struct DwellMove {
  double duration_s = 0.0;
  bool assumed = false;  // of an answer of the machine, which was not asked
};

enum class EventKind : std::uint8_t {
  program_stop,       // M0
  optional_stop,      // M1
  program_end,        // M2, M30, closing %
  spindle_cw,         // M3, or a new speed while turning so; value = revolutions per minute here
  spindle_ccw,        // M4, or a new speed while turning so; value = revolutions per minute here
  spindle_off,        // M5
  tool_change,        // M6, value = T
  mist_on,            // M7
  flood_on,           // M8
  coolant_off,        // M9
  pallet_change,      // M60, a stop
  tool_number,        // M61: the tool in the spindle is `value`, nothing is changed
  spindle_orient,     // M19, value = angle in rad
  digital_output,     // M64, M65: output `index` to value 1 or 0
  analog_output,      // M68: output `index` to `value`
  digital_at_motion,  // M62, M63: as the next motion begins, without a rest
  analog_at_motion,   // M67
  speed_override,     // M48, M49, M51: value 1, the spindle's override is followed; 0, it is not
  adaptive_feed,      // M52: the same of the machine's share of the feedrate
  feed_stop,          // M53: the same of the machine's feed stop
  probe_begin,        // G38: a rest, and the next motion ends where the machine says
  ask_machine,        // G38, M66, the spindle: at rest, until the machine has answered
  start,              // in the middle of the program: until an operator has confirmed it
};

// What a program asks the machine where motion has come.
struct MachineQuestion {
  enum class Kind : std::uint8_t {
    contact,      // G38.2, G38.3: the probe begins to touch
    contact_end,  // G38.4, G38.5
    digital,      // M66 P L0, and the further L
    rise,
    fall,
    high,
    low,
    analog,    // M66 E
    at_speed,  // M3, M4, S: the spindle
  };

  Kind kind = Kind::contact;
  std::int32_t channel = 0;
  double max_wait_s = 0.0;
};

inline bool is_probe(const MachineQuestion& question) {
  return question.kind <= MachineQuestion::Kind::contact_end;
}

struct MachineAnswer {
  bool found = false;  // contact began or ended on the way; the input was as it was to be in time
  bool at_start = false;  // of a probe: it was so already before the motion began
  double value = 0.0;     // of an input
  Point place_mm{};       // of a probe: of the machine's axes then, or where it ended in vain
  Point rest_mm{};        // of a probe: where the axes rest now
};

// M48 to M53: the change comes with what follows, be it a rest.
inline bool is_of_override(EventKind kind) {
  return kind == EventKind::speed_override || kind == EventKind::adaptive_feed ||
         kind == EventKind::feed_stop;
}

// Those, and M62, M63 and M67, which come with the next motion: the tool does not rest for them.
inline bool is_at_motion(EventKind kind) {
  return kind == EventKind::digital_at_motion || kind == EventKind::analog_at_motion ||
         is_of_override(kind);
}

// M0, M60, M6, a start in the middle, and M1 where optional stops are on: somebody is to do
// something and say so.
inline bool waits_for_answer(EventKind kind, bool optional_stop) {
  return kind == EventKind::program_stop || kind == EventKind::pallet_change ||
         kind == EventKind::tool_change || kind == EventKind::start ||
         (kind == EventKind::optional_stop && optional_stop);
}

// How many outputs of each kind there are: `index` counts from 0.
inline constexpr int kDigitalOutputs = 64;
inline constexpr int kAnalogOutputs = 8;

// G96: the speed at which the workpiece passes the tool. The tool's distance from the axis is
// |per_x x + per_y y + at_origin_mm| of the moves' coordinates.
struct SurfaceFollowing {
  double mm_s = 0.0;  // 0: not in force
  double max_per_min = 0.0;
  double per_x = 1.0;
  double per_y = 0.0;
  double at_origin_mm = 0.0;

  friend bool operator==(const SurfaceFollowing&, const SurfaceFollowing&) = default;
};

// Something the machine does with the tool at rest, but for the two kinds that say otherwise.
struct EventMove {
  EventKind kind = EventKind::program_stop;
  double value = 0.0;
  std::int32_t index = 0;
  SurfaceFollowing surface{};  // of spindle_cw and spindle_ccw, which then follow it
  bool taps = false;           // the tap is in its hole: nothing waits for the spindle
  MachineQuestion question{};  // of probe_begin and ask_machine
};

using kerf::PathMode;

// What a feedrate follows: M48 to M53, G95, tapping.
struct FollowedOverrides {
  bool feed = true;
  bool hold = true;       // a feed hold; not within a tap, whose spindle would turn on
  bool spindle = false;   // of G95: what the spindle makes of its speed
  bool adaptive = false;  // rapids too
  bool feed_stop = true;  // of the machine; rapids too

  friend bool operator==(const FollowedOverrides&, const FollowedOverrides&) = default;
};

struct Move {
  std::variant<LineMove, ArcMove, NurbsMove, DwellMove, EventMove> shape;
  diagnostics::SourcePosition source;
  Point start_mm{};
  bool rapid = false;  // G0: as fast as the machine goes
  // Along the path; not used by rapids, dwells and events. Where X, Y and Z rest: along U, V, W, or
  // in rad/s if only A, B, C move.
  double feedrate_mm_s = 0.0;
  FollowedOverrides follows{};
  AuxiliaryMove auxiliary{};  // does not move on a NurbsMove
  PathMode mode = PathMode::exact_path;
  double blend_tolerance_mm = 0.0;  // G64 P or the machine's; 0: no corner is cut
  double merge_tolerance_mm = 0.0;  // G64 Q, P or the machine's; 0: no lines are merged
  bool mode_by_program = false;     // else the machine's
  bool in_cycle = false;            // G81 and so on: on the exact path, whatever the path mode is
  bool probes = false;              // it ends in an exact stop, whatever the path mode is
  std::uint64_t block = 0;  // of the program's run, counted from 1: a line of a loop is many
};

}  // namespace kerf::parser
