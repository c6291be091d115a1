#include "lookahead/block_builder.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "curves/arc_builder.hpp"
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

Block make_block(curves::Curve curve, const Move& move, const PlanLimits& limits) {
  Block block{.curve = std::move(curve)};
  block.line = move.source.line;
  block.rapid = move.rapid;
  block.length_mm = curves::length_mm(block.curve);
  block.stop_after = move.mode == parser::PathMode::exact_stop;
  double feedrate = move.feedrate_mm_s;
  if (move.rapid) {
    feedrate = kUnbounded;
  }
  if (const auto* line = std::get_if<curves::Line>(&block.curve)) {
    block.limits = line_limits(*line, feedrate, limits);
    block.begin.tangent = line->direction();
    block.end = block.begin;
    return block;
  }
  block.begin = block_end(curves::derivatives_at(block.curve, 0.0));
  block.end = block_end(curves::derivatives_at(block.curve, block.length_mm));
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block.curve);
  if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    const Bend bend = nurbs != nullptr ? bend_of(*nurbs, normal_axis(arc->plane))
                                       : bend_of(std::get<curves::Arc>(block.curve));
    block.limits = arc_limits(bend, feedrate, limits);
    block.begin.third_per_mm2 = bend.third_per_mm2;
    block.end.third_per_mm2 = bend.third_per_mm2;
  } else {
    block.limits = nurbs_limits(feedrate, limits);
  }
  if (nurbs != nullptr) {
    block.ceiling = scan_feedrate(*nurbs, {.feedrate_mm_s = block.limits.feedrate_mm_s,
                                           .jerk_mm_s3 = block.limits.ramp.jerk_mm_s3,
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
    const auto built = curves::Line::between(move.start_mm, line->end_mm);
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
    std::move(built->begin(), built->end(), std::back_inserter(curves));
  }
  return {};
}

tl::expected<void, PlanError> append_blocks(const Move& move, const PlanLimits& limits,
                                            std::vector<Block>& blocks) {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    const auto built = curves::Line::between(move.start_mm, line->end_mm);
    if (!built) {
      return tl::make_unexpected(PlanError{move.source.line, built.error().message});
    }
    blocks.push_back(make_block(*built, move, limits));
    return {};
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
