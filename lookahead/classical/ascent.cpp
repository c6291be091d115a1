#include "lookahead/classical/ascent.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lookahead/classical/turn_check.hpp"

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
// Where a climb may also begin: where this many times the feedrate of its foot is allowed.
constexpr std::array kRises = {1.2, 1.6, 2.5};

const Slope& slope_of(const Climb& climb, const VelocitySegment& segment) {
  return climb.side == SegmentSide::rise ? segment.rise : segment.fall;
}

// Against covering the same way at the feedrate of its top.
double lost_s(const Ascent& ascent) {
  return ascent.duration_s() - ascent.length_mm() / ascent.law.ramp().v_end_mm_s;
}

// Begins later, or is gentler and begins not so late, where the wait takes longer than the climb.
Ascent delayed(const Slope& slope, const Transition& fastest) {
  Ascent best{.law = fastest, .foot_mm = slope.delay_for_mm(fastest)};
  Ascent next = best;
  while (next.duration_s() > 2.0 * next.law.duration_s()) {
    next.law = next.law.stretched(2.0);
    next.foot_mm = slope.delay_for_mm(next.law);
    best = lost_s(next) < lost_s(best) ? next : best;
  }
  return best;
}

Ascent below(const Slope& slope, const Transition& fastest, const Profile& profile) {
  if (slope.empty()) {
    return {.law = fastest};
  }
  if (profile.kind() == ProfileKind::trapezoid && fastest.ramp().v_begin_mm_s > 0.0) {
    return delayed(slope, fastest);
  }
  return {.law = fastest.stretched(slope.stretch_for(fastest))};
}

// Where the law begins on the curve: past the coast and the foot.
PlacedClimb placed(const Ascent& ascent, const Climb& climb, const VelocitySegment& segment) {
  const double v = climb.ramp.v_begin_mm_s;
  if (climb.side == SegmentSide::rise) {
    return {.law = ascent.law,
            .foot_mm = segment.s_begin_mm + v * segment.begin_coast_s + ascent.foot_mm,
            .direction = 1.0};
  }
  return {
      .law = ascent.law,
      .foot_mm = segment.s_begin_mm + segment.length_mm - v * segment.end.coast_s - ascent.foot_mm,
      .direction = -1.0};
}

double lost_in_s(const Ascent& ascent, const Climb& climb) {
  return ascent.length_mm() <= climb.room_mm ? lost_s(ascent) : kUnbounded;
}

// A gentler climb each round.
class Gentler {
 public:
  Gentler(const Ramp& ramp, const RampLimits& limits, const Profile& profile)
      : ramp_(ramp), limits_(limits), profile_(profile) {}

  [[nodiscard]] Transition law() const {
    const Transition fastest = profile_.fastest(ramp_, limits_);
    return stretch_ > 1.0 ? fastest.stretched(stretch_) : fastest;
  }

  // done: the law as it was placed.
  void give_way(const TurnAsk& ask, const Transition& done, int round) {
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

// The climb that begins no nearer to its end of the segment than foot_mm. The foot cruises, which
// turning allows (TurnSample::feedrate_mm_s).
Ascent gentle_enough(const Climb& climb, double foot_mm, const VelocitySegment& segment,
                     const Profile& profile) {
  const Slope slope = foot_mm > 0.0 ? slope_of(climb, segment).from(foot_mm) : Slope{};
  const Slope& above = foot_mm > 0.0 ? slope : slope_of(climb, segment);
  Gentler gentler(climb.ramp, segment.limits.ramp, profile);
  for (int round = 0; round < kRounds; ++round) {
    Ascent ascent = below(above, gentler.law(), profile);
    ascent.foot_mm += foot_mm;
    if (!(ascent.length_mm() <= climb.room_mm)) {
      return ascent;
    }
    const TurnAsk ask = ask_turning(placed(ascent, climb, segment), segment.turning, segment.axes);
    if (ask.holds()) {
      return ascent;
    }
    gentler.give_way(ask, ascent.law, round);
  }
  return {.law = profile.fastest(climb.ramp, segment.limits.ramp), .foot_mm = kUnbounded};
}

}  // namespace

Ascent climb_to(const Climb& climb, const VelocitySegment& segment, const Profile& profile) {
  const Slope& slope = slope_of(climb, segment);
  const double v = climb.ramp.v_begin_mm_s;
  if (segment.turning.empty() || v == climb.ramp.v_end_mm_s) {
    return below(slope, profile.fastest(climb.ramp, segment.limits.ramp), profile);
  }
  Ascent best = gentle_enough(climb, 0.0, segment, profile);
  if (climb.may_wait && v > 0.0 && !slope.empty()) {
    for (const double rise : kRises) {
      const double foot = slope.allowed_from_mm(rise * v);
      if (rise * v < climb.ramp.v_end_mm_s && foot > 0.0) {
        const Ascent other = gentle_enough(climb, foot, segment, profile);
        best = lost_in_s(other, climb) < lost_in_s(best, climb) ? other : best;
      }
    }
  }
  return best;
}

double climb_length_mm(const Climb& climb, const VelocitySegment& segment, const Profile& profile) {
  return slope_of(climb, segment).empty() && segment.turning.empty()
             ? profile.length_mm(climb.ramp, segment.limits.ramp)
             : climb_to(climb, segment, profile).length_mm();
}

}  // namespace kerf::lookahead
