#include "lookahead/slope.hpp"

#include <algorithm>
#include <utility>

namespace kerf::lookahead {

Slope::Slope(std::vector<Sample> samples) : samples_(std::move(samples)) {
  double lowest = kHighest;
  for (auto sample = samples_.rbegin(); sample != samples_.rend(); ++sample) {
    lowest = std::min(lowest, sample->v_mm_s);
    sample->v_mm_s = lowest;
  }
}

double Slope::top_mm_s() const noexcept {
  return samples_.empty() ? kHighest : samples_.back().v_mm_s;
}

double Slope::stretch_for(const profiles::Transition& climb) const {
  const double length = climb.length_mm();
  if (samples_.empty() || length <= 0.0) {
    return 1.0;
  }
  double stretch = 1.0;
  std::size_t i = 0;  // the first sample that allows the point's feedrate
  for (int k = 1; k <= kClimbPoints; ++k) {
    const double t = climb.duration_s() * k / kClimbPoints;
    const profiles::PathMotion point = climb.at(t);
    while (i + 1 < samples_.size() && samples_[i].v_mm_s < point.v_mm_s) {
      ++i;
    }
    if (i == 0) {
      continue;
    }
    const Sample& low = samples_[i - 1];
    const Sample& high = samples_[i];
    const double rise = high.v_mm_s - low.v_mm_s;
    const double share = rise > 0.0 ? std::min((point.v_mm_s - low.v_mm_s) / rise, 1.0) : 1.0;
    const double needed = low.distance_mm + share * (high.distance_mm - low.distance_mm);
    stretch = std::max(stretch, needed / point.s_mm);
  }
  return stretch;
}

}  // namespace kerf::lookahead
