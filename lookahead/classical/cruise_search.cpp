#include <algorithm>

#include "lookahead/classical/acceleration_ramp.hpp"

namespace kerf::lookahead {

namespace {

// What fits may miss by rounding.
constexpr double kWithRounding = 1.0 + 1e-9;
// Fewer where curvature binds: each ramp is a search of its own there.
constexpr int kCurvatureHalvings = 12;
// Where only a tiny share of the cap fits, on and on until as close as this.
constexpr double kClose = 1e-3;
constexpr int kMaxHalvings = 200;
constexpr int kCurvatureSteps = 8;
constexpr double kGolden = 0.6180339887498949;

}  // namespace

double CruiseSearch::best_mm_s() const {
  double low = std::max(ends_.v_begin_mm_s, ends_.v_end_mm_s);
  double high = std::max(low, std::min({segment_.limits.feedrate_mm_s, segment_.rise.top_mm_s(),
                                        segment_.fall.top_mm_s()}));
  if (spare_mm(sides(high)) < 0.0) {
    double fits = low;
    const int halvings = segment_.axis_limits.empty() ? 40 : kCurvatureHalvings;
    for (int i = 0; i < halvings || (high - fits > kClose * high && i < kMaxHalvings); ++i) {
      const double middle = 0.5 * (fits + high);
      (spare_mm(sides(middle)) >= 0.0 ? fits : high) = middle;
    }
    high = fits;
  }
  return fastest_in({.low_mm_s = low, .high_mm_s = high});
}

CruiseSides CruiseSearch::sides(double cruise_mm_s) const {
  const auto ramp_on = [&](SegmentSide side, double v_foot_mm_s) {
    return acceleration_ramp({.side = side,
                              .ramp = {v_foot_mm_s, cruise_mm_s},
                              .room_mm = kWithRounding * length_mm_,
                              .may_wait = true},
                             segment_, profile_);
  };
  return {.up = ramp_on(SegmentSide::rise, ends_.v_begin_mm_s),
          .down_mirrored = ramp_on(SegmentSide::fall, ends_.v_end_mm_s)};
}

double CruiseSearch::spare_mm(const CruiseSides& sides) const {
  return length_mm_ - sides.up.length_mm() - sides.down_mirrored.length_mm();
}

double CruiseSearch::time_s(double cruise_mm_s) const {
  const CruiseSides both = sides(cruise_mm_s);
  if (!segment_.axis_limits.empty() && spare_mm(both) < 0.0) {
    return kUnbounded;
  }
  return both.up.duration_s() + both.down_mirrored.duration_s() + spare_mm(both) / cruise_mm_s;
}

double CruiseSearch::fastest_in(const Bracket& cruise) const {
  double a = cruise.low_mm_s;
  double b = cruise.high_mm_s;
  double x1 = b - kGolden * (b - a);
  double x2 = a + kGolden * (b - a);
  double t1 = time_s(x1);
  double t2 = time_s(x2);
  for (int i = 0; i < (segment_.axis_limits.empty() ? 24 : kCurvatureSteps); ++i) {
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
  return time_s(cruise.high_mm_s) <= std::min(t1, t2) ? cruise.high_mm_s : inner;
}

}  // namespace kerf::lookahead
