#include "bench/part_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::bench {

namespace {

// How many elements before and after its own line a tick is sought on.
constexpr std::size_t kAround = 3;
// How far around a place along the path the ticks near it are sought.
constexpr double kNear_mm = 0.6;
// Of two places as near, as the ends of a loop are, the one is meant that comes next.
constexpr double kDetour = 1e-7;
constexpr double kLineSample_mm = 0.25;
constexpr double kArcSample_mm = 0.05;
constexpr int kMaxSamples = 2000;
constexpr int kCubicParts = 16;

Point cubic_through(const Point* four, double share) {  // Catmull-Rom, between the inner two
  Point point;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = four[0][k];
    const double b = four[1][k];
    const double c = four[2][k];
    const double d = four[3][k];
    point[k] =
        b +
        0.5 * share *
            (c - a + share * (2.0 * a - 5.0 * b + 4.0 * c - d + share * (3.0 * (b - c) + d - a)));
  }
  return point;
}

class Matching {
 public:
  Matching(const Ticks& ticks, const std::vector<PathElement>& path) : ticks_(ticks), path_(path) {
    begins_mm_.reserve(path.size() + 1);
    begins_mm_.push_back(0.0);
    for (const PathElement& element : path) {
      begins_mm_.push_back(begins_mm_.back() + element.length_mm());
    }
  }

  Deviation result() {
    match_ticks();
    match_path();
    return found_;
  }

 private:
  // On the elements around the tick's own line: a path that crosses itself cannot mislead then, and
  // whether the line is right is measured, too.
  void match_ticks() {
    places_mm_.reserve(ticks_.at_mm.size());
    double place = 0.0;
    for (std::size_t i = 0; i < ticks_.at_mm.size(); ++i) {
      const Point& tick = ticks_.at_mm[i];
      const double step = i > 0 ? distance_mm(tick, ticks_.at_mm[i - 1]) : 0.0;
      const double expected = place + step;
      const std::size_t own = ticks_.line[i] - path_.front().line;
      const std::size_t last = std::min(own + kAround, path_.size() - 1);
      double best = std::numeric_limits<double>::max();
      double least = best;
      for (std::size_t k = own > kAround ? std::min(own - kAround, last) : 0; k <= last; ++k) {
        const Nearest on = nearest(path_[k], tick);
        const double there = begins_mm_[k] + on.share * (begins_mm_[k + 1] - begins_mm_[k]);
        const double weighed = on.distance_mm + kDetour * std::abs(there - expected);
        if (weighed < least) {
          least = weighed;
          best = on.distance_mm;
          place = there;
        }
      }
      places_mm_.push_back(std::max(place, places_mm_.empty() ? 0.0 : places_mm_.back()));
      found_.of_ticks_mm = std::max(found_.of_ticks_mm, best);
      if (own < path_.size()) {  // the end of the program is a line of its own
        found_.of_line_mm = std::max(found_.of_line_mm, nearest(path_[own], tick).distance_mm);
      }
    }
  }

  void match_path() {
    for (std::size_t k = 0; k < path_.size(); ++k) {
      const double length = begins_mm_[k + 1] - begins_mm_[k];
      const double step = path_[k].radius_mm > 0.0 ? kArcSample_mm : kLineSample_mm;
      const int samples = std::clamp(static_cast<int>(std::ceil(length / step)), 1, kMaxSamples);
      for (int i = 1; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const double distance =
            distance_to_ticks_mm(path_[k].at(share), begins_mm_[k] + share * length);
        found_.of_path_mm = std::max(found_.of_path_mm, distance);
      }
    }
  }

  double distance_to_ticks_mm(const Point& point, double place_mm) {
    const std::size_t count = ticks_.at_mm.size();
    while (oldest_ + 1 < count && places_mm_[oldest_ + 1] < place_mm - kNear_mm) {
      ++oldest_;
    }
    double best = std::numeric_limits<double>::max();
    std::size_t at = oldest_;
    for (std::size_t i = oldest_; i + 1 < count && places_mm_[i] <= place_mm + kNear_mm; ++i) {
      const PathElement chord{.from_mm = ticks_.at_mm[i], .to_mm = ticks_.at_mm[i + 1]};
      const double distance = nearest(chord, point).distance_mm;
      if (distance < best) {
        best = distance;
        at = i;
      }
    }
    for (std::size_t i = at > 1 ? at - 1 : 1; i <= at + 1 && i + 2 < count; ++i) {
      for (int part = 1; part < kCubicParts; ++part) {
        const double share = static_cast<double>(part) / kCubicParts;
        best = std::min(best, distance_mm(point, cubic_through(&ticks_.at_mm[i - 1], share)));
      }
    }
    return best;
  }

  const Ticks& ticks_;
  const std::vector<PathElement>& path_;
  std::vector<double> begins_mm_;  // of each element along the path, and its end
  std::vector<double> places_mm_;  // of each tick along the path
  std::size_t oldest_ = 0;
  Deviation found_{};
};

}  // namespace

OverLimit largest_over_limit(const Ticks& ticks, const lookahead::PlanLimits& limits) {
  OverLimit largest;
  const double ts = limits.period_s;
  const auto look = [&largest](double ratio, std::size_t axis, const char* quantity) {
    if (ratio > largest.ratio) {
      largest = {.ratio = ratio, .what = std::string(1, "xyz"[axis]) + ' ' + quantity};
    }
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const lookahead::MotionLimits& axis = limits.axes[k];
    const auto x = [&](std::size_t i, std::size_t back) {  // it rested before
      return ticks.at_mm[i < back ? 0 : i - back][k];
    };
    for (std::size_t i = 0; i < ticks.at_mm.size(); ++i) {
      const double v = (x(i, 0) - x(i, 1)) / ts;
      const double a = (x(i, 0) - 2.0 * x(i, 1) + x(i, 2)) / (ts * ts);
      const double j = (x(i, 0) - 3.0 * (x(i, 1) - x(i, 2)) - x(i, 3)) / (ts * ts * ts);
      look(std::abs(v) / axis.velocity_mm_s, k, "velocity");
      look(std::abs(a) / axis.acceleration_mm_s2, k, "acceleration");
      look(std::abs(j) / axis.jerk_mm_s3, k, "jerk");
    }
  }
  return largest;
}

Deviation deviation(const Ticks& ticks, const std::vector<PathElement>& path) {
  return Matching(ticks, path).result();
}

}  // namespace kerf::bench
