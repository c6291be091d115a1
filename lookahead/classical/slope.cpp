#include "lookahead/classical/slope.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace kerf::lookahead {

namespace {

constexpr std::size_t kRampParts = 64;
constexpr std::size_t kRampHalvings = 6;  // to one of them
// A ramp between two points of it is no farther above the limit curve than they differ in feedrate.
constexpr double kStrict = 5e-5;
constexpr int kMaxHalvings = 16;
constexpr double kWithRounding = 1.0 + 1e-12;

}  // namespace

Slope::Slope(std::vector<Sample> samples) {
  double lowest = kHighest;
  std::for_each(samples.rbegin(), samples.rend(), [&lowest](Sample& sample) {
    lowest = std::min(lowest, sample.v_mm_s);
    sample.v_mm_s = lowest;
  });
  const auto is_within_flat = [&samples](std::size_t i) {
    return i > 0 && i + 1 < samples.size() && samples[i - 1].v_mm_s == samples[i].v_mm_s &&
           samples[i].v_mm_s == samples[i + 1].v_mm_s;
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_within_flat(i)) {
      samples_.push_back(samples[i]);
    }
  }
}

double Slope::top_mm_s() const noexcept {
  if (samples_.empty()) {
    return kHighest;
  }
  return samples_.back().v_mm_s;
}

double Slope::bottom_mm_s() const noexcept {
  return samples_.empty() ? kHighest : samples_.front().v_mm_s;
}

Slope Slope::from(double distance_mm) const {
  if (samples_.empty()) {
    return {};
  }
  std::vector<Sample> rest;
  for (auto at = samples_.rbegin(); at != samples_.rend(); ++at) {
    if (at->distance_mm <= distance_mm) {
      rest.push_back({.distance_mm = 0.0, .v_mm_s = at->v_mm_s});
      break;
    }
    rest.push_back({.distance_mm = at->distance_mm - distance_mm, .v_mm_s = at->v_mm_s});
  }
  std::reverse(rest.begin(), rest.end());
  return Slope(std::move(rest));
}

Slope::Allowed Slope::allowed(double v_mm_s) const {
  assert(!samples_.empty());
  const auto above =
      std::ranges::lower_bound(samples_.begin(), samples_.end() - 1, v_mm_s, {}, &Sample::v_mm_s);
  if (above == samples_.begin()) {
    return {};
  }
  const Sample& low = *(above - 1);
  const double rise = above->v_mm_s - low.v_mm_s;
  const double share = rise > 0.0 ? std::min((v_mm_s - low.v_mm_s) / rise, 1.0) : 1.0;
  return {.from_mm = low.distance_mm + share * (above->distance_mm - low.distance_mm),
          .line = static_cast<std::size_t>(above - samples_.begin())};
}

double Slope::allowed_from_mm(double v_mm_s) const {
  return allowed(v_mm_s).from_mm;
}

double Slope::mm_per_mm_s(std::size_t line) const {
  const Sample& low = samples_[line - 1];
  const Sample& high = samples_[line];
  return (high.distance_mm - low.distance_mm) / (high.v_mm_s - low.v_mm_s);
}

// What a ramp must give way by, from the points of it: each asks by the distance from which its
// feedrate is allowed, and more the shorter the way to it. So no point between two others asks for
// more than the upper one would at the place of the lower one. Where both are on one line of the
// slope, none asks for more than one would that leaves the lower one with the higher acceleration
// of the two but covers the way at the lower feedrate: that is closer. (The acceleration rises or
// falls between them, as their jerks say.) Where neither is more than what is given already, nobody
// looks between them, and elsewhere their distance is halved. The lower half comes first: mostly it
// is the one that asks for most.
template <typename Ask>
class Slope::Search {
 public:
  Search(const Slope& slope, const profiles::Transition& ramp, double least, const Ask& ask)
      : slope_(slope), ramp_(ramp), max_(least), ask_(ask) {}

  double most() {
    std::array<Parts, kRampHalvings + 1> open;  // each halving leaves one behind
    std::size_t count = 0;
    open[count++] = {.low = point_at(0.0), .high = heard(kRampParts), .end = kRampParts};
    while (count > 0) {
      const Parts parts = open[--count];
      if (!asks_for_more(parts.low, parts.high)) {
        continue;
      }
      if (parts.end - parts.begin == 1) {
        look_between(parts.low, parts.high);
        continue;
      }
      const std::size_t at = (parts.begin + parts.end) / 2;
      const Point middle = heard(at);
      open[count++] = {.low = middle, .high = parts.high, .begin = at, .end = parts.end};
      open[count++] = {.low = parts.low, .high = middle, .begin = parts.begin, .end = at};
    }
    return max_;
  }

