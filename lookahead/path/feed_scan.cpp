#include "lookahead/path/feed_scan.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace kerf::lookahead {

using curves::NurbsCurve;

namespace {

// What straight lines between samples may miss of the bound.
constexpr double kInside = 0.9998;
// What a plan may add to the way of a tick is taken off the bound, as far as this share is left.
constexpr double kMinShare = 0.5;

// The middles of ticks as a limit curve over s. Just before a sharp turn middles run backwards: a
// tick that begins earlier is let past the turn, one that begins later is not. The slower one
// counts, and that is the later one.
VelocityLimitCurve in_order(const VelocityLimitCurve& samples) {
  VelocityLimitCurve kept;
  for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample) {
    if (kept.empty() || sample->s_mm < kept.back().s_mm) {
      kept.push_back(*sample);
    }
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

// Along the path at a feedrate: of an axis it may be higher than its limit by what curvature takes
// off. Both unbounded where nothing binds.
MotionLimits ramp_at(const NurbsCurve& curve, const FeedSample& at, const ScanLimits& limits) {
  MotionLimits ramp = limits.along;
  const curves::PathDerivatives path = curve.derivatives_at(at.s_mm);
  const double squared = at.v_mm_s * at.v_mm_s;
  for (std::size_t k = 0; k < path.first.size(); ++k) {
    if (path.first[k] != 0.0) {
      const double along = std::abs(path.first[k]);
      const double across = std::abs(path.second_per_mm[k]) * squared;
      const double from_curvature = std::abs(path.third_per_mm2[k]) * squared * at.v_mm_s;
      ramp.acceleration_mm_s2 =
          std::min(ramp.acceleration_mm_s2, (limits.axes[k].acceleration_mm_s2 + across) / along);
      ramp.jerk_mm_s3 =
          std::min(ramp.jerk_mm_s3, (limits.axes[k].jerk_mm_s3 + from_curvature) / along);
    }
  }
  return ramp;
}

// By how much the mean feedrate of a tick may be above the one at its middle.
struct OverLimit {
  double on_slope_mm_s = 0.0;
  double in_valley_mm_s = 0.0;
};

OverLimit excess_at(const NurbsCurve& curve, const FeedSample& middle, const ScanLimits& limits) {
  const MotionLimits ramp = ramp_at(curve, middle, limits);
  const double by_jerk = ramp.jerk_mm_s3 * limits.period_s * limits.period_s / 24.0;
  const double by_jump = 0.25 * ramp.acceleration_mm_s2 * limits.period_s;
  const double on_slope = std::isfinite(by_jerk) ? by_jerk : 0.0;
  return {.on_slope_mm_s = on_slope,
          .in_valley_mm_s =
              limits.plan == ScanFor::trapezoid && std::isfinite(by_jump) ? by_jump : on_slope};
}

// Of a tick that may be run nowhere faster than its mean.
struct HeldTick {
  double begin_mm = 0.0;
  double end_mm = 0.0;
  double v_mm_s = 0.0;
};

FeedSample sample_at(const NurbsCurve& curve, double s_mm, const FeedSample& like) {
  FeedSample sample = like;
  sample.s_mm = s_mm;
  sample.u = curve.pieces()[curve.piece_index(s_mm)].u_at(s_mm);
  return sample;
}

bool is_before(const FeedSample& a, const FeedSample& b) {
  return a.s_mm < b.s_mm;
}

// Between two samples, or as the first or last one.
FeedSample on_line(const VelocityLimitCurve& limit_curve, double s_mm, const NurbsCurve& curve) {
  const auto after =
      std::upper_bound(limit_curve.begin(), limit_curve.end(), FeedSample{.s_mm = s_mm}, is_before);
  FeedSample sample = sample_at(curve, s_mm, after == limit_curve.begin() ? *after : *(after - 1));
  if (after != limit_curve.begin() && after != limit_curve.end()) {
    const FeedSample& before = *(after - 1);
    const double share = (s_mm - before.s_mm) / (after->s_mm - before.s_mm);
    sample.v_mm_s += share * (after->v_mm_s - before.v_mm_s);
  }
  return sample;
}

// From end to end of the curve, of samples that may lie beside it.
VelocityLimitCurve along(const NurbsCurve& curve, const VelocityLimitCurve& middles) {
  const double length = curve.length_mm();
  VelocityLimitCurve limit_curve{on_line(middles, 0.0, curve)};
  for (const FeedSample& middle : middles) {
    if (middle.s_mm > 0.0 && middle.s_mm < length) {
      limit_curve.push_back(sample_at(curve, middle.s_mm, middle));
    }
  }
  limit_curve.push_back(on_line(middles, length, curve));
  return limit_curve;
}

// The samples with those at the ends of the ticks, on the lines between.
VelocityLimitCurve with_ends(const VelocityLimitCurve& limit_curve,
                             const std::vector<HeldTick>& ticks, const NurbsCurve& curve) {
  VelocityLimitCurve all = limit_curve;
  for (const HeldTick& tick : ticks) {
    all.push_back(on_line(limit_curve, tick.begin_mm, curve));
    all.push_back(on_line(limit_curve, tick.end_mm, curve));
  }
  std::stable_sort(all.begin(), all.end(), is_before);
  const auto is_same = [](const FeedSample& a, const FeedSample& b) {
    return !(b.s_mm > a.s_mm && b.u > a.u);
  };
  all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
  all.back().s_mm = limit_curve.back().s_mm;  // u may tell less apart than s
  return all;
}

// No sample higher than the slowest tick over it. The ticks ascend by their begin.
void hold(const std::vector<HeldTick>& ticks, VelocityLimitCurve& limit_curve) {
  const auto is_faster = [](const HeldTick& a, const HeldTick& b) { return a.v_mm_s > b.v_mm_s; };
  std::priority_queue<HeldTick, std::vector<HeldTick>, decltype(is_faster)> begun(is_faster);
  auto next = ticks.begin();
  for (FeedSample& at : limit_curve) {
    for (; next != ticks.end() && next->begin_mm <= at.s_mm; ++next) {
      begun.push(*next);
    }
    while (!begun.empty() && begun.top().end_mm < at.s_mm) {
      begun.pop();
    }
    if (!begun.empty() && begun.top().v_mm_s < at.v_mm_s) {
      at.v_mm_s = begun.top().v_mm_s;
      at.limit = Constraint::chord_error;
    }
  }
}

}  // namespace

VelocityLimitCurve scan_feedrate(const NurbsCurve& curve, const ScanLimits& limits) {
  const double length = curve.length_mm();
  VelocityLimitCurve middles;
  std::vector<HeldTick> held;
  for (const TickBound& bound : tick_bounds(curve, limits)) {
    const bool binds = bound.v_mm_s < limits.feedrate_mm_s;
    const double way = bound.v_mm_s * limits.period_s;
    const double middle = bound.s_mm + 0.5 * way;
    double v = bound.v_mm_s;
    if (binds) {
      const OverLimit excess =
          excess_at(curve, {.s_mm = std::clamp(middle, 0.0, length), .v_mm_s = v}, limits);
      v = kInside * std::max(v - excess.on_slope_mm_s, kMinShare * v);
      const HeldTick tick{.begin_mm = std::max(bound.s_mm, 0.0),
                          .end_mm = std::min(bound.s_mm + way, length),
                          .v_mm_s = kInside * bound.v_mm_s};
      if (excess.in_valley_mm_s > (1.0 - kMinShare) * bound.v_mm_s && tick.begin_mm < tick.end_mm) {
        held.push_back(tick);
      }
    }
    middles.push_back({.s_mm = middle,
                       .v_mm_s = v,
                       .limit = binds ? Constraint::chord_error : limits.feedrate_from});
  }
  VelocityLimitCurve limit_curve = along(curve, in_order(middles));
  if (!held.empty()) {
    limit_curve = with_ends(limit_curve, held, curve);
    hold(held, limit_curve);
  }
  return limit_curve;
}

}  // namespace kerf::lookahead
