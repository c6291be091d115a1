#include "lookahead/slope.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kerf::lookahead {

namespace {

constexpr std::size_t kClimbPoints = 64;
// A climb between two points of it is no farther above the ceiling than they differ in feedrate.
constexpr double kStrict = 5e-5;
constexpr int kMostHalvings = 16;

}  // namespace

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

double Slope::allowed_from_mm(double v_mm_s) const {
  const auto above =
      std::lower_bound(samples_.begin(), samples_.end() - 1, v_mm_s,
                       [](const Sample& sample, double v) { return sample.v_mm_s < v; });
  if (above == samples_.begin()) {
    return 0.0;
  }
  const Sample& low = *(above - 1);
  const double rise = above->v_mm_s - low.v_mm_s;
  const double share = rise > 0.0 ? std::min((v_mm_s - low.v_mm_s) / rise, 1.0) : 1.0;
  return low.distance_mm + share * (above->distance_mm - low.distance_mm);
}

// What a climb must give way by, from the points of it: each asks by the distance from which its
// feedrate is allowed, and more the shorter the way to it. So no point between two others asks for
// more than the upper one would at the place of the lower one; where that is no more than what is
// given already, nobody looks between them, and elsewhere their distance is halved.
template <typename Ask>
class Slope::Search {
 public:
  Search(const Slope& slope, const profiles::Transition& climb, double least, const Ask& ask)
      : slope_(slope), climb_(climb), most_(least), ask_(ask) {}

  double most() {
    std::array<Point, kClimbPoints + 1> points;
    for (std::size_t k = 0; k < points.size(); ++k) {
      points[k] = point_at(climb_.duration_s() * static_cast<double>(k) / kClimbPoints);
      if (k > 0) {
        hear(points[k]);
      }
    }
    for (std::size_t k = 1; k < points.size(); ++k) {
      look_between(points[k - 1], points[k], kMostHalvings);
    }
    return most_;
  }

 private:
  struct Point {
    double t_s = 0.0;
    double s_mm = 0.0;
    double v_mm_s = 0.0;
    double allowed_from_mm = 0.0;
  };

  [[nodiscard]] Point point_at(double t_s) const {
    const profiles::PathMotion motion = climb_.at(t_s);
    return {.t_s = t_s,
            .s_mm = motion.s_mm,
            .v_mm_s = motion.v_mm_s,
            .allowed_from_mm = slope_.allowed_from_mm(motion.v_mm_s)};
  }

  void hear(const Point& point) {
    if (point.allowed_from_mm > 0.0) {
      most_ = std::max(most_, ask_(point.allowed_from_mm, point.s_mm));
    }
  }

  void look_between(const Point& low, const Point& high, int halvings) {
    if (halvings == 0 || high.allowed_from_mm <= 0.0 ||
        high.v_mm_s - low.v_mm_s <= kStrict * high.v_mm_s ||
        ask_(high.allowed_from_mm, low.s_mm) <= most_) {
      return;
    }
    const Point middle = point_at(0.5 * (low.t_s + high.t_s));
    hear(middle);
    look_between(middle, high, halvings - 1);
    look_between(low, middle, halvings - 1);
  }

  const Slope& slope_;
  const profiles::Transition& climb_;
  double most_;
  const Ask& ask_;
};

double Slope::stretch_for(const profiles::Transition& climb) const {
  if (samples_.empty() || climb.length_mm() <= 0.0) {
    return 1.0;
  }
  const auto ask = [](double allowed_from_mm, double s_mm) {
    return s_mm > 0.0 ? allowed_from_mm / s_mm : kHighest;
  };
  return Search(*this, climb, 1.0, ask).most();
}

double Slope::delay_for_mm(const profiles::Transition& climb) const {
  if (samples_.empty() || climb.length_mm() <= 0.0) {
    return 0.0;
  }
  const auto ask = [](double allowed_from_mm, double s_mm) { return allowed_from_mm - s_mm; };
  return Search(*this, climb, 0.0, ask).most();
}

}  // namespace kerf::lookahead
