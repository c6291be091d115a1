#include "parser/moves/short_moves.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "parser/moves/arc_geometry.hpp"

namespace kerf::parser {

namespace {

double distance_mm(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Along one of the axes alone: cheap, and true of nearly all moves.
bool are_apart(const Point& a, const Point& b) {
  return std::fabs(a[0] - b[0]) >= kShortestWay_mm || std::fabs(a[1] - b[1]) >= kShortestWay_mm ||
         std::fabs(a[2] - b[2]) >= kShortestWay_mm;
}

// As far as the sum matters here: a long polygon is not added up.
double polygon_mm(const NurbsMove& curve) {
  double sum_mm = 0.0;
  for (std::size_t i = 1; i < curve.points.size() && sum_mm < kShortestWay_mm; ++i) {
    sum_mm += distance_mm(curve.points[i - 1].position_mm, curve.points[i].position_mm);
  }
  return sum_mm;
}

// A helix whose turns are too small to be any.
bool is_thread(const Move& move) {
  const auto* arc = std::get_if<ArcMove>(&move.shape);
  return arc != nullptr && larger_radius_mm(*arc, move.start_mm) < kShortestWay_mm;
}

void shift(Point& point_mm, const Point& from_mm, const Point& to_mm) {
  for (std::size_t axis = 0; axis < point_mm.size(); ++axis) {
    point_mm[axis] += to_mm[axis] - from_mm[axis];
  }
}

// A closed curve stays closed: equal coordinates are shifted to equal ones.
void start_at(Move& move, const Point& place_mm) {
  const Point from_mm = move.start_mm;
  move.start_mm = place_mm;
  if (auto* arc = std::get_if<ArcMove>(&move.shape)) {
    const Point programmed_end_mm = arc->end_mm;
    shift(arc->end_mm, from_mm, place_mm);
    shift(arc->centre_mm, from_mm, place_mm);
    for (std::size_t axis = 0; axis < from_mm.size(); ++axis) {
      if (programmed_end_mm[axis] == from_mm[axis]) {
        arc->end_mm[axis] = place_mm[axis];
      }
    }
  } else if (auto* nurbs = std::get_if<NurbsMove>(&move.shape)) {
    for (NurbsPoint& point : nurbs->points) {
      shift(point.position_mm, from_mm, place_mm);
    }
    nurbs->points.front().position_mm = place_mm;
  }
}

}  // namespace

const Point* end_mm(const Move& move) {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    return &line->end_mm;
  }
  if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    return &arc->end_mm;
  }
  const auto* nurbs = std::get_if<NurbsMove>(&move.shape);
  return nurbs != nullptr ? &nurbs->points.back().position_mm : nullptr;
}

double way_mm(const Move& move) {
  if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    return arc_length_mm(*arc, move.start_mm);
  }
  if (const auto* nurbs = std::get_if<NurbsMove>(&move.shape)) {
    return polygon_mm(*nurbs);
  }
  const auto* line = std::get_if<LineMove>(&move.shape);
  return line != nullptr ? distance_mm(move.start_mm, line->end_mm) : 0.0;
}

// The move begins where the tool is; auxiliary axes that it does not move stay there.
void ShortMoves::begin_at_place(Move& move) {
  if (!behind_) {
    place_mm_ = move.start_mm;
    place_rad_mm_ = move.auxiliary.begin_rad_mm;
  }
  start_at(move, place_mm_);
  if (!move.auxiliary.moves()) {
    move.auxiliary.end_rad_mm = place_rad_mm_;
  }
  move.auxiliary.begin_rad_mm = place_rad_mm_;
}

bool ShortMoves::take(Move& move) {
  const Point* const end = end_mm(move);
  if (end == nullptr ||
      (!behind_ && !move.auxiliary.moves() && are_apart(move.start_mm, *end) && !is_thread(move))) {
    return true;
  }
  const double programmed_mm = way_mm(move);
  const Point programmed_end_mm = *end;
  const AuxiliaryPosition programmed_end_rad_mm = move.auxiliary.end_rad_mm;
  const bool was_line = std::holds_alternative<LineMove>(move.shape);
  if (programmed_mm < kShortestWay_mm || is_thread(move)) {
    move.shape = LineMove{programmed_end_mm};
  }
  begin_at_place(move);
  const double length_mm = way_mm(move);
  const double auxiliary_rad_mm = move.auxiliary.length_rad_mm();
  const bool moves = length_mm >= kShortestWay_mm;
  const bool moves_auxiliary =
      auxiliary_rad_mm >= (move.auxiliary.only_turns() ? kShortestTurn_rad : kShortestWay_mm);
  behind_ = true;
  if (!moves && !moves_auxiliary) {
    return false;
  }
  place_rad_mm_ = move.auxiliary.end_rad_mm;
  // F of a line that is programmed too short counts along the auxiliary axes, else along X, Y and
  // Z.
  const bool feed_of_auxiliary = was_line && programmed_mm < kShortestWay_mm;
  if (!moves) {
    move.shape = LineMove{place_mm_};
    if (!feed_of_auxiliary) {
      move.feedrate_mm_s *= auxiliary_rad_mm / std::max(programmed_mm, 1e-3 * kShortestWay_mm);
    }
  } else if (feed_of_auxiliary && moves_auxiliary) {
    move.feedrate_mm_s *= length_mm / auxiliary_rad_mm;
  }
  place_mm_ = *end_mm(move);
  behind_ = place_mm_ != programmed_end_mm || place_rad_mm_ != programmed_end_rad_mm;
  return true;
}

}  // namespace kerf::parser
