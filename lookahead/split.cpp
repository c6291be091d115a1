#include "lookahead/split.hpp"

#include <algorithm>
#include <cmath>

#include "lookahead/breaking_points.hpp"
#include "lookahead/climb_cuts.hpp"
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
constexpr double kFarApart = 4.0;  // feedrates of neighbours: times

struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;  // included
};

using Samples = std::vector<Slope::Sample>;

Samples rise_of(const Ceiling& ceiling, const SampleRange& range, std::size_t top) {
  Samples samples;
  for (std::size_t i = range.first; i <= top; ++i) {
    samples.push_back({ceiling[i].s_mm - ceiling[range.first].s_mm, ceiling[i].v_mm_s});
  }
  return samples;
}

Samples fall_of(const Ceiling& ceiling, const SampleRange& range, std::size_t top) {
  Samples samples;
  for (std::size_t i = range.last + 1; i-- > top;) {
    samples.push_back({ceiling[range.last].s_mm - ceiling[i].s_mm, ceiling[i].v_mm_s});
  }
  return samples;
}

std::size_t top_of(const Ceiling& ceiling, const SampleRange& range) {
  const auto at = [&ceiling](std::size_t i) {
    return ceiling.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto top = std::max_element(
      at(range.first), at(range.last + 1),
      [](const FeedSample& a, const FeedSample& b) { return a.v_mm_s < b.v_mm_s; });
  return static_cast<std::size_t>(top - ceiling.begin());
}

Span span_between(const Block& block, const Ceiling& ceiling, const SampleRange& range) {
  const std::size_t top = top_of(ceiling, range);
  Span span = whole_span(block);
  span.s_begin_mm = ceiling[range.first].s_mm;
  span.length_mm = ceiling[range.last].s_mm - span.s_begin_mm;
  span.end.feedrate_mm_s = ceiling[range.last].v_mm_s;
  span.ends_block = range.last + 1 == ceiling.size();
  span.rise = Slope(rise_of(ceiling, range, top));
  span.fall = Slope(fall_of(ceiling, range, top));
  return span;
}

void lower(Ceiling& ceiling, const SampleRange& range, double v_mm_s) {
  for (std::size_t k = range.first; k <= range.last; ++k) {
    ceiling[k].v_mm_s = std::min(ceiling[k].v_mm_s, v_mm_s);
  }
}

// Valleys within a tick's way at the feedrate of the lowest.
struct ValleyGroup {
  SampleRange range{};
  std::size_t lowest = 0;
};

// Of valleys within a tick's way of each other the lowest, and between them its feedrate; none
// within a tick's way of the ends, which have its feedrate then.
std::vector<std::size_t> apart(const std::vector<std::size_t>& valleys, double period_s,
                               Ceiling& ceiling) {
  const auto within_tick = [&](const SampleRange& range, std::size_t lowest) {
    return ceiling[range.last].s_mm - ceiling[range.first].s_mm <=
           ceiling[lowest].v_mm_s * period_s;
  };
  std::vector<std::size_t> kept;
  ValleyGroup group;
  const auto close = [&] {
    lower(ceiling, group.range, ceiling[group.lowest].v_mm_s);
    if (group.range.first > 0) {
      kept.push_back(group.lowest);
    }
  };
  for (const std::size_t valley : valleys) {
    const SampleRange wider{.first = group.range.first, .last = valley};
    const std::size_t lowest =
        ceiling[valley].v_mm_s < ceiling[group.lowest].v_mm_s ? valley : group.lowest;
    if (within_tick(wider, lowest)) {
      group = {.range = wider, .lowest = lowest};
    } else {
      close();
      group = {.range = {.first = valley, .last = valley}, .lowest = valley};
    }
  }
  const std::size_t end = ceiling.size() - 1;
  if (within_tick({.first = group.range.first, .last = end}, group.lowest)) {
    lower(ceiling, {.first = group.range.first, .last = end}, ceiling[group.lowest].v_mm_s);
  } else {
    close();
  }
  return kept;
}

// With samples on the lines between those whose feedrates are far apart, so that there are places
// to cut at.
Ceiling dense(const Ceiling& ceiling) {
  Ceiling all;
  for (const FeedSample& next : ceiling) {
    while (!all.empty()) {
      const FeedSample& at = all.back();
      const double ratio = next.v_mm_s / at.v_mm_s;
      if (!(ratio > kFarApart || ratio < 1.0 / kFarApart) || !(at.v_mm_s > 0.0)) {
        break;
      }
      const double v = ratio > 1.0 ? kFarApart * at.v_mm_s : at.v_mm_s / kFarApart;
      const double share = (v - at.v_mm_s) / (next.v_mm_s - at.v_mm_s);
      FeedSample between = at;
      between.u += share * (next.u - at.u);
      between.s_mm += share * (next.s_mm - at.s_mm);
      between.v_mm_s = v;
      if (!(between.s_mm > at.s_mm && between.s_mm < next.s_mm && between.u > at.u)) {
        break;
      }
      all.push_back(between);
    }
    all.push_back(next);
  }
  return all;
}

// A block may begin and end at rest.
void add_cuts(const Ceiling& ceiling, const SampleRange& range, const profiles::RampLimits& ramp,
              std::vector<std::size_t>& cuts) {
  const std::size_t top = top_of(ceiling, range);
  Samples rise = rise_of(ceiling, range, top);
  if (range.first == 0) {
    rise.front().v_mm_s = 0.0;
  }
  for (const std::size_t i : climb_cuts(rise, ramp)) {
    cuts.push_back(range.first + i);
  }
  Samples fall = fall_of(ceiling, range, top);
  if (range.last + 1 == ceiling.size()) {
    fall.front().v_mm_s = 0.0;
  }
  const std::vector<std::size_t> descent = climb_cuts(fall, ramp);
  for (auto i = descent.rbegin(); i != descent.rend(); ++i) {
    cuts.push_back(range.last - *i);
  }
}

struct Cutting {
  double noise = 0.0;
  double period_s = 0.0;
  profiles::RampLimits ramp{};  // no climb is steeper
};

std::vector<Span> split_at_valleys(const Block& block, const Ceiling& scanned, const Cutting& how) {
  Ceiling ceiling = dense(scanned);
  std::vector<std::size_t> ends =
      apart(valleys(ceiling, breaking_points(ceiling, kScreening_mm_s), how.noise), how.period_s,
            ceiling);
  ends.push_back(ceiling.size() - 1);
  std::vector<std::size_t> cuts;
  std::size_t first = 0;
  for (const std::size_t end : ends) {
    add_cuts(ceiling, {.first = first, .last = end}, how.ramp, cuts);
    cuts.push_back(end);
    first = end;
  }
  std::vector<Span> spans;
  first = 0;
  for (const std::size_t cut : cuts) {
    spans.push_back(span_between(block, ceiling, {.first = first, .last = cut}));
    first = cut;
    if (spans.size() > 1) {
      double& joint = spans[spans.size() - 2].end.feedrate_mm_s;
      joint = std::min(
          {joint, spans[spans.size() - 2].fall.bottom_mm_s(), spans.back().rise.bottom_mm_s()});
    }
  }
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

std::vector<Span> split(const Block& block, double period_s) {
  if (block.ceiling.empty()) {
    return {whole_span(block)};
  }
  return split_at_valleys(block, block.ceiling,
                          {.noise = kNoise, .period_s = period_s, .ramp = block.limits.ramp});
}

std::vector<Span> split(const Block& block, const Turning& turning, const PlanLimits& limits) {
  const auto steepest = [&](const Turning& under) -> profiles::RampLimits {
    const profiles::RampLimits& along = block.along.ramp;
    return {
        .acceleration_mm_s2 = std::min(along.acceleration_mm_s2,
                                       strongest(under, limits, &MotionLimits::acceleration_mm_s2)),
        .jerk_mm_s3 =
            std::min(along.jerk_mm_s3, strongest(under, limits, &MotionLimits::jerk_mm_s3))};
  };
  std::vector<Span> spans = split_at_valleys(
      block, lower_ceiling(block.ceiling, turning),
      {.noise = kTurningNoise, .period_s = limits.period_s, .ramp = steepest(turning)});
  for (Span& span : spans) {
    span.turning = part_of(turning, span);
    span.axes = limits.axes;
    span.limits.ramp = steepest(span.turning);
  }
  return spans;
}

}  // namespace kerf::lookahead
