#include "kernel/least_time.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

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

LeastTime::LeastTime(const lookahead::PlanLimits& limits)
    : limits_(limits),
      fastest_mm_s_(std::min(limits.path.velocity_mm_s,
                             std::hypot(limits.axes[0].velocity_mm_s, limits.axes[1].velocity_mm_s,
                                        limits.axes[2].velocity_mm_s))) {}

void LeastTime::add(const parser::Move& move, const std::vector<smoothing::PathSegment>& segments) {
  if (const auto* dwell = std::get_if<parser::DwellMove>(&move.shape)) {
    seconds_ += dwell->duration_s;
  }
  double move_s = 0.0;
  double way_mm = 0.0;
  for (const smoothing::PathSegment& segment : segments) {
    const double length_mm = curves::length_mm(segment.curve);
    way_mm += length_mm;
    const double machine_s = segment.extra.alone ? 0.0 : length_mm / fastest_mm_s_;
    const bool feeds = !segment.rapid && segment.feedrate_mm_s > 0.0;
    move_s += std::max(machine_s, feeds ? length_mm / segment.feedrate_mm_s : 0.0);
  }
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes && !segments.empty(); ++k) {
    const double way = std::abs(move.auxiliary.end_rad_mm[k] - move.auxiliary.begin_rad_mm[k]);
    move_s = std::max(move_s, way / limits_.extra[k].velocity_mm_s);
  }
  double share = 1.0;
  if (move.mode == parser::PathMode::blend && move_s > 0.0) {
    const double saved_mm =
        kSavedOfCorner * move.blend_tolerance_mm + kSavedOfMerging * move.merge_tolerance_mm;
    share = std::max(1.0 - saved_mm / way_mm, kBlendedShare);
  }
  seconds_ += share * move_s;
}

}  // namespace kerf
