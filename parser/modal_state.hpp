// What stays in force from block to block.
#pragma once

#include <cstdint>
#include <optional>

#include "parser/move.hpp"
#include "parser/units.hpp"

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
};

enum class FeedMode : std::uint8_t { per_minute, inverse_time };  // G94, G93
enum class Spindle : std::uint8_t { off, clockwise, counterclockwise };

struct ModalState {
  Point position_mm{};
  Motion motion = Motion::none;
  Plane plane = Plane::xy;
  Units units = Units::mm;
  bool incremental = false;      // G91
  bool absolute_centre = false;  // G90.1
  FeedMode feed_mode = FeedMode::per_minute;
  std::optional<double> feedrate_mm_s;  // of G94; nothing before an F
  bool feed_from_other_units = false;   // G20 or G21 came after F
  double feed_word = 0.0;               // F as written
  PathMode path_mode = PathMode::exact_path;
  double blend_tolerance_mm = 0.0;
  double spindle_speed = 0.0;
  Spindle spindle = Spindle::off;
  double tool = 0.0;
  bool tool_selected = false;
  // The second handle of the G5 just before, for a G5 that leaves out I and J.
  std::optional<std::array<double, 2>> spline_handle_mm;
};

}  // namespace kerf::parser
