#include "lookahead/block_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "curves/arc_builder.hpp"
#include "curves/straight.hpp"
#include "lookahead/block_limits.hpp"
#include "lookahead/feed_scan.hpp"

namespace kerf::lookahead {

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

BlockEnd block_end(const curves::PathDerivatives& path) {
  return {.tangent = path.first, .curvature_per_mm = path.second_per_mm, .third_per_mm2 = 0.0};
}

// X, Y and Z rest, and the length is that of the extra axes' own way.
bool moves_extra_alone(const Move& move) {
  const auto* line = std::get_if<LineMove>(&move.shape);
  return line != nullptr && line->end_mm == move.start_mm && move.extra.moves();
}

tl::expected<curves::Line, curves::CurveError> make_line(const Move& move, const LineMove& line) {
  return moves_extra_alone(move) ? curves::Line::resting(move.start_mm, move.extra.length_rad_mm())
                                 : curves::Line::between(move.start_mm, line.end_mm);
}

curves::ExtraWay extra_along(const Block& block, const Move& move) {
  return {.begin_rad_mm = move.extra.begin_rad_mm,
          .end_rad_mm = move.extra.end_rad_mm,
          .length_mm = move.extra.moves() ? block.length_mm : 0.0,
          .alone = moves_extra_alone(move)};
}

// What the limits along the path do not bind.
BlockLimits free_limits(double feedrate_mm_s) {
  return {.feedrate_mm_s = feedrate_mm_s,
          .ramp = {.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = kUnbounded}};
}

bool is_bounded(const BlockLimits& limits) {
  return std::isfinite(limits.feedrate_mm_s) && std::isfinite(limits.ramp.acceleration_mm_s2) &&
         std::isfinite(limits.ramp.jerk_mm_s3);
}

void bind_extra_axes(const PlanLimits& limits, Block& block) {
  if (block.extra.length_mm == 0.0) {
    return;
  }
  bind_extra(block.extra, limits, block.limits);
  for (std::size_t k = 0; k < curves::kExtraAxes; ++k) {
    block.begin.extra_per_mm[k] = block.end.extra_per_mm[k] = block.extra.slope_per_mm(k);
  }
}

Block make_block(curves::Curve curve, const Move& move, const PlanLimits& limits) {
  Block block{.curve = std::move(curve)};
  block.line = move.source.line;
  block.run_block = move.block;
  block.rapid = move.rapid;
  block.length_mm = curves::length_mm(block.curve);
  block.stop_after = move.mode == parser::PathMode::exact_stop;
  double feedrate = move.feedrate_mm_s;
  if (move.rapid) {
    feedrate = kUnbounded;
  }
  block.extra = extra_along(block, move);
  if (const auto* line = std::get_if<curves::Line>(&block.curve)) {
    block.limits = block.extra.alone ? free_limits(feedrate) : line_limits(*line, feedrate, limits);
    block.begin.tangent = line->direction();
    block.end = block.begin;
    bind_extra_axes(limits, block);
    block.along = block.limits;
    return block;
  }
  block.along = path_limits(feedrate, limits);
  bind_extra(block.extra, limits, block.along);
  block.begin = block_end(curves::derivatives_at(block.curve, 0.0));
  block.end = block_end(curves::derivatives_at(block.curve, block.length_mm));
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block.curve);
  if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    const Bend bend = nurbs != nullptr ? bend_of(*nurbs, normal_axis(arc->plane))
                                       : bend_of(std::get<curves::Arc>(block.curve));
    block.limits = arc_limits(bend, feedrate, limits);
    bind_feedrate(block.along, {arc_chord_feedrate_mm_s(bend, limits), SpeedLimit::chord_error});
    block.begin.third_per_mm2 = bend.third_per_mm2;
    block.end.third_per_mm2 = bend.third_per_mm2;
  } else {
    block.limits = nurbs_limits(*nurbs, feedrate, limits);
  }
  bind_extra_axes(limits, block);
  if (nurbs != nullptr) {
    block.ceiling = scan_feedrate(
        *nurbs, {.feedrate_mm_s = block.limits.feedrate_mm_s,
                 .feedrate_from = block.limits.from.feedrate,
                 .jerk_mm_s3 = block.along.ramp.jerk_mm_s3,
                 .axis_jerk_mm_s3 = {limits.axes[0].jerk_mm_s3, limits.axes[1].jerk_mm_s3,
                                     limits.axes[2].jerk_mm_s3},
                 .period_s = limits.period_s,
                 .chord_tolerance_mm = limits.chord_tolerance_mm});
  }
  return block;
}

}  // namespace

tl::expected<void, PlanError> append_curves(const Move& move, std::vector<curves::Curve>& curves) {
  const auto refuse = [&move](const curves::CurveError& error) {
    return tl::make_unexpected(PlanError{line_to_blame(move, error), error.message});
  };
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    const auto built = make_line(move, *line);
    if (!built) {
      return refuse(built.error());
    }
    curves.emplace_back(*built);
  } else if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    const auto built = curves::make_arc(arc_shape(move, *arc));
    if (!built) {
      return refuse(built.error());
    }
    std::visit([&curves](const auto& curve) { curves.emplace_back(curve); }, *built);
  } else if (const auto* nurbs = std::get_if<NurbsMove>(&move.shape)) {
    auto built = curves::NurbsCurve::make(nurbs_data(*nurbs));
    if (!built) {
      return refuse(built.error());
    }
    for (curves::NurbsCurve& part : *built) {
      const auto straight = curves::straight(part);
      curves.push_back(straight ? curves::Curve(*straight) : curves::Curve(std::move(part)));
    }
  }
  return {};
}

tl::expected<void, PlanError> append_blocks(const Move& move, const PlanLimits& limits,
                                            std::vector<Block>& blocks) {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    const auto built = make_line(move, *line);
    if (!built) {
      return tl::make_unexpected(PlanError{move.source.line, built.error().message});
    }
    Block block = make_block(*built, move, limits);
    if (block.extra.alone && !is_bounded(block.limits)) {
      return tl::make_unexpected(
          PlanError{move.source.line, "the machine has no limits of the axes that move"});
    }
    blocks.push_back(std::move(block));
    return {};
  }
  if (std::holds_alternative<NurbsMove>(move.shape) && move.extra.moves()) {
    return tl::make_unexpected(
        PlanError{move.source.line, "A, B, C, U, V and W cannot move on a spline"});
  }
  std::vector<curves::Curve> curves;
  if (auto built = append_curves(move, curves); !built) {
    return built;
  }
  for (curves::Curve& curve : curves) {
    const bool last = &curve == &curves.back();
    blocks.push_back(make_block(std::move(curve), move, limits));
    blocks.back().stop_after = blocks.back().stop_after && last;
  }
  return {};
}

}  // namespace kerf::lookahead
