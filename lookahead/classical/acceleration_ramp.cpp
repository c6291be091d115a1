#include "lookahead/classical/acceleration_ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lookahead/classical/axis_limit_check.hpp"

namespace kerf::lookahead {

using profiles::Profile;
using profiles::ProfileKind;
using profiles::Ramp;
using profiles::RampLimits;
using profiles::Transition;

namespace {

constexpr int kRounds = 60;
// From these rounds on each takes a little more than was asked for, then much more.
constexpr int kPatientRounds = 3;
constexpr int kUsualRounds = 15;
constexpr double kWithRounding = 1.0 + 1e-9;
// Where a ramp may also begin: where this many times the feedrate of its foot is allowed.
constexpr std::array kRises = {1.2, 1.6, 2.5};

const Slope& slope_of(const RampRequest& request, const VelocitySegment& segment) {
  return request.side == SegmentSide::rise ? segment.rise : segment.fall;
}

// Against covering the same way at the feedrate of its top.
double lost_s(const AccelerationRamp& ramp) {
  return ramp.duration_s() - ramp.length_mm() / ramp.law.ramp().v_end_mm_s;
}

// Begins later, or is gentler and begins not so late, where the wait takes longer than the ramp.
AccelerationRamp delayed(const Slope& slope, const Transition& fastest) {
  AccelerationRamp best{.law = fastest, .delay_mm = slope.delay_for_mm(fastest)};
  AccelerationRamp next = best;
  while (next.duration_s() > 2.0 * next.law.duration_s()) {
    next.law = next.law.stretched(2.0);
    next.delay_mm = slope.delay_for_mm(next.law);
    best = lost_s(next) < lost_s(best) ? next : best;
  }
  return best;
}

AccelerationRamp below(const Slope& slope, const Transition& fastest, const Profile& profile) {
  if (slope.empty()) {
    return {.law = fastest};
  }
  if (profile.kind() == ProfileKind::trapezoid && fastest.ramp().v_begin_mm_s > 0.0) {
    return delayed(slope, fastest);
  }
  return {.law = fastest.stretched(slope.stretch_for(fastest))};
}

// Where the law begins on the curve: past the part at constant velocity and the delay.
PlacedRamp placed(const AccelerationRamp& ramp, const RampRequest& request,
                  const VelocitySegment& segment) {
  const double v = request.ramp.v_begin_mm_s;
  if (request.side == SegmentSide::rise) {
    return {.law = ramp.law,
            .foot_mm = segment.s_begin_mm + v * segment.begin_constant_velocity_s + ramp.delay_mm,
            .direction = 1.0};
  }
  return {.law = ramp.law,
          .foot_mm = segment.s_begin_mm + segment.length_mm - v * segment.end.constant_velocity_s -
                     ramp.delay_mm,
          .direction = -1.0};
}

// Where it may also begin, as far from its end of the segment.
std::vector<double> feet_mm(const RampRequest& request, const Slope& slope) {
  std::vector<double> all_mm;
  const double v = request.ramp.v_begin_mm_s;
  if (request.may_wait && v > 0.0 && !slope.empty()) {
    for (const double rise : kRises) {
      const double foot_mm = slope.allowed_from_mm(rise * v);
      if (rise * v < request.ramp.v_end_mm_s && foot_mm > 0.0) {
        all_mm.push_back(foot_mm);
      }
    }
  }
  return all_mm;
}

double lost_in_s(const AccelerationRamp& ramp, const RampRequest& request) {
  return ramp.length_mm() <= request.room_mm ? lost_s(ramp) : kUnbounded;
}

// A gentler ramp each round.
class Gentler {
 public:
  Gentler(const Ramp& ramp, const RampLimits& limits, const Profile& profile)
      : ramp_(ramp), limits_(limits), profile_(profile) {}

  [[nodiscard]] Transition law() const {
    const Transition fastest = profile_.fastest(ramp_, limits_);
    return stretch_ > 1.0 ? fastest.stretched(stretch_) : fastest;
  }

