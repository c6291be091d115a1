#include "kernel/least_time.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "kernel/nominal_time.hpp"
#include "parser/moves/short_moves.hpp"

namespace kerf {

namespace {

// What G64 leaves of a path at the least. It never rounds a corner of more than 154 degrees: the
// way across one of those is sin(13 degrees) of the way around it.
constexpr double kBlendedShare = 1.0 / 8.0;
// And what it saves of a move at the most. A corner of the turn w within P begins 4 P / sin(w / 2)
// before it and saves 8 P tan(w / 4) < 6.4 P of the way, half of it on either side; merged lines
// begin and end within Q of where they are programmed. Twice that, for arcs.
constexpr double kSavedOfCorner = 13.0;  // P
constexpr double kSavedOfMerging = 4.0;  // Q

}  // namespace

double LeastTime::fastest_mm_s(const lookahead::PlanLimits& limits) {
  return std::min(limits.path.velocity_mm_s,
                  std::hypot(limits.axes[0].velocity_mm_s, limits.axes[1].velocity_mm_s,
                             limits.axes[2].velocity_mm_s));
}

LeastTime::LeastTime(const lookahead::PlanLimits& limits,
                     const lookahead::EventTime::Settings& events)
    : limits_(limits), fastest_mm_s_(fastest_mm_s(limits)), event_time_(events) {}

void LeastTime::add(const parser::Move& move, const std::vector<smoothing::PathSegment>& segments) {
  Way way;
  for (const smoothing::PathSegment& segment : segments) {
    const double length_mm = curves::length_mm(segment.curve);
    const double machine_s = segment.extra.alone ? 0.0 : length_mm / fastest_mm_s_;
    const bool feeds = !segment.rapid && segment.feedrate_mm_s > 0.0;
    way.length_mm += length_mm;
    way.time_s += std::max(machine_s, feeds ? length_mm / segment.feedrate_mm_s : 0.0);
  }
  if (!segments.empty()) {
    count(move, way);
  } else {
    rest(move);
  }
}

void LeastTime::add_straight(const parser::Move& move) {
  if (const parser::Point* end = parser::end_mm(move)) {
    const double length_mm = (curves::vec(*end) - curves::vec(move.start_mm)).norm();
    const bool feeds = !move.rapid && move.feedrate_mm_s > 0.0 && length_mm > 0.0;
    count(move, {.length_mm = length_mm,
                 .time_s = std::max(length_mm / fastest_mm_s_,
                                    feeds ? length_mm / move.feedrate_mm_s : 0.0)});
  } else {
    rest(move);
  }
}

// A machine that is asked may answer at once, and an operator may be faster than the machine file.
void LeastTime::rest(const parser::Move& pause) {
  if (const auto* dwell = std::get_if<parser::DwellMove>(&pause.shape)) {
    seconds_ += dwell->duration_s;
    nominal_.rest_s += dwell->assumed ? 0.0 : dwell->duration_s;
  } else if (const auto* event = std::get_if<parser::EventMove>(&pause.shape)) {
    nominal_.rest_s += event_time_.next_s(*event);
  }
}

void LeastTime::count(const parser::Move& move, Way way) {
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes; ++k) {
    const double turn = std::abs(move.auxiliary.end_rad_mm[k] - move.auxiliary.begin_rad_mm[k]);
    way.time_s = std::max(way.time_s, turn / limits_.extra[k].velocity_mm_s);
  }
  double share = 1.0;
  if (move.mode == parser::PathMode::blend && way.time_s > 0.0) {
    const double saved_mm =
        kSavedOfCorner * move.blend_tolerance_mm + kSavedOfMerging * move.merge_tolerance_mm;
    share = std::max(1.0 - saved_mm / way.length_mm, kBlendedShare);
  }
  seconds_ += share * way.time_s;
  add_motion(nominal_, way.time_s, move.rapid, move.follows);
  length_mm_ += way.length_mm;
}

}  // namespace kerf