 private:
  struct Point {
    double t_s = 0.0;
    double s_mm = 0.0;
    double v_mm_s = 0.0;
    double a_mm_s2 = 0.0;
    double j_mm_s3 = 0.0;
    Allowed allowed{};
  };

  [[nodiscard]] Point point_at(double t_s) const {
    const profiles::PathMotion motion = ramp_.at(t_s);
    return {.t_s = t_s,
            .s_mm = motion.s_mm,
            .v_mm_s = motion.v_mm_s,
            .a_mm_s2 = motion.a_mm_s2,
            .j_mm_s3 = motion.j_mm_s3,
            .allowed = slope_.allowed(motion.v_mm_s)};
  }

  void hear(const Point& point) {
    if (point.allowed.from_mm > 0.0) {
      max_ = std::max(max_, ask_(point.allowed.from_mm, point.s_mm));
    }
  }

  // At the end of so many parts of the ramp.
  Point heard(std::size_t parts) {
    const Point point = point_at(ramp_.duration_s() * static_cast<double>(parts) / kRampParts);
    hear(point);
    return point;
  }

  // Whether any place between the points may.
  [[nodiscard]] bool asks_for_more(const Point& low, const Point& high) const {
    return high.allowed.from_mm > 0.0 && ask_(high.allowed.from_mm, low.s_mm) > max_ &&
           closest(low, high) > max_;
  }

  // What is asked for between them at most, where they are on one line.
  [[nodiscard]] double closest(const Point& low, const Point& high) const {
    const double step_s = high.t_s - low.t_s;
    const double way_mm = low.s_mm + low.v_mm_s * step_s;
    if (low.allowed.line != high.allowed.line || low.j_mm_s3 * high.j_mm_s3 < 0.0 ||
        !(way_mm > 0.0) || (low.s_mm == 0.0 && low.allowed.from_mm > 0.0)) {
      return kHighest;
    }
    const double gain_mm_s = std::max(low.a_mm_s2, high.a_mm_s2) * step_s;
    const double from_mm = low.allowed.from_mm + slope_.mm_per_mm_s(low.allowed.line) * gain_mm_s;
    return ask_(kWithRounding * from_mm, way_mm);
  }

  // Of the ramp, from the begin of one to the end of another.
  struct Parts {
    Point low{};
    Point high{};
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  struct Gap {
    Point low{};
    Point high{};
    int halvings = 0;
  };

  [[nodiscard]] bool may_ask_for_more(const Gap& gap) const {
    return gap.halvings < kMaxHalvings &&
           gap.high.v_mm_s - gap.low.v_mm_s > kStrict * gap.high.v_mm_s &&
           asks_for_more(gap.low, gap.high);
  }

  void look_between(const Point& low, const Point& high) {
    std::array<Gap, kMaxHalvings + 1> open;  // each halving leaves one behind
    std::size_t count = 0;
    open[count++] = {.low = low, .high = high};
    while (count > 0) {
      const Gap gap = open[--count];
      if (!may_ask_for_more(gap)) {
        continue;
      }
      const Point middle = point_at(0.5 * (gap.low.t_s + gap.high.t_s));
      hear(middle);
      open[count++] = {.low = middle, .high = gap.high, .halvings = gap.halvings + 1};
      open[count++] = {.low = gap.low, .high = middle, .halvings = gap.halvings + 1};
    }
  }

  const Slope& slope_;
  const profiles::Transition& ramp_;
  double max_;
  const Ask& ask_;
};

double Slope::stretch_for(const profiles::Transition& ramp) const {
  if (samples_.empty() || ramp.length_mm() <= 0.0) {
    return 1.0;
  }
  const auto ask = [](double allowed_from_mm, double s_mm) {
    return s_mm > 0.0 ? allowed_from_mm / s_mm : kHighest;
  };
  return Search(*this, ramp, 1.0, ask).most();
}

double Slope::delay_for_mm(const profiles::Transition& ramp) const {
  if (samples_.empty() || ramp.length_mm() <= 0.0) {
    return 0.0;
  }
  const auto ask = [](double allowed_from_mm, double s_mm) { return allowed_from_mm - s_mm; };
  return Search(*this, ramp, 0.0, ask).most();
}

}  // namespace kerf::lookahead
