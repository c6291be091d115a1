#include "lookahead/classical/lower_limit_curve.hpp"

#include <algorithm>
#include <cstddef>

namespace kerf::lookahead {

namespace {

// A line through values over s.
double between(double s0, double v0, double s1, double v1, double s) {
  return s1 > s0 ? v0 + (v1 - v0) * (s - s0) / (s1 - s0) : std::min(v0, v1);
}

}  // namespace

VelocityLimitCurve lower_limit_curve(const VelocityLimitCurve& limit_curve,
                                     const AxisLimitCurve& axis_limits) {
  VelocityLimitCurve lower;
  const double cap =
      std::max_element(limit_curve.begin(), limit_curve.end(),
                       [](const FeedSample& a, const FeedSample& b) { return a.v_mm_s < b.v_mm_s; })
          ->v_mm_s;
  const auto turn = [&](std::size_t i) { return std::min(cap, axis_limits[i].feedrate_mm_s); };
  std::size_t c = 0;
  std::size_t t = 0;
  while (c < limit_curve.size() || t < axis_limits.size()) {
    FeedSample sample;
    if (t == axis_limits.size() ||
        (c < limit_curve.size() && limit_curve[c].s_mm <= axis_limits[t].s_mm)) {
      sample = limit_curve[c++];
      if (t > 0 && t < axis_limits.size()) {
        sample.v_mm_s = std::min(sample.v_mm_s, between(axis_limits[t - 1].s_mm, turn(t - 1),
                                                        axis_limits[t].s_mm, turn(t), sample.s_mm));
      }
    } else {
      const std::size_t after = std::min(c, limit_curve.size() - 1);
      const std::size_t before = after > 0 ? after - 1 : 0;
      const double s = axis_limits[t].s_mm;
      sample = {.u = between(limit_curve[before].s_mm, limit_curve[before].u,
                             limit_curve[after].s_mm, limit_curve[after].u, s),
                .s_mm = s,
                .v_mm_s = std::min(turn(t),
                                   between(limit_curve[before].s_mm, limit_curve[before].v_mm_s,
                                           limit_curve[after].s_mm, limit_curve[after].v_mm_s, s))};
      ++t;
    }
    if (!lower.empty() && (sample.s_mm <= lower.back().s_mm || sample.u <= lower.back().u)) {
      lower.back().v_mm_s = std::min(lower.back().v_mm_s, sample.v_mm_s);
    } else {
      lower.push_back(sample);
    }
  }
  return lower;
}

}  // namespace kerf::lookahead
