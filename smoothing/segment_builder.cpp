#include "smoothing/segment_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "curves/curve_builders.hpp"

namespace kerf::smoothing {

using parser::ArcMove;
using parser::LineMove;
using parser::Move;
using parser::NurbsMove;

namespace {

int normal_axis(parser::Plane plane) {
  switch (plane) {
    case parser::Plane::zx:
      return 1;
    case parser::Plane::yz:
      return 0;
    default:
      return 2;
  }
}

curves::ArcShape arc_shape(const Move& move, const ArcMove& arc) {
  return {.start_mm = move.start_mm,
          .end_mm = arc.end_mm,
          .centre_mm = arc.centre_mm,
          .normal_axis = normal_axis(arc.plane),
          .clockwise = arc.clockwise,
          .turns = arc.turns};
}

curves::NurbsData nurbs_data(const NurbsMove& nurbs) {
  curves::NurbsData data{.degree = nurbs.degree, .points = {}, .knots = nurbs.knots};
  data.points.reserve(nurbs.points.size());
  for (const parser::NurbsPoint& point : nurbs.points) {
    data.points.push_back({.position_mm = point.position_mm, .weight = point.weight});
  }
  return data;
}

// The line of the knot or control point that an error names, else that of the curve's first block.
std::uint32_t line_to_blame(const Move& move, const curves::CurveError& error) {
  const auto* nurbs = std::get_if<NurbsMove>(&move.shape);
  if (nurbs != nullptr && error.where != curves::CurveError::Where::whole) {
    const bool knot = error.where == curves::CurveError::Where::knot;
    const std::vector<std::uint32_t>& lines = knot ? nurbs->knot_lines : nurbs->point_lines;
    if (error.index < lines.size()) {
      return lines[error.index];
    }
  }
  return move.source.line;
}

// X, Y and Z rest, and the length is that of the extra axes' own way.
bool moves_extra_alone(const Move& move) {
  const auto* line = std::get_if<LineMove>(&move.shape);
  return line != nullptr && line->end_mm == move.start_mm && move.auxiliary.moves();
}

tl::expected<curves::Line, curves::CurveError> make_line(const Move& move, const LineMove& line) {
  return moves_extra_alone(move)
             ? curves::Line::resting(move.start_mm, move.auxiliary.length_rad_mm())
             : curves::Line::between(move.start_mm, line.end_mm);
}

PathSegment segment_of(curves::Curve curve, const Move& move) {
  PathSegment segment{.curve = std::move(curve)};
  segment.source = move.source;
  segment.run_block = move.block;
  segment.rapid = move.rapid;
  segment.feedrate_mm_s = move.feedrate_mm_s;
  segment.follows = move.follows;
  segment.mode = move.mode;
  segment.corner_tolerance_mm =
      move.mode == parser::PathMode::blend ? move.blend_tolerance_mm : 0.0;
  segment.stop_after = move.mode == parser::PathMode::exact_stop;
  segment.extra = {.begin_rad_mm = move.auxiliary.begin_rad_mm,
                   .end_rad_mm = move.auxiliary.end_rad_mm,
                   .length_mm = move.auxiliary.moves() ? curves::length_mm(segment.curve) : 0.0,
                   .alone = moves_extra_alone(move)};
  return segment;
}

// So much of an arc of many turns becomes one segment: the look-ahead holds a segment as a whole.
constexpr double kLongestSegment_rad = 200.0 * std::numbers::pi;

void append_arc(const curves::Arc& arc, const Move& move, std::vector<PathSegment>& segments) {
  const double turned_rad = arc.in_plane_share() * arc.length_mm() / arc.radius_mm();
  // A last turn that is not whole needs no segment of its own.
  const int count = std::max(1, static_cast<int>(turned_rad / kLongestSegment_rad));
  const PathSegment whole = segment_of(arc, move);
  if (count == 1) {
    segments.push_back(whole);
    return;
  }
  const double length_mm = arc.length_mm();
  double begin_mm = 0.0;
  for (int i = 1; i <= count; ++i) {
    const double end_mm = i < count ? length_mm * (static_cast<double>(i) / count) : length_mm;
    PathSegment& segment = segments.emplace_back(whole);
    segment.curve = arc.part({.begin_mm = begin_mm, .end_mm = end_mm});
    segment.continues = i > 1;
    segment.stop_after = whole.stop_after && i == count;
    if (move.auxiliary.moves()) {
      segment.extra.begin_rad_mm = whole.extra.at(begin_mm);
      segment.extra.end_rad_mm = whole.extra.at(end_mm);
      segment.extra.length_mm = curves::length_mm(segment.curve);
    }
    begin_mm = end_mm;
  }
}

using Appended = tl::expected<void, PathError>;

Appended refuse(const Move& move, const curves::CurveError& error) {
  return tl::make_unexpected(PathError{line_to_blame(move, error), error.message});
}

Appended append_line(const Move& move, const LineMove& line, std::vector<PathSegment>& segments) {
  const auto built = make_line(move, line);
  if (!built) {
    return refuse(move, built.error());
  }
  segments.push_back(segment_of(*built, move));
  return {};
}

Appended append_round(const Move& move, const ArcMove& arc, std::vector<PathSegment>& segments) {
  const auto built = curves::make_arc(arc_shape(move, arc));
  if (!built) {
    return refuse(move, built.error());
  }
  const std::size_t first = segments.size();
  if (const auto* circle = std::get_if<curves::Arc>(&*built)) {
    append_arc(*circle, move, segments);
  } else {
    segments.push_back(segment_of(std::get<curves::NurbsCurve>(*built), move));
  }
  for (std::size_t i = first; i < segments.size(); ++i) {
    segments[i].arc_normal = normal_axis(arc.plane);
  }
  return {};
}

Appended append_nurbs(const Move& move, const NurbsMove& nurbs,
                      std::vector<PathSegment>& segments) {
  if (move.auxiliary.moves()) {
    return tl::make_unexpected(
        PathError{move.source.line, "A, B, C, U, V and W cannot move on a spline"});
  }
  auto built = curves::NurbsCurve::make(nurbs_data(nurbs));
  if (!built) {
    return refuse(move, built.error());
  }
  for (curves::NurbsCurve& curve : *built) {
    const bool last = &curve == &built->back();
    const auto straight = curves::straight(curve);
    segments.push_back(
        segment_of(straight ? curves::Curve(*straight) : curves::Curve(std::move(curve)), move));
    segments.back().stop_after = segments.back().stop_after && last;
  }
  return {};
}

}  // namespace

tl::expected<void, PathError> append_segments(const Move& move,
                                              std::vector<PathSegment>& segments) {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    return append_line(move, *line, segments);
  }
  if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    return append_round(move, *arc, segments);
  }
  if (const auto* nurbs = std::get_if<NurbsMove>(&move.shape)) {
    return append_nurbs(move, *nurbs, segments);
  }
  return {};
}

}  // namespace kerf::smoothing
