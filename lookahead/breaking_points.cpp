#include "lookahead/breaking_points.hpp"

#include <cmath>

namespace kerf::lookahead {

namespace {

double slope_mm_s(const FeedSample& a, const FeedSample& b) {
  return (b.v_mm_s - a.v_mm_s) / (b.u - a.u);
}

}  // namespace

std::vector<std::size_t> breaking_points(const Ceiling& ceiling, double screening_mm_s) {
  if (ceiling.size() < 3) {
    return {};
  }
  std::vector<std::size_t> candidates{0};
  for (std::size_t i = 1; i + 1 < ceiling.size(); ++i) {
    const double before = slope_mm_s(ceiling[i - 1], ceiling[i]);
    const double after = slope_mm_s(ceiling[i], ceiling[i + 1]);
    if (std::abs(after - before) > screening_mm_s) {
      candidates.push_back(i);
    }
  }
  candidates.push_back(ceiling.size() - 1);

  std::vector<std::size_t> points{0};
  for (std::size_t k = 1; k + 1 < candidates.size(); ++k) {
    const double before = ceiling[candidates[k]].v_mm_s - ceiling[candidates[k - 1]].v_mm_s;
    const double after = ceiling[candidates[k + 1]].v_mm_s - ceiling[candidates[k]].v_mm_s;
    if (before * after <= 0.0) {
      points.push_back(candidates[k]);
    }
  }
  points.push_back(ceiling.size() - 1);
  return points;
}

std::vector<std::size_t> valleys(const Ceiling& ceiling, const std::vector<std::size_t>& breaking) {
  std::vector<std::size_t> found;
  for (std::size_t k = 1; k + 1 < breaking.size(); ++k) {
    const double here = ceiling[breaking[k]].v_mm_s;
    if (here < ceiling[breaking[k - 1]].v_mm_s && here < ceiling[breaking[k + 1]].v_mm_s) {
      found.push_back(breaking[k]);
    }
  }
  return found;
}

}  // namespace kerf::lookahead
