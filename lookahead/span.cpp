#include "lookahead/span.hpp"

#include <algorithm>

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

// A transition from a span's end upwards, and how far it cruises at that end first.
struct Ascent {
  Transition law{};
  double foot_mm = 0.0;

  [[nodiscard]] double length_mm() const { return foot_mm + law.length_mm(); }
  [[nodiscard]] double duration_s() const {
    const double v = law.ramp().v_begin_mm_s;
    return law.duration_s() + (foot_mm > 0.0 ? foot_mm / v : 0.0);
  }
};

Ascent climb_to(const Slope& slope, const Ramp& ramp, const Span& span, const Profile& profile) {
  const Transition fastest = profile.fastest(ramp, span.limits.ramp);
  if (slope.empty()) {
    return {.law = fastest};
  }
  if (profile.kind() == profiles::ProfileKind::trapezoid && ramp.v_begin_mm_s > 0.0) {
    return {.law = fastest, .foot_mm = slope.delay_for_mm(fastest)};
  }
  return {.law = fastest.stretched(slope.stretch_for(fastest))};
}

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
    return climb_to(*climb.slope, ramp, span, profile).length_mm() + climb.far_coast_s * v <=
           length;
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

struct Hill {
  Ascent up{};
  Ascent down_mirrored{};  // climbs from the end's feedrate
};

// Under a ceiling a higher plateau asks for gentler slopes, so the highest is not the fastest:
// bisect for the highest that fits, then search the least time below it. Weakness: takes time over
// the plateau to fall and then to rise, with one valley between.
class PlateauSearch {
 public:
  PlateauSearch(const Span& span, const SpanEnds& ends, double length_mm, const Profile& profile)
      : span_(span), ends_(ends), length_mm_(length_mm), profile_(profile) {}

  [[nodiscard]] double best_mm_s() const {
    double low = std::max(ends_.v_begin_mm_s, ends_.v_end_mm_s);
    double high = std::max(
        low, std::min({span_.limits.feedrate_mm_s, span_.rise.top_mm_s(), span_.fall.top_mm_s()}));
    if (spare_mm(hill(high)) < 0.0) {
      double fits = low;
      for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (fits + high);
        (spare_mm(hill(middle)) >= 0.0 ? fits : high) = middle;
      }
      high = fits;
    }
    return fastest_between(low, high);
  }

  [[nodiscard]] Hill hill(double plateau_mm_s) const {
    return {
        .up = climb_to(span_.rise, {ends_.v_begin_mm_s, plateau_mm_s}, span_, profile_),
        .down_mirrored = climb_to(span_.fall, {ends_.v_end_mm_s, plateau_mm_s}, span_, profile_)};
  }

 private:
  static constexpr double kGolden = 0.6180339887498949;

  [[nodiscard]] double spare_mm(const Hill& hill) const {
    return length_mm_ - hill.up.length_mm() - hill.down_mirrored.length_mm();
  }

  [[nodiscard]] double time_s(double plateau_mm_s) const {
    const Hill h = hill(plateau_mm_s);
    return h.up.duration_s() + h.down_mirrored.duration_s() + spare_mm(h) / plateau_mm_s;
  }

  [[nodiscard]] double fastest_between(double low, double high) const {
    double a = low;
    double b = high;
    double x1 = b - kGolden * (b - a);
    double x2 = a + kGolden * (b - a);
    double t1 = time_s(x1);
    double t2 = time_s(x2);
    for (int i = 0; i < 24; ++i) {
      if (t1 < t2) {
        b = x2;
        x2 = x1;
        t2 = t1;
        x1 = b - kGolden * (b - a);
        t1 = time_s(x1);
      } else {
        a = x1;
        x1 = x2;
        t1 = t2;
        x2 = a + kGolden * (b - a);
        t2 = time_s(x2);
      }
    }
    const double inner = t1 < t2 ? x1 : x2;
    return time_s(high) <= std::min(t1, t2) ? high : inner;
  }

  const Span& span_;
  const SpanEnds& ends_;
  double length_mm_;
  const Profile& profile_;
};

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
    return climb_to(span.fall, fall, span, profile).length_mm() +
               span.begin_coast_s * wanted.v_begin_mm_s + span.end.coast_s * v_end <=
           span.length_mm * kAboveRounding;
  };
  if (span.end.coast_s == 0.0 || fits(wanted.v_end_mm_s)) {
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
