#include "lookahead/classical/block_segments.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "lookahead/classical/axis_limit_scan.hpp"
#include "lookahead/classical/split.hpp"
#include "lookahead/classical/velocity_pass.hpp"
#include "lookahead/path/block_limits.hpp"

namespace kerf::lookahead {

namespace {

// Of the valleys that count: shares of the feedrate.
constexpr std::array kHeights{0.05, 0.2, 0.6};

// The first height alone where the block goes on from the one before it, in motion.
std::span<const double> heights_for(const Block& block) {
  return std::span(kHeights).first(block.continues ? 1 : kHeights.size());
}

// The axes' jerk does not bind the trapezoid.
PlanLimits limits_of(const JunctionRules& rules) {
  PlanLimits limits = rules.limits;
  if (rules.profile.kind() == profiles::ProfileKind::trapezoid) {
    for (MotionLimits& axis : limits.axes) {
      axis.jerk_mm_s3 = kUnbounded;
    }
  }
  return limits;
}

void bind_valleys(std::vector<VelocitySegment>& segments, const Block& block,
                  const JunctionRules& rules) {
  const double sub_tick = sub_tick_feedrate_mm_s(block, rules.limits);
  for (VelocitySegment& segment : segments) {
    bind_feedrate(segment.limits, {sub_tick, Constraint::chord_error});
    if (!segment.ends_block) {
      segment.end.feedrate_mm_s =
          std::min(sub_tick, valley_mm_s(segment.end.feedrate_mm_s, segment, rules));
    }
  }
}

// A block's segments, and how long each takes where the block comes to rest beside them and where
// it does not, together: which it is only the next block can say.
class PlannedSegments {
 public:
  PlannedSegments(std::vector<VelocitySegment> segments, bool begins_at_rest, BlockRuns& runs)
      : segments_(std::move(segments)), durations_s_(runs.rest_to_rest_s(segments_)) {
    const std::vector<double> in_motion_s = runs.in_motion_s(segments_, begins_at_rest);
    for (std::size_t i = 0; i < durations_s_.size(); ++i) {
      durations_s_[i] += in_motion_s[i];
    }
    duration_s_ = std::accumulate(durations_s_.begin(), durations_s_.end(), 0.0);
  }

  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] std::vector<VelocitySegment>&& segments() && { return std::move(segments_); }

  struct Run {
    std::size_t begin = 0;
    std::size_t end = 0;
    double end_mm = 0.0;
    double duration_s = 0.0;
  };
  void extend(Run& run) const {
    run.duration_s += durations_s_[run.end++];
    run.end_mm = run.end < segments_.size() ? segments_[run.end].s_begin_mm : kUnbounded;
  }
  void append(const Run& run, std::vector<VelocitySegment>& segments) const {
    segments.insert(segments.end(), segments_.begin() + static_cast<std::ptrdiff_t>(run.begin),
                    segments_.begin() + static_cast<std::ptrdiff_t>(run.end));
  }
  [[nodiscard]] double end_feedrate_mm_s(const Run& run) const {
    return segments_[run.end - 1].end.feedrate_mm_s;
  }

 private:
  std::vector<VelocitySegment> segments_;
  std::vector<double> durations_s_;
  double duration_s_ = 0.0;
};

// From each place where both are cut to the next, the segments of the one that takes less time.
std::vector<VelocitySegment> mixed(const PlannedSegments& a, const PlannedSegments& b) {
  std::vector<VelocitySegment> segments;
  PlannedSegments::Run of_a;
  PlannedSegments::Run of_b;
  while (of_a.end_mm < kUnbounded) {
    of_a = {.begin = of_a.end, .end = of_a.end};
    of_b = {.begin = of_b.end, .end = of_b.end};
    a.extend(of_a);
    b.extend(of_b);
    while (of_a.end_mm != of_b.end_mm) {
      if (of_a.end_mm < of_b.end_mm) {
        a.extend(of_a);
      } else {
        b.extend(of_b);
      }
    }
    if (of_b.duration_s < of_a.duration_s) {
      b.append(of_b, segments);
    } else {
      a.append(of_a, segments);
    }
    segments.back().end.feedrate_mm_s =
        std::min(a.end_feedrate_mm_s(of_a), b.end_feedrate_mm_s(of_b));
  }
  return segments;
}

}  // namespace

std::vector<VelocitySegment> segments_of(const Block& block, const JunctionRules& rules,
                                         bool begins_at_rest) {
  const PlanLimits limits = limits_of(rules);
  AxisLimitCurve axis_limits;
  if (const auto* nurbs = std::get_if<curves::NurbsCurve>(&block.curve)) {
    axis_limits = scan_axis_limits(*nurbs, block.limits.feedrate_mm_s, limits);
  }
  if (axis_limits.empty()) {
    std::vector<VelocitySegment> segments = split(block, limits.period_s);
    bind_valleys(segments, block, rules);
    return segments;
  }
  const auto split_at = [&](double height) {
    std::vector<VelocitySegment> segments = split(block, {axis_limits, limits}, height);
    bind_valleys(segments, block, rules);
    return segments;
  };
  const std::span<const double> heights = heights_for(block);
  if (heights.size() == 1) {
    return split_at(heights.front());
  }
  BlockRuns runs(rules.profile);
  std::optional<PlannedSegments> fastest;
  const auto take = [&](PlannedSegments&& planned) {
    if (!fastest || planned.duration_s() < fastest->duration_s()) {
      fastest = std::move(planned);
    }
  };
  for (const double height : heights) {
    PlannedSegments planned(split_at(height), begins_at_rest, runs);
    if (fastest) {
      take({mixed(*fastest, planned), begins_at_rest, runs});
    }
    take(std::move(planned));
  }
  return std::move(*fastest).segments();
}

}  // namespace kerf::lookahead
