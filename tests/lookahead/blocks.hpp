// Moves and blocks for the tests of the look-ahead.
#pragma once

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "curves/nurbs_curve.hpp"
#include "lookahead/path/block_builder.hpp"

namespace kerf::lookahead::test {

using curves::Position;

inline constexpr double kTs = 0.001;  // s, a tick

struct Ends {
  Position from{};
  Position to{};
};

inline PlanLimits axis_limits(const MotionLimits& each) {
  PlanLimits limits;
  limits.axes = {each, each, each};
  return limits;
}

inline PlanLimits path_limits(const MotionLimits& path) {
  PlanLimits limits;
  limits.path = path;
  return limits;
}

// The limits of the butterfly [Sigmoid, table 3], docs/math.md, 12.
inline PlanLimits butterfly_limits() {
  PlanLimits limits =
      path_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55000.0});
  limits.chord_tolerance_mm = 5e-4;
  return limits;
}

inline parser::Move line_move(const Ends& ends, double feedrate_mm_s = kUnbounded) {
  parser::Move move;
  move.shape = parser::LineMove{.end_mm = ends.to};
  move.start_mm = ends.from;
  move.source.line = 1;
  move.feedrate_mm_s = feedrate_mm_s;
  return move;
}

struct ArcWords {
  Ends ends{};
  Position centre{};
  bool clockwise = false;
  parser::Plane plane = parser::Plane::xy;
};

inline parser::Move arc_move(const ArcWords& arc, double feedrate_mm_s = kUnbounded) {
  parser::Move move;
  move.shape = parser::ArcMove{.plane = arc.plane,
                               .centre_mm = arc.centre,
                               .end_mm = arc.ends.to,
                               .clockwise = arc.clockwise};
  move.start_mm = arc.ends.from;
  move.source.line = 1;
  move.feedrate_mm_s = feedrate_mm_s;
  return move;
}

inline parser::Move nurbs_move(const curves::NurbsData& data, double feedrate_mm_s = kUnbounded) {
  parser::NurbsMove nurbs{.degree = data.degree,
                          .points = {},
                          .knots = data.knots,
                          .point_lines = {},
                          .knot_lines = {}};
  for (const curves::ControlPoint& point : data.points) {
    nurbs.points.push_back({.position_mm = point.position_mm, .weight = point.weight});
  }
  parser::Move move;
  move.start_mm = data.points.front().position_mm;
  move.shape = std::move(nurbs);
  move.source.line = 1;
  move.feedrate_mm_s = feedrate_mm_s;
  return move;
}

inline std::vector<Block> blocks_of(const std::vector<parser::Move>& moves,
                                    const PlanLimits& limits) {
  std::vector<Block> blocks;
  for (const parser::Move& move : moves) {
    if (const auto built = append_blocks(move, limits, blocks); !built) {
      throw std::invalid_argument(built.error().message);
    }
  }
  return blocks;
}

inline std::vector<curves::NurbsCurve> smooth_parts(const curves::NurbsData& data) {
  return curves::NurbsCurve::make(data).value();
}

inline curves::NurbsCurve smooth_curve(const curves::NurbsData& data) {
  return smooth_parts(data).front();
}

// A circle of radius_mm in the plane, of four rational quadratic quarters.
inline curves::NurbsData nurbs_circle(double radius_mm) {
  curves::NurbsData data{
      .degree = 2, .points = {}, .knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}};
  const double r = radius_mm;
  const std::vector<std::pair<double, double>> corners{{r, 0},   {r, r},  {0, r},  {-r, r}, {-r, 0},
                                                       {-r, -r}, {0, -r}, {r, -r}, {r, 0}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    data.points.push_back({.position_mm = {corners[i].first, corners[i].second, 0.0},
                           .weight = i % 2 == 0 ? 1.0 : std::sqrt(0.5)});
  }
  return data;
}

}  // namespace kerf::lookahead::test
