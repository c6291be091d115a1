#include "lookahead/path/block_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "lookahead/path/block_limits.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "lookahead/path/junction.hpp"
#include "lookahead/path/normal_limits.hpp"
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

// The curve and what comes with it, without limits.
Block path_of(PathSegment segment) {
  Block block{.curve = std::move(segment.curve)};
  block.line = segment.source.program_line();
  block.run_block = segment.run_block;
  block.rapid = segment.rapid;
  block.deviation_mm = segment.deviation_mm;
  block.feedrate_mm_s = segment.rapid ? kUnbounded : segment.feedrate_mm_s;
  block.follows = segment.follows;
  block.arc_normal = segment.arc_normal;
  block.length_mm = curves::length_mm(block.curve);
  block.stop_after = segment.stop_after;
  block.marks = std::move(segment.marks);
  block.continues = segment.continues;
  block.extra = segment.extra;
  if (const auto* line = std::get_if<curves::Line>(&block.curve)) {
    block.begin.first = line->direction();
    block.end = block.begin;
  } else {
    block.begin = {curves::derivatives_at(block.curve, 0.0)};
    block.end = {curves::derivatives_at(block.curve, block.length_mm)};
  }
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes && block.extra.length_mm != 0.0; ++k) {
    block.begin.extra_per_mm[k] = block.end.extra_per_mm[k] = block.extra.slope_per_mm(k);
  }
  return block;
}

void set_limits_of_line(double feedrate_mm_s, const PlanLimits& limits, Block& block) {
  block.limits = block.extra.alone
                     ? free_limits(feedrate_mm_s)
                     : line_limits(std::get<curves::Line>(block.curve), feedrate_mm_s, limits);
  if (block.extra.length_mm != 0.0) {
    bind_extra(block.extra, limits, block.limits);
  }
  block.along = block.limits;
}

void set_limits_of_curve(double feedrate_mm_s, const PlanLimits& limits, Block& block) {
  block.along = path_limits(feedrate_mm_s, limits);
  bind_extra(block.extra, limits, block.along);
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block.curve);
  if (block.arc_normal) {
    const Bend bend = nurbs != nullptr ? bend_of(*nurbs, *block.arc_normal)
                                       : bend_of(std::get<curves::Arc>(block.curve));
    block.limits = arc_limits(bend, feedrate_mm_s, limits);
    bind_feedrate(block.along, {arc_chord_feedrate_mm_s(bend, limits), Constraint::chord_error});
    bind_feedrate(block.along, normal_bound(bend.curvature_per_mm, limits));
    block.begin.max_third_per_mm2 = bend.third_per_mm2;
    block.end.max_third_per_mm2 = bend.third_per_mm2;
  } else {
    block.limits = nurbs_limits(*nurbs, feedrate_mm_s, limits);
  }
  if (block.extra.length_mm != 0.0) {
    bind_extra(block.extra, limits, block.limits);
  }
}

void scan(const PlanLimits& limits, ScanFor plan, Block& block) {
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block.curve);
  if (nurbs == nullptr) {
    return;
  }
  block.limit_curve =
      scan_feedrate(*nurbs, {.feedrate_mm_s = block.limits.feedrate_mm_s,
                             .feedrate_from = block.limits.from.feedrate,
                             .along = {.acceleration_mm_s2 = block.along.ramp.acceleration_mm_s2,
                                       .jerk_mm_s3 = block.along.ramp.jerk_mm_s3},
                             .axes = limits.axes,
                             .period_s = limits.period_s,
                             .chord_tolerance_mm = limits.chord_tolerance_mm,
                             .plan = plan});
  lower_to_normal_limits(*nurbs, limits, block.limit_curve);
  bind_feedrate(block.along, {sub_tick_feedrate_mm_s(block, limits), Constraint::chord_error});
}

struct Feedrate {
  double programmed_mm_s = 0.0;
  double share = 1.0;  // of what the limits leave
};

void set_limits(const Feedrate& feedrate, const PlanLimits& limits, ScanFor plan, Block& block) {
  block.slows = false;
  block.limit_curve.clear();
  if (std::holds_alternative<curves::Line>(block.curve)) {
    set_limits_of_line(feedrate.programmed_mm_s, limits, block);
  } else {
    set_limits_of_curve(feedrate.programmed_mm_s, limits, block);
  }
  for (BlockLimits* of : {&block.limits, &block.along}) {
    bind_feedrate(*of, {feedrate.share * of->feedrate_mm_s, Constraint::programmed});
  }
  scan(limits, plan, block);
}

}  // namespace

tl::expected<Block, PathError> block_of(PathSegment segment, const PlanLimits& limits,
                                        ScanFor plan) {
  const std::uint32_t line = segment.source.line;
  Block block = path_of(std::move(segment));
  set_limits(FeedOverride{}, limits, plan, block);
  if (block.extra.alone && !is_bounded(block.limits)) {
    return tl::make_unexpected(PathError{line, "the machine has no limits of the axes that move"});
  }
  return block;
}

void set_limits(double feedrate_mm_s, const PlanLimits& limits, ScanFor plan, Block& block) {
  set_limits(Feedrate{.programmed_mm_s = feedrate_mm_s}, limits, plan, block);
}

void set_limits(const FeedOverride& by, const PlanLimits& limits, ScanFor plan, Block& block) {
  set_limits(block.rapid ? Feedrate{kUnbounded, share_of_rapid(by, block.follows)}
                         : Feedrate{share_of(by, block.follows) * block.feedrate_mm_s, 1.0},
             limits, plan, block);
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
