#include "tests/kernel/dense_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace kerf::test {

namespace {

constexpr int kMaxHalvings = 50;
// Each span of knots at first in so many even parts, and towards its ends in halves: where weights
// are far apart, the curve runs there.
constexpr int kPartsOfPiece = 16;
constexpr int kTowardsEnds = 36;
// Of the length, and of the place of a tick.
constexpr double kLengths = 1e-8;
constexpr double kBeside_mm = 1e-6;
// Where the curve turns back, its way between two points is longer than all chords: the parameter
// runs unevenly there, and is halved until what is missed is less than this.
constexpr double kUneven = 1.5;
constexpr double kTiny_mm = 1e-9;
// What the scan's straight lines between its samples may miss of a curve's bound.
constexpr double kRelativeToLength = 1e-3;

double distance_mm(const Vec& a, const Vec& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Vec between(const Vec& a, const Vec& b, double share) {
  Vec point{};
  for (std::size_t k = 0; k < 3; ++k) {
    point[k] = a[k] + share * (b[k] - a[k]);
  }
  return point;
}

double from_chord_mm(const Vec& point, const Vec& a, const Vec& b) {
  double squared = 0.0;
  double along = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    squared += (b[k] - a[k]) * (b[k] - a[k]);
    along += (point[k] - a[k]) * (b[k] - a[k]);
  }
  const double share = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  return distance_mm(point, between(a, b, share));
}

class Dense {
 public:
  Dense(const curves::NurbsData& data, double sag_mm) : knots_(data.knots), sag_mm_(sag_mm) {
    for (const curves::ControlPoint& point : data.points) {
      points_.push_back({.position_mm = point.position_mm, .weight = point.weight});
    }
  }

  std::vector<PathPoint> path() {
    path_.push_back({.position_mm = at(knots_.front())});
    for (std::size_t i = 1; i < knots_.size(); ++i) {
      if (knots_[i] > knots_[i - 1]) {
        add_segment(knots_[i - 1], knots_[i]);
      }
    }
    return std::move(path_);
  }

 private:
  struct Part {
    double u_begin = 0.0;
    double u_end = 0.0;
    Vec begin{};
    Vec end{};
    int halvings = 0;
  };

  [[nodiscard]] Vec at(double u) const { return nurbs_point(points_, knots_, u); }

  void add_segment(double from, double to) {
    std::vector<double> shares{1.0};
    for (int k = 1; k < kPartsOfPiece; ++k) {
      shares.push_back(static_cast<double>(k) / kPartsOfPiece);
    }
    for (int k = 5; k < kTowardsEnds; ++k) {
      shares.push_back(std::ldexp(1.0, -k));
      shares.push_back(1.0 - std::ldexp(1.0, -k));
    }
    std::sort(shares.begin(), shares.end());
    double u = from;
    for (const double share : shares) {
      const double next = from + share * (to - from);
      if (next > u) {
        add({.u_begin = u, .u_end = next, .begin = path_.back().position_mm, .end = at(next)});
        u = next;
      }
    }
  }

  void add(const Part& part) {
    const double width = part.u_end - part.u_begin;
    std::array<Vec, 5> p{part.begin, {}, {}, {}, part.end};
    bool straight = true;
    for (std::size_t k = 1; k < 4; ++k) {
      p[k] = at(part.u_begin + 0.25 * static_cast<double>(k) * width);
      straight = straight && from_chord_mm(p[k], part.begin, part.end) <= sag_mm_;
    }
    const double halves = distance_mm(p[0], p[2]) + distance_mm(p[2], p[4]);
    double quarters = 0.0;
    double shortest = halves;
    double longest = 0.0;
    for (std::size_t k = 1; k < 5; ++k) {
      const double quarter = distance_mm(p[k - 1], p[k]);
      quarters += quarter;
      shortest = std::min(shortest, quarter);
      longest = std::max(longest, quarter);
    }
    straight = straight && quarters - halves <= kLengths * quarters + kTiny_mm &&
               (longest < kUneven * shortest || longest < kTiny_mm);
    const double middle = part.u_begin + 0.5 * width;
    if (straight || part.halvings == kMaxHalvings || middle == part.u_begin ||
        middle == part.u_end) {
      // Richardson's step from the sums of chords to the arc.
      path_.push_back(
          {.position_mm = part.end, .s_mm = path_.back().s_mm + (4.0 * quarters - halves) / 3.0});
      return;
    }
    const int halvings = part.halvings + 1;
    add({part.u_begin, middle, part.begin, p[2], halvings});
    add({middle, part.u_end, p[2], part.end, halvings});
  }

  std::vector<WeightedPoint> points_;
  const std::vector<double>& knots_;
  double sag_mm_;
  std::vector<PathPoint> path_;
};

}  // namespace

std::vector<PathPoint> dense_path(const curves::NurbsData& data, double sag_mm) {
  return Dense(data, sag_mm).path();
}

void DenseChecker::add(const interp::Setpoint& setpoint) {
  const std::vector<PathPoint>& path = *path_;
  const Vec from_mm = position_mm_;
  position_mm_ = setpoint.position_mm;
  double error_mm = 0.0;
  while (next_ + 1 < path.size() && path[next_].s_mm <= setpoint.s_mm) {
    if (begun_) {
      error_mm = std::max(error_mm, from_chord_mm(path[next_].position_mm, from_mm, position_mm_));
    }
    ++next_;
  }
  begun_ = true;
  const PathPoint& after = path[next_];
  const PathPoint& before = path[next_ > 0 ? next_ - 1 : 0];
  const double way = after.s_mm - before.s_mm;
  const double share = way > 0.0 ? std::clamp((setpoint.s_mm - before.s_mm) / way, 0.0, 1.0) : 0.0;
  const double off_mm =
      distance_mm(position_mm_, between(before.position_mm, after.position_mm, share));
  largest_mm_ = std::max(largest_mm_, error_mm);
  const double sag_mm = kRelativeToLength * tolerance_mm_;
  if (!(off_mm <= kBeside_mm + sag_mm)) {
    complain("distance from the curve", off_mm, setpoint);
  }
  if (!(error_mm <= tolerance_mm_ + 2.0 * sag_mm + kBeside_mm * kRelativeToLength)) {
    complain("chord error", error_mm, setpoint);
  }
}

void DenseChecker::complain(const std::string& what, double found_mm,
                            const interp::Setpoint& setpoint) {
  if (complaint_.empty()) {
    std::ostringstream text;
    text.precision(12);
    text << what << " " << found_mm << " mm, tolerance " << tolerance_mm_ << ", at tick "
         << setpoint.tick << ", line " << setpoint.line << ", s " << setpoint.s_mm;
    complaint_ = text.str();
  }
}

}  // namespace kerf::test
