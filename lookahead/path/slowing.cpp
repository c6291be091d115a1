#include "lookahead/path/slowing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "lookahead/path/block_builder.hpp"
#include "profiles/s_curve_stop.hpp"

namespace kerf::lookahead {

namespace {

constexpr int kBisections = 40;
// A motion that is hardly above the feedrate.
constexpr double kHardly = 1e-6;
constexpr double kAtRest_mm_s = 1e-6;
constexpr double kInside = 0.999;
// The way is drawn out by so much more than what a stop from there takes.
constexpr double kStretch = 1.05;
// A search needs room below a bound; at the begin, where it has none, so much of the feedrate, and
// more of it where the motion still speeds up with all of its jerk.
constexpr double kRoom = 1e-3;
constexpr double kRoomOfRise = 4e-3;
constexpr int kSamples = 200;  // of the bound on a block

// As seen from a frame that moves with the feedrate it slows down to.
struct SlowingDown {
  std::array<profiles::CellLaw, 3> laws{};
  double to_mm_s = 0.0;

  [[nodiscard]] double duration_s() const {
    return laws[0].duration_s() + laws[1].duration_s() + laws[2].duration_s();
  }
  [[nodiscard]] profiles::PathMotion at(double t_s) const {
    double way_mm = to_mm_s * t_s;
    for (const profiles::CellLaw& law : laws) {
      if (law.duration_s() > 0.0 && t_s <= law.duration_s()) {
        profiles::PathMotion motion = law.at(t_s);
        motion.s_mm += way_mm;
        motion.v_mm_s += to_mm_s;
        return motion;
      }
      t_s -= law.duration_s();
      way_mm += law.length_mm();
    }
    return {.s_mm = way_mm, .v_mm_s = to_mm_s};
  }
};

// Nothing: it is not faster, or no S-curve keeps the limits.
std::optional<SlowingDown> slowing_down(const profiles::PathMotion& motion,
                                        const profiles::RampLimits& ramp, double to_mm_s) {
  const auto [acceleration, jerk] = ramp;
  const double above = motion.v_mm_s - to_mm_s;
  const double a = std::min(motion.a_mm_s2, acceleration);
  const double overshoot = above + (a > 0.0 ? 0.5 * a * a / jerk : 0.0);
  if (!(overshoot > kHardly * motion.v_mm_s)) {
    return std::nullopt;
  }
  const double v = std::max(above, kHardly * motion.v_mm_s);
  const double lowest = -kInside * std::min(std::sqrt(2.0 * jerk * v), acceleration);
  const auto stop = profiles::s_curve_stop({.v_mm_s = v, .a_mm_s2 = std::max(a, lowest)}, ramp);
  if (!stop) {
    return std::nullopt;
  }
  return SlowingDown{.laws = {stop->falling, stop->steady, stop->landing}, .to_mm_s = to_mm_s};
}

double feedrate_behind(const SlowingDown& down, double way_mm) {
  double low = 0.0;
  double high = down.duration_s();
  if (way_mm >= down.at(high).s_mm) {
    return down.to_mm_s;
  }
  for (int i = 0; i < kBisections; ++i) {
    const double t = 0.5 * (low + high);
    (down.at(t).s_mm < way_mm ? low : high) = t;
  }
  return down.at(high).v_mm_s;
}

// What the block allows where nothing has to slow down.
double allowed_mm_s(const Block& block, const SlowingOrder& order, const PlanLimits& limits) {
  if (!block.rapid) {
    return share_of(order.by, block.follows) * block.feedrate_mm_s;
  }
  Block full = block;
  set_limits(kUnbounded, limits, order.plan, full);
  return share_of_rapid(order.by, block.follows) * full.along.feedrate_mm_s;
}

FeedSample sample_of(const Block& block, double s_mm) {
  const VelocityLimitCurve& curve = block.limit_curve;
  const auto after = std::ranges::lower_bound(curve, s_mm, {}, &FeedSample::s_mm);
  if (after == curve.end() || after == curve.begin()) {
    FeedSample at = curve.empty()          ? FeedSample{.v_mm_s = block.along.feedrate_mm_s,
                                                        .limit = block.along.from.feedrate}
                    : after == curve.end() ? curve.back()
                                           : curve.front();
    at.s_mm = s_mm;
    return at;
  }
  const FeedSample& before = *std::prev(after);
  const double share = (s_mm - before.s_mm) / (after->s_mm - before.s_mm);
  return {.u = before.u + share * (after->u - before.u),
          .s_mm = s_mm,
          .v_mm_s = before.v_mm_s + share * (after->v_mm_s - before.v_mm_s),
          .limit = before.limit};
}

// The least of those that the motion comes to on its way to rest.
profiles::RampLimits ramp_of(const SlowingOrder& order, const std::vector<Block*>& blocks) {
  profiles::RampLimits ramp{.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = kUnbounded};
  double begin_mm = -order.motion.s_mm;
  for (const Block* block : blocks) {
    if (begin_mm > order.to_rest_mm) {
      break;
    }
    const profiles::RampLimits& of = block->limits.ramp;
    ramp.acceleration_mm_s2 = std::min(ramp.acceleration_mm_s2, of.acceleration_mm_s2);
    ramp.jerk_mm_s3 = std::min(ramp.jerk_mm_s3, of.jerk_mm_s3);
    begin_mm += block->length_mm;
  }
  return ramp;
}

// The block begins so far behind the motion. before: with the limits that it had so far.
void bind(const Slowing& slowing, const Slowing::Ahead& ahead, const Block& before, Block& block) {
  const auto [begin_mm, to_mm_s] = ahead;
  const double from_mm = std::max(-begin_mm, 0.0);
  const double end_mm = std::min(slowing.way_mm(to_mm_s) - begin_mm, block.length_mm);
  VelocityLimitCurve curve = block.limit_curve;
  curve.push_back(sample_of(block, 0.0));
  for (int i = 0; i <= kSamples; ++i) {
    curve.push_back(sample_of(block, from_mm + (end_mm - from_mm) * i / kSamples));
  }
  curve.push_back(sample_of(block, block.length_mm));
  std::ranges::stable_sort(curve, {}, &FeedSample::s_mm);
  curve.erase(
      std::unique(curve.begin(), curve.end(),
                  [](const FeedSample& a, const FeedSample& b) { return a.s_mm == b.s_mm; }),
      curve.end());
  for (FeedSample& sample : curve) {
    const double way_mm = std::max(begin_mm + sample.s_mm, 0.0);
    const double max_mm_s =
        std::max((1.0 + kRoom) * sample_of(before, sample.s_mm).v_mm_s, to_mm_s);
    const double bound =
        std::min(slowing.bound_mm_s({.way_mm = way_mm, .to_mm_s = to_mm_s}), max_mm_s);
    if (bound < sample.v_mm_s) {
      sample.v_mm_s = bound;
      sample.limit = Constraint::programmed;
    }
  }
  block.limit_curve = std::move(curve);
  block.slows = true;
}

}  // namespace

Slowing::Slowing(const profiles::PathMotion& motion, const profiles::RampLimits& ramp,
                 double to_rest_mm)
    : motion_(motion), ramp_(ramp) {
  if (const auto down = slowing_down(motion, ramp, kAtRest_mm_s)) {
    stretch_ = kStretch * std::max(to_rest_mm / down->at(down->duration_s()).s_mm, 1.0);
  }
}

double Slowing::bound_mm_s(const Ahead& ahead) const {
  const auto [way_mm, to_mm_s] = ahead;
  const auto down = slowing_down(motion_, ramp_, to_mm_s);
  if (!down) {
    return to_mm_s;
  }
  const double rise_s = std::max(motion_.a_mm_s2, 0.0) / ramp_.jerk_mm_s3;
  const profiles::PathMotion peak = down->at(rise_s);
  const bool rises = way_mm <= peak.s_mm;
  const double v = feedrate_behind(*down, rises ? way_mm : std::max(peak.s_mm, way_mm / stretch_));
  // As long as it rises it may be all but where the bound is.
  const double above = rises ? 1.0 : std::clamp((v - to_mm_s) / (peak.v_mm_s - to_mm_s), 0.0, 1.0);
  const double beside_rise = peak.s_mm > 0.0 ? std::clamp(2.0 - way_mm / peak.s_mm, 0.0, 1.0) : 0.0;
  return v + (kRoom + kRoomOfRise * beside_rise) * above * peak.v_mm_s;
}

double Slowing::way_mm(double to_mm_s) const {
  const auto down = slowing_down(motion_, ramp_, to_mm_s);
  return down ? stretch_ * down->at(down->duration_s()).s_mm : 0.0;
}

double Slowing::max_mm_s() const {
  const double a = std::max(motion_.a_mm_s2, 0.0);
  return (1.0 + kRoom) * (motion_.v_mm_s + 0.5 * a * a / ramp_.jerk_mm_s3);
}

std::size_t let_slow_down(const SlowingOrder& order, const PlanLimits& limits,
                          const std::vector<Block*>& blocks) {
  const Slowing slowing(order.motion, ramp_of(order, blocks), order.to_rest_mm);
  double begin_mm = -order.motion.s_mm;  // of the block, from the motion on
  std::size_t count = 0;
  for (Block* block : blocks) {
    const double way_mm = std::max(begin_mm, 0.0);
    const double to_mm_s = allowed_mm_s(*block, order, limits);
    if (slowing.bound_mm_s({.way_mm = way_mm, .to_mm_s = kAtRest_mm_s}) <= 2.0 * kAtRest_mm_s) {
      break;  // as slow as any block may want it
    }
    ++count;
    if (slowing.bound_mm_s({.way_mm = way_mm, .to_mm_s = to_mm_s}) > to_mm_s) {
      const Block before = *block;
      const double max_mm_s = std::max(slowing.max_mm_s(), to_mm_s);
      set_limits(block->rapid ? kUnbounded : max_mm_s, limits, order.plan, *block);
      bind(slowing, {.way_mm = begin_mm, .to_mm_s = to_mm_s}, before, *block);
    } else {
      set_limits(order.by, limits, order.plan, *block);
    }
    begin_mm += block->length_mm;
  }
  return count;
}

}  // namespace kerf::lookahead
