#include "lookahead/classical/velocity_segment.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "lookahead/classical/acceleration_ramp.hpp"

namespace kerf::lookahead {

using profiles::Profile;
using profiles::Ramp;
using profiles::Transition;

namespace {

// What the backward pass found to fit, summed in another order, may miss by rounding.
constexpr double kAboveRounding = 1.0 + 1e-12;
// How close to the highest feedrate a reach comes where curvature binds.
constexpr double kCloseInTurn = 1e-3;
// Of an end's feedrate: those that are tried where a part at constant velocity binds.
constexpr std::array kSlowerEnds{0.75, 0.5, 0.25, 0.0};

// A ramp from a known feedrate at one end of a segment towards a cap at the other; a deceleration
// is a ramp seen from the other end. Parts at constant velocity lengthen with the feedrate at their
// end.
struct Reach {
  SegmentSide side = SegmentSide::rise;
  double v_low_mm_s = 0.0;
  double cap_mm_s = 0.0;
  double near_constant_velocity_s = 0.0;
  double far_constant_velocity_s = 0.0;
};

double reach_mm_s(const VelocitySegment& segment, const Reach& reach, const Profile& profile) {
  if (reach.v_low_mm_s >= reach.cap_mm_s) {
    return reach.cap_mm_s;
  }
  const Slope& slope = reach.side == SegmentSide::rise ? segment.rise : segment.fall;
  const double length = segment.length_mm - reach.near_constant_velocity_s * reach.v_low_mm_s;
  if (slope.empty() && segment.axis_limits.empty() && reach.far_constant_velocity_s == 0.0) {
    return profile.reach_mm_s(
        {.v_mm_s = reach.v_low_mm_s, .length_mm = length, .v_cap_mm_s = reach.cap_mm_s},
        segment.limits.ramp);
  }
  const auto fits = [&](double v) {
    const RampRequest request{.side = reach.side,
                              .ramp = {.v_begin_mm_s = reach.v_low_mm_s, .v_end_mm_s = v},
                              .room_mm = length};
    return ramp_length_mm(request, segment, profile) + reach.far_constant_velocity_s * v <= length;
  };
  if (fits(reach.cap_mm_s)) {
    return reach.cap_mm_s;
  }
  double low = reach.v_low_mm_s;
  double high = reach.cap_mm_s;
  const double close = segment.axis_limits.empty() ? 1e-12 : kCloseInTurn;
  for (int i = 0; i < 40 && high - low > close * high; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

Reach backward(const VelocitySegment& segment, const BackwardQuery& query) {
  return {.side = SegmentSide::fall,
          .v_low_mm_s = query.v_end_mm_s,
          .cap_mm_s = query.cap_mm_s,
          .near_constant_velocity_s = segment.end.constant_velocity_s,
          .far_constant_velocity_s = segment.begin_constant_velocity_s};
}

// Makes a cruise at an end of a segment longer.
void lengthen(Transition& constant_velocity, double v_mm_s, double by_mm) {
  if (by_mm > 0.0) {
    constant_velocity = Transition::cruise(v_mm_s, constant_velocity.length_mm() + by_mm);
  }
}

Transition constant_velocity(double v_mm_s, double duration_s) {
  const double length = v_mm_s * duration_s;
  return length > 0.0 ? Transition::cruise(v_mm_s, length) : Transition{};
}

}  // namespace

std::string_view kind_of(const SegmentPlan& plan) noexcept {
  constexpr double kRounding_s = 1e-9;
  const bool up = plan.acceleration.duration_s() > kRounding_s;
  const bool level = plan.cruise.duration_s() > kRounding_s;
  const bool down = plan.deceleration.duration_s() > kRounding_s;
  if (up && down) {
    return level ? "ACC + CF + DEC" : "ACC + DEC";
  }
  if (up) {
    return level ? "ACC + CF" : "ACC";
  }
  if (down) {
    return level ? "CF + DEC" : "DEC";
  }
  return "CF";
}

double SegmentPlan::duration_s() const noexcept {
  return begin_constant_velocity.duration_s() + acceleration.duration_s() + cruise.duration_s() +
         deceleration.duration_s() + end_constant_velocity.duration_s();
}

double reach_backward_mm_s(const VelocitySegment& segment, const BackwardQuery& query,
                           const Profile& profile) {
  Reach reach = backward(segment, query);
  const double reached = reach_mm_s(segment, reach, profile);
  if (segment.end.constant_velocity_s == 0.0 || reached >= query.cap_mm_s) {
    return reached;
  }
  reach.v_low_mm_s = 0.0;
  return std::max(reached, reach_mm_s(segment, reach, profile));
}

SegmentEnds ends_backward(const VelocitySegment& segment, const BackwardQuery& query,
                          const Profile& profile) {
  Reach reach = backward(segment, query);
  SegmentEnds best{.v_begin_mm_s = reach_mm_s(segment, reach, profile),
                   .v_end_mm_s = query.v_end_mm_s};
  if (segment.end.constant_velocity_s == 0.0 || best.v_begin_mm_s >= query.cap_mm_s) {
    return best;
  }
  for (const double share : kSlowerEnds) {
    reach.v_low_mm_s = share * query.v_end_mm_s;
    const double v_begin = reach_mm_s(segment, reach, profile);
    if (v_begin + reach.v_low_mm_s > best.v_begin_mm_s + best.v_end_mm_s) {
      best = {.v_begin_mm_s = v_begin, .v_end_mm_s = reach.v_low_mm_s};
    }
  }
  return best;
}

double end_feedrate_mm_s(const VelocitySegment& segment, const SegmentEnds& wanted,
                         double v_end_known_mm_s, const Profile& profile) {
  if (wanted.v_end_mm_s > wanted.v_begin_mm_s) {
    return reach_mm_s(segment,
                      {.side = SegmentSide::rise,
                       .v_low_mm_s = wanted.v_begin_mm_s,
                       .cap_mm_s = wanted.v_end_mm_s,
                       .near_constant_velocity_s = segment.begin_constant_velocity_s,
                       .far_constant_velocity_s = segment.end.constant_velocity_s},
                      profile);
  }
  const auto fits = [&](double v_end) {
    return joins(segment, {.v_begin_mm_s = wanted.v_begin_mm_s, .v_end_mm_s = v_end}, profile);
  };
  if (fits(wanted.v_end_mm_s)) {
    return wanted.v_end_mm_s;
  }
  const double known = std::min(v_end_known_mm_s, wanted.v_begin_mm_s);
  double inside = fits(known) ? known : 0.0;
  double outside = wanted.v_end_mm_s;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (inside + outside);
    (fits(middle) ? inside : outside) = middle;
  }
  return inside;
}

bool joins(const VelocitySegment& segment, const SegmentEnds& ends, const Profile& profile) {
  const bool rises = ends.v_end_mm_s > ends.v_begin_mm_s;
  const Ramp rise{.v_begin_mm_s = ends.v_begin_mm_s, .v_end_mm_s = ends.v_end_mm_s};
  const Ramp fall{.v_begin_mm_s = ends.v_end_mm_s, .v_end_mm_s = ends.v_begin_mm_s};
  const double room = segment.length_mm * kAboveRounding -
                      segment.begin_constant_velocity_s * ends.v_begin_mm_s -
                      segment.end.constant_velocity_s * ends.v_end_mm_s;
  const RampRequest request{.side = rises ? SegmentSide::rise : SegmentSide::fall,
                            .ramp = rises ? rise : fall,
                            .room_mm = room};
  return ramp_length_mm(request, segment, profile) <= room;
}

SegmentPlan plan_segment(const VelocitySegment& segment, const SegmentEnds& ends,
                         const Profile& profile) {
  assert(joins(segment, ends, profile));
  SegmentPlan plan;
  plan.begin_constant_velocity =
      constant_velocity(ends.v_begin_mm_s, segment.begin_constant_velocity_s);
  plan.end_constant_velocity = constant_velocity(ends.v_end_mm_s, segment.end.constant_velocity_s);
  const double length = segment.length_mm - plan.begin_constant_velocity.length_mm() -
                        plan.end_constant_velocity.length_mm();
  double cruise = 0.0;
  if (segment.rise.empty() && segment.axis_limits.empty()) {
    cruise = profile.peak_mm_s({ends.v_begin_mm_s, ends.v_end_mm_s},
                               {.length_mm = length, .v_cap_mm_s = segment.limits.feedrate_mm_s},
                               segment.limits.ramp);
    plan.acceleration = profile.fastest({ends.v_begin_mm_s, cruise}, segment.limits.ramp);
    plan.deceleration = profile.fastest({cruise, ends.v_end_mm_s}, segment.limits.ramp);
  } else {
    const Cruise best = CruiseSearch(segment, ends, length, profile).best();
    cruise = best.v_mm_s;
    plan.acceleration = best.up.law;
    plan.deceleration = best.down_mirrored.law.reversed();
    lengthen(plan.begin_constant_velocity, ends.v_begin_mm_s, best.up.delay_mm);
    lengthen(plan.end_constant_velocity, ends.v_end_mm_s, best.down_mirrored.delay_mm);
  }
  const double spare = segment.length_mm - plan.begin_constant_velocity.length_mm() -
                       plan.acceleration.length_mm() - plan.deceleration.length_mm() -
                       plan.end_constant_velocity.length_mm();
  if (spare > 0.0) {
    plan.cruise = Transition::cruise(cruise, spare);
  }
  return plan;
}

SegmentPlan slowed_plan(const VelocitySegment& segment, const SegmentEnds& ends,
                        double v_begin_mm_s, const Profile& profile) {
  assert(0.0 < v_begin_mm_s && v_begin_mm_s <= ends.v_begin_mm_s);
  SegmentPlan plan = plan_segment(segment, ends, profile);
  const double factor = ends.v_begin_mm_s / v_begin_mm_s;
  for (Transition* law : {&plan.begin_constant_velocity, &plan.acceleration, &plan.cruise,
                          &plan.deceleration, &plan.end_constant_velocity}) {
    *law = law->slowed(factor);
  }
  return plan;
}

}  // namespace kerf::lookahead
