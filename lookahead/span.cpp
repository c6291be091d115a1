#include "lookahead/span.hpp"

#include <algorithm>

#include "lookahead/ascent.hpp"
#include "lookahead/plateau.hpp"

namespace kerf::lookahead {

using profiles::Profile;
using profiles::Ramp;
using profiles::Transition;

namespace {

// What the backward pass found to fit, summed in another order, may miss by rounding.
constexpr double kAboveRounding = 1.0 + 1e-12;

// A climb from a known feedrate at one end of a span towards a cap at the other; a descent is a
// climb seen from the other end. Coasts lengthen with the feedrate at their end.
struct Climb {
  const Slope* slope = nullptr;
  double v_low_mm_s = 0.0;
  double cap_mm_s = 0.0;
  double near_coast_s = 0.0;
  double far_coast_s = 0.0;
};

double reach_mm_s(const Span& span, const Climb& climb, const Profile& profile) {
  if (climb.v_low_mm_s >= climb.cap_mm_s) {
    return climb.cap_mm_s;
  }
  const double length = span.length_mm - climb.near_coast_s * climb.v_low_mm_s;
  if (climb.slope->empty() && climb.far_coast_s == 0.0) {
    return profile.reach_mm_s(
        {.v_mm_s = climb.v_low_mm_s, .length_mm = length, .v_cap_mm_s = climb.cap_mm_s},
        span.limits.ramp);
  }
  const auto fits = [&](double v) {
    const Ramp ramp{.v_begin_mm_s = climb.v_low_mm_s, .v_end_mm_s = v};
    return climb_length_mm(*climb.slope, ramp, span, profile) + climb.far_coast_s * v <= length;
  };
  if (fits(climb.cap_mm_s)) {
    return climb.cap_mm_s;
  }
  double low = climb.v_low_mm_s;
  double high = climb.cap_mm_s;
  for (int i = 0; i < 40 && high - low > 1e-12 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

// Makes a cruise at an end of a span longer.
void lengthen(Transition& coast, double v_mm_s, double by_mm) {
  if (by_mm > 0.0) {
    coast = Transition::cruise(v_mm_s, coast.length_mm() + by_mm);
  }
}

Transition coast(double v_mm_s, double duration_s) {
  const double length = v_mm_s * duration_s;
  return length > 0.0 ? Transition::cruise(v_mm_s, length) : Transition{};
}

}  // namespace

double SpanPlan::duration_s() const noexcept {
  return begin_coast.duration_s() + acceleration.duration_s() + cruise.duration_s() +
         deceleration.duration_s() + end_coast.duration_s();
}

double reach_backward_mm_s(const Span& span, const BackwardQuery& query, const Profile& profile) {
  Climb climb{.slope = &span.fall,
              .v_low_mm_s = query.v_end_mm_s,
              .cap_mm_s = query.cap_mm_s,
              .near_coast_s = span.end.coast_s,
              .far_coast_s = span.begin_coast_s};
  const double reached = reach_mm_s(span, climb, profile);
  if (span.end.coast_s == 0.0 || reached >= query.cap_mm_s) {
    return reached;
  }
  climb.v_low_mm_s = 0.0;
  return std::max(reached, reach_mm_s(span, climb, profile));
}

double end_feedrate_mm_s(const Span& span, const SpanEnds& wanted, double v_end_known_mm_s,
                         const Profile& profile) {
  if (wanted.v_end_mm_s > wanted.v_begin_mm_s) {
    return reach_mm_s(span,
                      {.slope = &span.rise,
                       .v_low_mm_s = wanted.v_begin_mm_s,
                       .cap_mm_s = wanted.v_end_mm_s,
                       .near_coast_s = span.begin_coast_s,
                       .far_coast_s = span.end.coast_s},
                      profile);
  }
  const auto fits = [&](double v_end) {
    const Ramp fall{.v_begin_mm_s = v_end, .v_end_mm_s = wanted.v_begin_mm_s};
    return climb_length_mm(span.fall, fall, span, profile) +
               span.begin_coast_s * wanted.v_begin_mm_s + span.end.coast_s * v_end <=
           span.length_mm * kAboveRounding;
  };
  if (fits(wanted.v_end_mm_s)) {
    return wanted.v_end_mm_s;
  }
  const double known = std::min(v_end_known_mm_s, wanted.v_end_mm_s);
  double low = fits(known) ? known : 0.0;
  double high = wanted.v_end_mm_s;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

double brake(Span& span, const SpanEnds& ends, const Profile& profile) {
  const double coast_mm = ends.v_begin_mm_s * span.begin_coast_s;
  const double stop_mm = coast_mm + profile.length_mm({ends.v_begin_mm_s, 0.0}, span.limits.ramp);
  if (stop_mm <= span.length_mm) {
    // The fall ends before the ceiling does, so it is below it wherever the plan to the end was.
    span.ends_block = span.ends_block && stop_mm == span.length_mm;
    span.length_mm = stop_mm;
    span.end = {.feedrate_mm_s = 0.0};
    span.fall = {};
    span.rise = {};
    span.limits.feedrate_mm_s = ends.v_begin_mm_s;
    return 0.0;
  }
  double low = 0.0;
  double high = ends.v_end_mm_s;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    const double reached =
        reach_backward_mm_s(span, {.v_end_mm_s = middle, .cap_mm_s = ends.v_begin_mm_s}, profile);
    (reached >= ends.v_begin_mm_s ? high : low) = middle;
  }
  return high;
}

SpanPlan plan_span(const Span& span, const SpanEnds& ends, const Profile& profile) {
  SpanPlan plan;
  plan.begin_coast = coast(ends.v_begin_mm_s, span.begin_coast_s);
  plan.end_coast = coast(ends.v_end_mm_s, span.end.coast_s);
  const double length = span.length_mm - plan.begin_coast.length_mm() - plan.end_coast.length_mm();
  double plateau = 0.0;
  if (span.rise.empty()) {
    plateau = profile.peak_mm_s({ends.v_begin_mm_s, ends.v_end_mm_s},
                                {.length_mm = length, .v_cap_mm_s = span.limits.feedrate_mm_s},
                                span.limits.ramp);
    plan.acceleration = profile.fastest({ends.v_begin_mm_s, plateau}, span.limits.ramp);
    plan.deceleration = profile.fastest({plateau, ends.v_end_mm_s}, span.limits.ramp);
  } else {
    const PlateauSearch search(span, ends, length, profile);
    plateau = search.best_mm_s();
    const Hill hill = search.hill(plateau);
    plan.acceleration = hill.up.law;
    plan.deceleration = hill.down_mirrored.law.reversed();
    lengthen(plan.begin_coast, ends.v_begin_mm_s, hill.up.foot_mm);
    lengthen(plan.end_coast, ends.v_end_mm_s, hill.down_mirrored.foot_mm);
  }
  const double spare = span.length_mm - plan.begin_coast.length_mm() -
                       plan.acceleration.length_mm() - plan.deceleration.length_mm() -
                       plan.end_coast.length_mm();
  if (spare > 0.0) {
    plan.cruise = Transition::cruise(plateau, spare);
  }
  return plan;
}

}  // namespace kerf::lookahead