  // done: the law as it was placed.
  void give_way(const RampReduction& ask, const Transition& done, int round) {
    const double more = round < kPatientRounds ? 1.0 : (round < kUsualRounds ? 0.97 : 0.7);
    const double slower = done.duration_s() / law().duration_s();
    if (profile_.kind() == ProfileKind::s_curve) {
      const double change = ramp_.v_end_mm_s - ramp_.v_begin_mm_s;
      const double peak =
          std::min(limits_.acceleration_mm_s2, std::sqrt(limits_.jerk_mm_s3 * change));
      limits_.acceleration_mm_s2 = peak / slower * ask.acceleration;
      limits_.jerk_mm_s3 *= ask.jerk / (slower * slower);
      limits_.acceleration_mm_s2 *= ask.acceleration < 1.0 ? more : 1.0;
      limits_.jerk_mm_s3 *= ask.jerk < 1.0 ? more : 1.0;
    } else {
      stretch_ *= std::max(slower, 1.0) * ask.stretch / more;
    }
  }

 private:
  Ramp ramp_;
  RampLimits limits_;
  const Profile& profile_;
  double stretch_ = 1.0;
};

// Where a ramp begins, from its end of the segment; one that loses more is not wanted.
struct Foot {
  double at_mm = 0.0;
  double lost_at_most_s = kUnbounded;
};

// The ramp that begins no nearer than the foot, up to which it cruises, as curvature allows
// (PathSample::feedrate_mm_s).
AccelerationRamp gentle_enough(const RampRequest& request, const Foot& foot,
                               const VelocitySegment& segment, const Profile& profile) {
  const Slope slope = foot.at_mm > 0.0 ? slope_of(request, segment).from(foot.at_mm) : Slope{};
  const Slope& above = foot.at_mm > 0.0 ? slope : slope_of(request, segment);
  Gentler gentler(request.ramp, segment.limits.ramp, profile);
  for (int round = 0; round < kRounds; ++round) {
    AccelerationRamp ramp = below(above, gentler.law(), profile);
    ramp.delay_mm += foot.at_mm;
    // A gentler one needs no less room and loses no less time, but for a trapezoid that waits.
    const bool loses_more = profile.kind() != ProfileKind::trapezoid &&
                            lost_s(ramp) > kWithRounding * foot.lost_at_most_s;
    if (!(ramp.length_mm() <= request.room_mm) || loses_more) {
      return ramp;
    }
    const RampReduction ask =
        ramp_reduction(placed(ramp, request, segment), segment.axis_limits, segment.axes);
    if (ask.holds()) {
      return ramp;
    }
    gentler.give_way(ask, ramp.law, round);
  }
  return {.law = profile.fastest(request.ramp, segment.limits.ramp), .delay_mm = kUnbounded};
}

}  // namespace

AccelerationRamp acceleration_ramp(const RampRequest& request, const VelocitySegment& segment,
                                   const Profile& profile) {
  const Slope& slope = slope_of(request, segment);
  const double v = request.ramp.v_begin_mm_s;
  if (segment.axis_limits.empty() || v == request.ramp.v_end_mm_s) {
    return below(slope, profile.fastest(request.ramp, segment.limits.ramp), profile);
  }
  AccelerationRamp best = gentle_enough(request, {}, segment, profile);
  for (const double foot_mm : feet_mm(request, slope)) {
    const AccelerationRamp other = gentle_enough(
        request, {.at_mm = foot_mm, .lost_at_most_s = lost_in_s(best, request)}, segment, profile);
    best = lost_in_s(other, request) < lost_in_s(best, request) ? other : best;
  }
  return best;
}

double least_length_mm(const RampRequest& request, const VelocitySegment& segment,
                       const Profile& profile) {
  const Slope& slope = slope_of(request, segment);
  const Transition fastest = profile.fastest(request.ramp, segment.limits.ramp);
  if (slope.empty() || profile.kind() == ProfileKind::trapezoid) {
    return fastest.length_mm();
  }
  double least_mm = below(slope, fastest, profile).length_mm();
  for (const double foot_mm : feet_mm(request, slope)) {  // having waited it may be stretched less
    least_mm = std::min(least_mm, foot_mm + fastest.length_mm());
  }
  return least_mm;
}

double ramp_length_mm(const RampRequest& request, const VelocitySegment& segment,
                      const Profile& profile) {
  return slope_of(request, segment).empty() && segment.axis_limits.empty()
             ? profile.length_mm(request.ramp, segment.limits.ramp)
             : acceleration_ramp(request, segment, profile).length_mm();
}

}  // namespace kerf::lookahead
