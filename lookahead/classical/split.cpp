#include "lookahead/classical/split.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/classical/axis_limit_scan.hpp"
#include "lookahead/classical/limit_curve_cuts.hpp"

namespace kerf::lookahead {

namespace {

// A dip or a hump of less than this share of the feedrate is noise, not a valley or a hill.
constexpr double kNoise = 0.01;

VelocitySegment segment_between(const Block& block, const VelocityLimitCurve& limit_curve,
                                const SampleRange& range) {
  Hill hill = hill_of(limit_curve, range);
  VelocitySegment segment = whole_segment(block);
  segment.s_begin_mm = limit_curve[range.first].s_mm;
  segment.length_mm = limit_curve[range.last].s_mm - segment.s_begin_mm;
  segment.end.feedrate_mm_s = limit_curve[range.last].v_mm_s;
  segment.ends_block = range.last + 1 == limit_curve.size();
  segment.rise = Slope(std::move(hill.rise));
  segment.fall = Slope(std::move(hill.fall));
  return segment;
}

std::vector<VelocitySegment> segments_between_cuts(const Block& block, const CutLimitCurve& cut) {
  std::vector<VelocitySegment> segments;
  std::size_t first = 0;
  for (const std::size_t last : cut.cuts) {
    segments.push_back(segment_between(block, cut.limit_curve, {.first = first, .last = last}));
    first = last;
    if (segments.size() > 1) {
      double& junction = segments[segments.size() - 2].end.feedrate_mm_s;
      junction = std::min({junction, segments[segments.size() - 2].fall.bottom_mm_s(),
                           segments.back().rise.bottom_mm_s()});
    }
  }
  segments.back().end.feedrate_mm_s = 0.0;
  return segments;
}

// The weakest axis in the direction of the place where it is strongest: no place allows more.
double strongest(const AxisLimitCurve& axis_limits, const PlanLimits& limits,
                 double MotionLimits::*limit) {
  double strongest = 0.0;
  for (const PathSample& at : axis_limits) {
    strongest = std::max(strongest, weakest_along(kUnbounded, at, limits, limit));
  }
  return strongest;
}

// The samples under the segment, those at its ends included.
AxisLimitCurve part_of(const AxisLimitCurve& axis_limits, const VelocitySegment& segment) {
  auto first = std::ranges::lower_bound(axis_limits, segment.s_begin_mm, {}, &PathSample::s_mm);
  auto last = std::ranges::upper_bound(
      first, axis_limits.end(), segment.s_begin_mm + segment.length_mm, {}, &PathSample::s_mm);
  first -= first != axis_limits.begin() ? 1 : 0;
  last += last != axis_limits.end() ? 1 : 0;
  return {first, last};
}

}  // namespace

VelocitySegment whole_segment(const Block& block) {
  return {.length_mm = block.length_mm, .limits = block.limits, .end = {.feedrate_mm_s = 0.0}};
}

std::vector<VelocitySegment> split(const Block& block, double period_s) {
  if (block.limit_curve.empty()) {
    return {whole_segment(block)};
  }
  return segments_between_cuts(
      block,
      cut(block.limit_curve, {.noise = kNoise, .period_s = period_s, .ramp = block.limits.ramp}));
}

std::vector<VelocitySegment> split(const Block& block, const CurvatureDemands& demands,
                                   double height) {
  const AxisLimitCurve& axis_limits = demands.axis_limits;
  const PlanLimits& limits = demands.limits;
  assert(!block.limit_curve.empty() && !axis_limits.empty());
  const auto steepest = [&](const AxisLimitCurve& under) -> profiles::RampLimits {
    const profiles::RampLimits& along = block.along.ramp;
    return {
        .acceleration_mm_s2 = std::min(along.acceleration_mm_s2,
                                       strongest(under, limits, &MotionLimits::acceleration_mm_s2)),
        .jerk_mm_s3 =
            std::min(along.jerk_mm_s3, strongest(under, limits, &MotionLimits::jerk_mm_s3))};
  };
  std::vector<VelocitySegment> segments = segments_between_cuts(
      block, cut(lower_limit_curve(block.limit_curve, axis_limits),
                 {.noise = height, .period_s = limits.period_s, .ramp = steepest(axis_limits)}));
  for (VelocitySegment& segment : segments) {
    segment.axis_limits = part_of(axis_limits, segment);
    segment.axes = limits.axes;
    segment.limits.ramp = steepest(segment.axis_limits);
  }
  return segments;
}

}  // namespace kerf::lookahead
