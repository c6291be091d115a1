#include <algorithm>
#include <cmath>

#include "lookahead/classical/limit_curve_cuts.hpp"

namespace kerf::lookahead {

namespace {

double slope_mm_s(const FeedSample& a, const FeedSample& b) {
  return (b.v_mm_s - a.v_mm_s) / (b.u - a.u);
}

}  // namespace

std::vector<std::size_t> breaking_points(const VelocityLimitCurve& limit_curve,
                                         double screening_mm_s) {
  if (limit_curve.empty()) {
    return {};
  }
  if (limit_curve.size() == 1) {
    return {0};
  }
  std::vector<std::size_t> candidates{0};
  for (std::size_t i = 1; i + 1 < limit_curve.size(); ++i) {
    const double before = slope_mm_s(limit_curve[i - 1], limit_curve[i]);
    const double after = slope_mm_s(limit_curve[i], limit_curve[i + 1]);
    if (std::abs(after - before) > screening_mm_s) {
      candidates.push_back(i);
    }
  }
  candidates.push_back(limit_curve.size() - 1);

  std::vector<std::size_t> points{0};
  for (std::size_t k = 1; k + 1 < candidates.size(); ++k) {
    const double before = limit_curve[candidates[k]].v_mm_s - limit_curve[candidates[k - 1]].v_mm_s;
    const double after = limit_curve[candidates[k + 1]].v_mm_s - limit_curve[candidates[k]].v_mm_s;
    if (before * after <= 0.0) {
      points.push_back(candidates[k]);
    }
  }
  points.push_back(limit_curve.size() - 1);
  return points;
}

std::vector<std::size_t> valleys(const VelocityLimitCurve& limit_curve,
                                 const std::vector<std::size_t>& breaking, double noise) {
  std::vector<std::size_t> found;
  if (breaking.empty()) {
    return found;
  }
  std::size_t lowest = breaking.front();             // since the last hill
  double highest_mm_s = limit_curve[lowest].v_mm_s;  // since the last valley
  bool descending = false;                           // from a hill high enough
  for (const std::size_t i : breaking) {
    const double v = limit_curve[i].v_mm_s;
    if (descending) {
      lowest = v < limit_curve[lowest].v_mm_s ? i : lowest;
      if (v > limit_curve[lowest].v_mm_s * (1.0 + noise)) {
        found.push_back(lowest);
        descending = false;
        highest_mm_s = v;
      }
    } else {
      highest_mm_s = std::max(highest_mm_s, v);
      if (v < highest_mm_s * (1.0 - noise)) {
        descending = true;
        lowest = i;
      }
    }
  }
  return found;
}

}  // namespace kerf::lookahead
