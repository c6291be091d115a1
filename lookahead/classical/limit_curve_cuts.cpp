#include "lookahead/classical/limit_curve_cuts.hpp"

#include <algorithm>
#include <cassert>

namespace kerf::lookahead {

namespace {

// Between samples half a tick apart any change of slope is a candidate here; the second step and
// the comparison with the neighbours sort out what is a valley.
constexpr double kScreening_mm_s = 0.0;
constexpr double kFarApart = 4.0;  // feedrates of neighbours: times

using Samples = std::vector<Slope::Sample>;

Samples rise_of(const VelocityLimitCurve& limit_curve, const SampleRange& range, std::size_t top) {
  Samples samples;
  for (std::size_t i = range.first; i <= top; ++i) {
    samples.push_back({limit_curve[i].s_mm - limit_curve[range.first].s_mm, limit_curve[i].v_mm_s});
  }
  return samples;
}

Samples fall_of(const VelocityLimitCurve& limit_curve, const SampleRange& range, std::size_t top) {
  Samples samples;
  for (std::size_t i = range.last + 1; i-- > top;) {
    samples.push_back({limit_curve[range.last].s_mm - limit_curve[i].s_mm, limit_curve[i].v_mm_s});
  }
  return samples;
}

std::size_t top_of(const VelocityLimitCurve& limit_curve, const SampleRange& range) {
  const auto at = [&limit_curve](std::size_t i) {
    return limit_curve.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto top =
      std::ranges::max_element(at(range.first), at(range.last + 1), {}, &FeedSample::v_mm_s);
  return static_cast<std::size_t>(top - limit_curve.begin());
}

void lower(VelocityLimitCurve& limit_curve, const SampleRange& range, double v_mm_s) {
  for (std::size_t k = range.first; k <= range.last; ++k) {
    limit_curve[k].v_mm_s = std::min(limit_curve[k].v_mm_s, v_mm_s);
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
                               VelocityLimitCurve& limit_curve) {
  const auto within_tick = [&](const SampleRange& range, std::size_t lowest) {
    return limit_curve[range.last].s_mm - limit_curve[range.first].s_mm <=
           limit_curve[lowest].v_mm_s * period_s;
  };
  std::vector<std::size_t> kept;
  ValleyGroup group;
  const auto close = [&] {
    lower(limit_curve, group.range, limit_curve[group.lowest].v_mm_s);
    if (group.range.first > 0) {
      kept.push_back(group.lowest);
    }
  };
  for (const std::size_t valley : valleys) {
    const SampleRange wider{.first = group.range.first, .last = valley};
    const std::size_t lowest =
        limit_curve[valley].v_mm_s < limit_curve[group.lowest].v_mm_s ? valley : group.lowest;
    if (within_tick(wider, lowest)) {
      group = {.range = wider, .lowest = lowest};
    } else {
      close();
      group = {.range = {.first = valley, .last = valley}, .lowest = valley};
    }
  }
  const std::size_t end = limit_curve.size() - 1;
  if (within_tick({.first = group.range.first, .last = end}, group.lowest)) {
    lower(limit_curve, {.first = group.range.first, .last = end}, limit_curve[group.lowest].v_mm_s);
  } else {
    close();
  }
  return kept;
}

// With samples on the lines between those whose feedrates are far apart, so that there are places
// to cut at.
VelocityLimitCurve dense(const VelocityLimitCurve& limit_curve) {
  VelocityLimitCurve all;
  for (const FeedSample& next : limit_curve) {
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
void add_cuts(const VelocityLimitCurve& limit_curve, const SampleRange& range,
              const profiles::RampLimits& ramp, std::vector<std::size_t>& cuts) {
  Hill hill = hill_of(limit_curve, range);
  if (range.first == 0) {
    hill.rise.front().v_mm_s = 0.0;
  }
  for (const std::size_t i : ramp_cuts(hill.rise, ramp)) {
    cuts.push_back(range.first + i);
  }
  if (range.last + 1 == limit_curve.size()) {
    hill.fall.front().v_mm_s = 0.0;
  }
  const std::vector<std::size_t> falling = ramp_cuts(hill.fall, ramp);
  for (auto i = falling.rbegin(); i != falling.rend(); ++i) {
    cuts.push_back(range.last - *i);
  }
}

}  // namespace

Hill hill_of(const VelocityLimitCurve& limit_curve, const SampleRange& range) {
  assert(range.first <= range.last && range.last < limit_curve.size());
  const std::size_t top = top_of(limit_curve, range);
  return {.rise = rise_of(limit_curve, range, top), .fall = fall_of(limit_curve, range, top)};
}

CutLimitCurve cut(const VelocityLimitCurve& scanned, const Cutting& how) {
  assert(scanned.size() >= 2);
  CutLimitCurve result{.limit_curve = dense(scanned), .cuts = {}};
  VelocityLimitCurve& limit_curve = result.limit_curve;
  std::vector<std::size_t> ends =
      apart(valleys(limit_curve, breaking_points(limit_curve, kScreening_mm_s), how.noise),
            how.period_s, limit_curve);
  ends.push_back(limit_curve.size() - 1);
  std::size_t first = 0;
  for (const std::size_t end : ends) {
    add_cuts(limit_curve, {.first = first, .last = end}, how.ramp, result.cuts);
    result.cuts.push_back(end);
    first = end;
  }
  return result;
}

}  // namespace kerf::lookahead
