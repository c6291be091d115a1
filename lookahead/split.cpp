#include "lookahead/split.hpp"

#include <algorithm>
#include <cmath>

#include "lookahead/breaking_points.hpp"
#include "lookahead/turn_ceiling.hpp"

namespace kerf::lookahead {

namespace {

// Between samples half a tick apart any change of slope is a candidate here; the second step and
// the comparison with the neighbours sort out what is a valley.
constexpr double kScreening_mm_s = 0.0;
// A dip or a hump of less than this share of the feedrate is noise, not a valley or a hill; where
// turning binds, a hill that low is not worth a stop of acceleration on both its sides.
constexpr double kNoise = 0.01;
constexpr double kTurningNoise = 0.05;

struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;  // included
};

Slope rise_of(const Ceiling& ceiling, const SampleRange& range, std::size_t top) {
  std::vector<Slope::Sample> samples;
  for (std::size_t i = range.first; i <= top; ++i) {
    samples.push_back({ceiling[i].s_mm - ceiling[range.first].s_mm, ceiling[i].v_mm_s});
  }
  return Slope(std::move(samples));
}

Slope fall_of(const Ceiling& ceiling, const SampleRange& range, std::size_t top) {
  std::vector<Slope::Sample> samples;
  for (std::size_t i = range.last + 1; i-- > top;) {
    samples.push_back({ceiling[range.last].s_mm - ceiling[i].s_mm, ceiling[i].v_mm_s});
  }
  return Slope(std::move(samples));
}

Span span_between(const Block& block, const Ceiling& ceiling, const SampleRange& range) {
  const auto at = [&ceiling](std::size_t i) {
    return ceiling.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto top = std::max_element(
      at(range.first), at(range.last + 1),
      [](const FeedSample& a, const FeedSample& b) { return a.v_mm_s < b.v_mm_s; });
  const auto top_index = static_cast<std::size_t>(top - ceiling.begin());
  Span span = whole_span(block);
  span.s_begin_mm = ceiling[range.first].s_mm;
  span.length_mm = ceiling[range.last].s_mm - span.s_begin_mm;
  span.end.feedrate_mm_s = ceiling[range.last].v_mm_s;
  span.ends_block = range.last + 1 == ceiling.size();
  span.rise = rise_of(ceiling, range, top_index);
  span.fall = fall_of(ceiling, range, top_index);
  return span;
}

std::vector<Span> split_at_valleys(const Block& block, const Ceiling& ceiling, double noise) {
  std::vector<Span> spans;
  std::size_t first = 0;
  for (const std::size_t valley :
       valleys(ceiling, breaking_points(ceiling, kScreening_mm_s), noise)) {
    spans.push_back(span_between(block, ceiling, {.first = first, .last = valley}));
    first = valley;
  }
  spans.push_back(span_between(block, ceiling, {.first = first, .last = ceiling.size() - 1}));
  spans.back().end.feedrate_mm_s = 0.0;
  return spans;
}

// The weakest axis in the direction of the place where it is strongest: no place allows more.
double strongest(const Turning& turning, const PlanLimits& limits, double MotionLimits::*limit) {
  double strongest = 0.0;
  for (const TurnSample& at : turning) {
    double weakest = kUnbounded;
    for (std::size_t k = 0; k < 3; ++k) {
      if (at.first[k] != 0.0) {
        weakest = std::min(weakest, limits.axes[k].*limit / std::abs(at.first[k]));
      }
    }
    strongest = std::max(strongest, weakest);
  }
  return strongest;
}

// The samples under the span, those at its ends included.
Turning part_of(const Turning& turning, const Span& span) {
  const auto less = [](const TurnSample& at, double s_mm) { return at.s_mm < s_mm; };
  const auto more = [](double s_mm, const TurnSample& at) { return s_mm < at.s_mm; };
  auto first = std::lower_bound(turning.begin(), turning.end(), span.s_begin_mm, less);
  auto last = std::upper_bound(first, turning.end(), span.s_begin_mm + span.length_mm, more);
  first -= first != turning.begin() ? 1 : 0;
  last += last != turning.end() ? 1 : 0;
  return {first, last};
}

}  // namespace

Span whole_span(const Block& block) {
  return {.length_mm = block.length_mm, .limits = block.limits, .end = {.feedrate_mm_s = 0.0}};
}

std::vector<Span> split(const Block& block) {
  if (block.ceiling.empty()) {
    return {whole_span(block)};
  }
  return split_at_valleys(block, block.ceiling, kNoise);
}

std::vector<Span> split(const Block& block, const Turning& turning, const PlanLimits& limits) {
  std::vector<Span> spans =
      split_at_valleys(block, lower_ceiling(block.ceiling, turning), kTurningNoise);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    Span& span = spans[i];
    span.turning = part_of(turning, span);
    span.axes = limits.axes;
    span.limits.ramp = {
        .acceleration_mm_s2 =
            std::min(block.along.ramp.acceleration_mm_s2,
                     strongest(span.turning, limits, &MotionLimits::acceleration_mm_s2)),
        .jerk_mm_s3 = std::min(block.along.ramp.jerk_mm_s3,
                               strongest(span.turning, limits, &MotionLimits::jerk_mm_s3))};
    if (i > 0) {
      double& joint = spans[i - 1].end.feedrate_mm_s;
      joint = std::min({joint, spans[i - 1].fall.bottom_mm_s(), span.rise.bottom_mm_s()});
    }
  }
  return spans;
}

}  // namespace kerf::lookahead
