#include "lookahead/classical/turn_ceiling.hpp"

#include <algorithm>
#include <cstddef>

namespace kerf::lookahead {

namespace {

// A line through values over s.
double between(double s0, double v0, double s1, double v1, double s) {
  return s1 > s0 ? v0 + (v1 - v0) * (s - s0) / (s1 - s0) : std::min(v0, v1);
}

}  // namespace

Ceiling lower_ceiling(const Ceiling& ceiling, const Turning& turning) {
  Ceiling lower;
  const double cap =
      std::max_element(ceiling.begin(), ceiling.end(),
                       [](const FeedSample& a, const FeedSample& b) { return a.v_mm_s < b.v_mm_s; })
          ->v_mm_s;
  const auto turn = [&](std::size_t i) { return std::min(cap, turning[i].feedrate_mm_s); };
  std::size_t c = 0;
  std::size_t t = 0;
  while (c < ceiling.size() || t < turning.size()) {
    FeedSample sample;
    if (t == turning.size() || (c < ceiling.size() && ceiling[c].s_mm <= turning[t].s_mm)) {
      sample = ceiling[c++];
      if (t > 0 && t < turning.size()) {
        sample.v_mm_s = std::min(sample.v_mm_s, between(turning[t - 1].s_mm, turn(t - 1),
                                                        turning[t].s_mm, turn(t), sample.s_mm));
      }
    } else {
      const std::size_t after = std::min(c, ceiling.size() - 1);
      const std::size_t before = after > 0 ? after - 1 : 0;
      const double s = turning[t].s_mm;
      sample = {
          .u = between(ceiling[before].s_mm, ceiling[before].u, ceiling[after].s_mm,
                       ceiling[after].u, s),
          .s_mm = s,
          .v_mm_s = std::min(turn(t), between(ceiling[before].s_mm, ceiling[before].v_mm_s,
                                              ceiling[after].s_mm, ceiling[after].v_mm_s, s))};
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
