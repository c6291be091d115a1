#include "lookahead/path/block_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "lookahead/path/block_limits.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "lookahead/path/junction.hpp"
#include "smoothing/segment_builder.hpp"

namespace kerf::lookahead {

using smoothing::PathError;
using smoothing::PathSegment;

namespace {

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
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes; ++k) {
    block.begin.extra_per_mm[k] = block.end.extra_per_mm[k] = block.extra.slope_per_mm(k);
  }
}

Block make_block(PathSegment segment, const PlanLimits& limits, ScanFor plan) {
  Block block{.curve = std::move(segment.curve)};
  block.line = segment.source.line;
  block.run_block = segment.run_block;
  block.rapid = segment.rapid;
  block.length_mm = curves::length_mm(block.curve);
  block.stop_after = segment.stop_after;
  block.marks = std::move(segment.marks);
  block.continues = segment.continues;
  block.extra = segment.extra;
  const double feedrate = segment.rapid ? kUnbounded : segment.feedrate_mm_s;
  if (const auto* line = std::get_if<curves::Line>(&block.curve)) {
    block.limits = block.extra.alone ? free_limits(feedrate) : line_limits(*line, feedrate, limits);
    block.begin.first = line->direction();
    block.end = block.begin;
    bind_extra_axes(limits, block);
    block.along = block.limits;
    return block;
  }
  block.along = path_limits(feedrate, limits);
  bind_extra(block.extra, limits, block.along);
  block.begin = {curves::derivatives_at(block.curve, 0.0)};
  block.end = {curves::derivatives_at(block.curve, block.length_mm)};
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block.curve);
  if (segment.arc_normal) {
    const Bend bend = nurbs != nullptr ? bend_of(*nurbs, *segment.arc_normal)
                                       : bend_of(std::get<curves::Arc>(block.curve));
    block.limits = arc_limits(bend, feedrate, limits);
    bind_feedrate(block.along, {arc_chord_feedrate_mm_s(bend, limits), Constraint::chord_error});
    block.begin.most_third_per_mm2 = bend.third_per_mm2;
    block.end.most_third_per_mm2 = bend.third_per_mm2;
  } else {
    block.limits = nurbs_limits(*nurbs, feedrate, limits);
  }
  bind_extra_axes(limits, block);
  if (nurbs != nullptr) {
    block.limit_curve =
        scan_feedrate(*nurbs, {.feedrate_mm_s = block.limits.feedrate_mm_s,
                               .feedrate_from = block.limits.from.feedrate,
                               .along = {.acceleration_mm_s2 = block.along.ramp.acceleration_mm_s2,
                                         .jerk_mm_s3 = block.along.ramp.jerk_mm_s3},
                               .axes = limits.axes,
                               .period_s = limits.period_s,
                               .chord_tolerance_mm = limits.chord_tolerance_mm,
                               .plan = plan});
    bind_feedrate(block.along, {sub_tick_feedrate_mm_s(block, limits), Constraint::chord_error});
  }
  return block;
}

}  // namespace

tl::expected<Block, PathError> block_of(PathSegment segment, const PlanLimits& limits,
                                        ScanFor plan) {
  const std::uint32_t line = segment.source.line;
  Block block = make_block(std::move(segment), limits, plan);
  if (block.extra.alone && !is_bounded(block.limits)) {
    return tl::make_unexpected(PathError{line, "the machine has no limits of the axes that move"});
  }
  return block;
}

tl::expected<void, PathError> append_blocks(const parser::Move& move, const PlanLimits& limits,
                                            std::vector<Block>& blocks, ScanFor plan) {
  std::vector<PathSegment> segments;
  if (auto built = smoothing::append_segments(move, segments); !built) {
    return built;
  }
  for (PathSegment& segment : segments) {
    auto block = block_of(std::move(segment), limits, plan);
    if (!block) {
      return tl::make_unexpected(block.error());
    }
    blocks.push_back(std::move(*block));
  }
  return {};
}

}  // namespace kerf::lookahead
