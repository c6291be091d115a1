#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/classical/limit_curve_cuts.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kWorthACut = 2.0;    // times the time
constexpr double kGain_s = 0.002;     // a cut costs some instants without acceleration
constexpr double kSideGrowth = 1.25;  // from one side of the hull to the next that is kept

// A corner of the hull.
struct HullCorner {
  std::size_t sample = 0;
  double s_mm = 0.0;
  double squared = 0.0;  // of the feedrate
};

double slope_of(const HullCorner& a, const HullCorner& b) {
  return (b.squared - a.squared) / (b.s_mm - a.s_mm);
}

// No ramp from the foot at that jerk gets as far as there.
bool is_out_of_reach(const Slope::Sample& sample, double v_foot_mm_s, double jerk_mm_s3) {
  const double way = sample.distance_mm;
  const double t = std::min(way / v_foot_mm_s, std::cbrt(6.0 * way / jerk_mm_s3));
  return way > 0.0 && sample.v_mm_s > v_foot_mm_s + 0.5 * jerk_mm_s3 * t * t;
}

// Never below 0: no feedrate further up lies below one before it.
std::vector<HullCorner> lower_hull(const std::vector<Slope::Sample>& samples, double jerk_mm_s3) {
  std::vector<HullCorner> corners;
  double lowest = kUnbounded;
  for (std::size_t i = samples.size(); i-- > 0;) {
    lowest = std::min(lowest, samples[i].v_mm_s);
    if (i + 1 < samples.size() &&
        is_out_of_reach({samples[i].distance_mm, lowest}, samples.front().v_mm_s, jerk_mm_s3)) {
      continue;
    }
    const HullCorner corner{
        .sample = i, .s_mm = samples[i].distance_mm, .squared = lowest * lowest};
    while (corners.size() > 1 &&
           slope_of(corner, corners[corners.size() - 2]) <= slope_of(corner, corners.back())) {
      corners.pop_back();
    }
    corners.push_back(corner);
  }
  std::reverse(corners.begin(), corners.end());
  return corners;
}

std::vector<HullCorner> thinned(const std::vector<HullCorner>& hull) {
  std::vector<HullCorner> kept{hull.front()};
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) {
    if (slope_of(hull[i], hull[i + 1]) > kSideGrowth * slope_of(kept.back(), hull[i])) {
      kept.push_back(hull[i]);
    }
  }
  kept.push_back(hull.back());
  return kept;
}

// From the corner on where it is too steep for the machine: a line as steep as that.
std::vector<HullCorner> capped(std::vector<HullCorner> hull, double most) {
  for (std::size_t i = 0; i + 1 < hull.size(); ++i) {
    if (slope_of(hull[i], hull[i + 1]) > most) {
      HullCorner end = hull.back();
      end.squared = hull[i].squared + most * (end.s_mm - hull[i].s_mm);
      hull.resize(i + 1);
      hull.push_back(end);
    }
  }
  return hull;
}

struct SquaredFeeds {
  double begin = 0.0;
  double end = 0.0;
};

// At the acceleration that joins the squared feedrates.
double ramp_s(double way_mm, const SquaredFeeds& squared) {
  const double sum = std::sqrt(squared.begin) + std::sqrt(squared.end);
  return sum > 0.0 ? 2.0 * way_mm / sum : kUnbounded;
}

class Cuts {
 public:
  explicit Cuts(std::vector<HullCorner> corners) : corners_(std::move(corners)) {}

  std::vector<std::size_t> find() {
    look({.begin = 0, .end = corners_.size() - 1});
    std::sort(samples_.begin(), samples_.end());
    return samples_;
  }

 private:
  // Of corners, both included.
  struct Part {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  // With a wait at the foot's feedrate, to any of the corners, where that is faster.
  [[nodiscard]] double one_ramp_s(const Part& part) const {
    HullCorner foot = corners_[part.begin];
    const double way = corners_[part.end].s_mm - foot.s_mm;
    double best = kUnbounded;
    std::size_t touched = part.begin + 1;  // the corner that the steepest line from the foot meets
    for (std::size_t k = part.begin; k < part.end; ++k) {
      foot.s_mm = corners_[k].s_mm;
      touched = std::max(touched, k + 1);
      while (touched < part.end &&
             slope_of(foot, corners_[touched + 1]) <= slope_of(foot, corners_[touched])) {
        ++touched;
      }
      const double left = corners_[part.end].s_mm - foot.s_mm;
      const double end = foot.squared + left * slope_of(foot, corners_[touched]);
      const double wait = k > part.begin ? (way - left) / std::sqrt(foot.squared) : 0.0;
      best = std::min(best, wait + ramp_s(left, {foot.squared, end}));
    }
    return best;
  }

  [[nodiscard]] double fastest_s(const Part& part) const {
    double sum = 0.0;
    for (std::size_t k = part.begin; k < part.end; ++k) {
      sum += ramp_s(corners_[k + 1].s_mm - corners_[k].s_mm,
                    {corners_[k].squared, corners_[k + 1].squared});
    }
    return sum;
  }

  // NOLINTNEXTLINE(misc-no-recursion): each call cuts off a corner.
  void look(const Part& part) {
    if (part.end < part.begin + 2) {
      return;
    }
    const double fastest = fastest_s(part);
    if (!(one_ramp_s(part) > std::max(kWorthACut * fastest, fastest + kGain_s))) {
      return;
    }
    std::size_t best = part.begin + 1;
    double least = kUnbounded;
    for (std::size_t k = part.begin + 1; k < part.end; ++k) {
      const double both =
          one_ramp_s({.begin = part.begin, .end = k}) + one_ramp_s({.begin = k, .end = part.end});
      if (both < least) {
        least = both;
        best = k;
      }
    }
    samples_.push_back(corners_[best].sample);
    look({.begin = part.begin, .end = best});
    look({.begin = best, .end = part.end});
  }

  std::vector<HullCorner> corners_;
  std::vector<std::size_t> samples_;
};

}  // namespace

std::vector<std::size_t> ramp_cuts(const std::vector<Slope::Sample>& samples,
                                   const profiles::RampLimits& limits) {
  assert(samples.empty() || samples.front().distance_mm == 0.0);
  if (samples.size() < 3) {
    return {};
  }
  const std::vector<HullCorner> hull =
      capped(lower_hull(samples, limits.jerk_mm_s3), 2.0 * limits.acceleration_mm_s2);
  return hull.size() < 3 ? std::vector<std::size_t>{} : Cuts(thinned(hull)).find();
}

}  // namespace kerf::lookahead
