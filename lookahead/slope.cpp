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

template <typename Visit>
void Slope::walk(const profiles::Transition& climb, int points, const Visit& visit) const {
  if (samples_.empty() || climb.length_mm() <= 0.0) {
    return;
  }
  std::size_t i = 0;  // the first sample that allows the point's feedrate
  for (int k = 1; k <= points; ++k) {
    const profiles::PathMotion point = climb.at(climb.duration_s() * k / points);
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
    visit(point, low.distance_mm + share * (high.distance_mm - low.distance_mm));
  }
}

double Slope::stretch_for(const profiles::Transition& climb) const {
  double stretch = 1.0;
  walk(climb, kClimbPoints, [&stretch](const profiles::PathMotion& point, double allowed_from_mm) {
    stretch = std::max(stretch, allowed_from_mm / point.s_mm);
  });
  return stretch;
}

double Slope::delay_for_mm(const profiles::Transition& climb) const {
  double delay_mm = 0.0;
  walk(climb, kStartPoints, [&delay_mm](const profiles::PathMotion& point, double allowed_from_mm) {
    delay_mm = std::max(delay_mm, allowed_from_mm - point.s_mm);
  });
  return delay_mm;
}

}  // namespace kerf::lookahead
