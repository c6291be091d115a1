#include "lookahead/path/remainder.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kerf::lookahead {

namespace {

std::vector<LineMark> marks_on(const std::vector<LineMark>& marks, const curves::Stretch& stretch) {
  std::vector<LineMark> on;
  for (const LineMark& mark : marks) {
    if (mark.s_mm >= stretch.end_mm) {
      break;
    }
    if (mark.s_mm <= stretch.begin_mm) {
      on.clear();
    }
    on.push_back(mark);
    on.back().s_mm = std::max(mark.s_mm - stretch.begin_mm, 0.0);
  }
  return on;
}

// On the line between the two samples around the place.
FeedSample sample_at(const VelocityLimitCurve& curve, double s_mm) {
  const auto after = std::ranges::upper_bound(curve, s_mm, {}, &FeedSample::s_mm);
  if (after == curve.begin() || after == curve.end()) {
    return after == curve.begin() ? curve.front() : curve.back();
  }
  const FeedSample& before = *std::prev(after);
  const double share = (s_mm - before.s_mm) / (after->s_mm - before.s_mm);
  return {.u = before.u + share * (after->u - before.u),
          .s_mm = s_mm,
          .v_mm_s = before.v_mm_s + share * (after->v_mm_s - before.v_mm_s),
          .limit = before.limit};
}

VelocityLimitCurve limit_curve_on(const VelocityLimitCurve& curve, const curves::Stretch& stretch,
                                  double length_mm) {
  if (curve.empty()) {
    return {};
  }
  VelocityLimitCurve on{sample_at(curve, stretch.begin_mm)};
  for (const FeedSample& sample : curve) {
    if (sample.s_mm > stretch.begin_mm && sample.s_mm < stretch.end_mm) {
      on.push_back(sample);
    }
  }
  on.push_back(sample_at(curve, stretch.end_mm));
  for (FeedSample& sample : on) {
    sample.s_mm -= stretch.begin_mm;
  }
  on.front().s_mm = 0.0;
  on.back().s_mm = length_mm;
  return on;
}

}  // namespace

std::optional<Block> stretch_of(const Block& block, const curves::Stretch& stretch) {
  auto curve = curves::part(block.curve, stretch);
  if (!curve || !(curves::length_mm(*curve) > 0.0)) {
    return std::nullopt;
  }
  Block on{.curve = std::move(*curve)};
  on.extra = block.extra;
  const LineMark mark = block.mark_at(stretch.begin_mm);
  on.line = mark.line;
  on.run_block = mark.run_block;
  on.marks = marks_on(block.marks, stretch);
  on.rapid = block.rapid;
  on.deviation_mm = block.deviation_mm;
  on.feedrate_mm_s = block.feedrate_mm_s;
  on.follows = block.follows;
  on.arc_normal = block.arc_normal;
  on.slows = block.slows;
  on.length_mm = curves::length_mm(on.curve);
  on.limits = block.limits;
  on.along = block.along;
  on.begin = block.begin;
  on.end = block.end;
  if (stretch.begin_mm > 0.0) {
    static_cast<curves::PathDerivatives&>(on.begin) = curves::derivatives_at(on.curve, 0.0);
  }
  if (stretch.end_mm < block.length_mm) {
    static_cast<curves::PathDerivatives&>(on.end) = curves::derivatives_at(on.curve, on.length_mm);
  } else {
    on.stop_after = block.stop_after;
  }
  on.limit_curve = limit_curve_on(block.limit_curve, stretch, on.length_mm);
  return on;
}

std::optional<Block> remainder_of(const std::shared_ptr<const Block>& whole, double s_mm) {
  auto rest = stretch_of(*whole, {.begin_mm = s_mm, .end_mm = whole->length_mm});
  if (rest) {
    rest->whole = whole;
    rest->begin_mm = s_mm;
  }
  return rest;
}

Block whole_of(Block&& block) {
  return block.whole ? Block(*block.whole) : std::move(block);
}

}  // namespace kerf::lookahead
