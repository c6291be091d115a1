#include "parser/compensation/path_sender.hpp"

#include <cmath>

namespace kerf::parser {

Point PathSender::point_at(planar::Vec centre_mm, double normal_mm) const {
  Point point{};
  point[axes_.first] = centre_mm.x + shift_mm_.x;
  point[axes_.second] = centre_mm.y + shift_mm_.y;
  point[axes_.normal] = normal_mm;
  return point;
}

Move& PathSender::push(const HeldMove& held, const Point& end_mm) {
  Move& move = sent_.push();
  move = held.move;
  move.start_mm = place_mm_;
  place_mm_ = end_mm;
  return move;
}

void PathSender::send_line(const HeldMove& held, const Point& end_mm) {
  if (end_mm != place_mm_ || held.move.auxiliary.moves()) {
    push(held, end_mm).shape = LineMove{end_mm};
  }
}

// An ArcMove tells its sweep by its ends and turns, so an end that comes within rounding of the
// start must be the start, or an almost full circle would become almost none.
void PathSender::send_arc(const HeldMove& held, const planar::ContourElement& arc,
                          double normal_mm) {
  constexpr double kNoise_rad = 1e-9;
  ArcMove shape;
  shape.plane = plane_;
  shape.clockwise = arc.sweep_rad < 0.0;
  shape.centre_mm = point_at(arc.centre_mm, normal_mm);
  shape.end_mm = point_at(arc.end_mm, normal_mm);
  const double turn =
      std::fabs(turn_rad(centre_mm() - arc.centre_mm, arc.end_mm - arc.centre_mm, shape.clockwise));
  const double sweep =
      turn + planar::kTurn_rad * std::round((std::fabs(arc.sweep_rad) - turn) / planar::kTurn_rad);
  if (sweep < kNoise_rad) {
    send_line(held, shape.end_mm);
    return;
  }
  const double turns = std::round(sweep / planar::kTurn_rad);
  if (turns >= 1.0 && std::fabs(sweep - turns * planar::kTurn_rad) < kNoise_rad) {
    shape.end_mm[axes_.first] = place_mm_[axes_.first];
    shape.end_mm[axes_.second] = place_mm_[axes_.second];
    shape.turns = static_cast<int>(turns);
  } else {
    shape.turns = 1 + static_cast<int>(sweep / planar::kTurn_rad);
  }
  push(held, shape.end_mm).shape = shape;
}

void PathSender::send(const HeldMove& held) {
  const auto* line = std::get_if<LineMove>(&held.move.shape);
  const auto* arc = std::get_if<ArcMove>(&held.move.shape);
  if (line == nullptr && arc == nullptr) {
    push(held, place_mm_);
    return;
  }
  const Point& end = line != nullptr ? line->end_mm : arc->end_mm;
  const double normal = end[axes_.normal];
  if (held.role == HeldRole::exit) {
    send_line(held, end);
    return;
  }
  if (held.role == HeldRole::idle) {
    send_line(held, point_at(centre_mm(), normal));
    return;
  }
  if (held.has_corner && held.role != HeldRole::entry) {
    send_arc(held, held.corner, place_mm_[axes_.normal]);
  }
  if (arc != nullptr) {
    send_arc(held, held.way, normal);
  } else {
    send_line(held, point_at(held.way.end_mm, normal));
  }
}

}  // namespace kerf::parser
