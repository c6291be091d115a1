#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "lookahead/classical/axis_limit_check.hpp"

namespace kerf::lookahead {

namespace {

constexpr int kInstants = 96;
constexpr double kSmallBend = 0.01;     // of the acceleration
constexpr double kCorner = 1e-6;        // of the acceleration: what is missed at a corner
constexpr int kMaxCorners = 8;          // one within another
constexpr int kPeakSteps = 12;          // of a search for a peak of jerk between instants
constexpr double kSteep = 0.01;         // beside such a peak, of it
constexpr double kHigher = 1.0 + 1e-3;  // than what is looked at anyway
constexpr int kNewtons = 60;            // from an end at rest each takes off a third
constexpr double kClose = 1e-3;         // to a place between two instants, of the way to it

// The shares of a ramp's duration at which it is looked at: closer to each other at both ends,
// where the sine series has its peaks of jerk.
std::array<double, kInstants + 1> make_shares() {
  std::array<double, kInstants + 1> shares{};
  for (std::size_t k = 0; k < shares.size(); ++k) {
    shares[k] = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / kInstants);
  }
  return shares;
}

// When a ramp is looked at: at those shares, where between them its jerk is highest, and where its
// acceleration has a corner.
class Instants {
 public:
  explicit Instants(const profiles::Transition& law) : law_(law) {
    static const std::array<double, kInstants + 1> kShares = make_shares();
    all_.reserve(2 * kShares.size());
    for (const double share : kShares) {
      add(law.duration_s() * share);
    }
    add_first_peak();
    for (std::size_t k = 1; k <= kInstants / 2; ++k) {  // the law is its own mirror image
      const double beside = std::min(jerk_of(k - 1), jerk_of(k + 1));
      if (jerk_of(k) > jerk_of(k - 1) && jerk_of(k) >= jerk_of(k + 1) &&
          jerk_of(k) - beside > kSteep * jerk_of(k)) {
        add_peak({all_[k - 1].t_s, all_[k + 1].t_s}, jerk_of(k));
      }
    }
    sort();
    for (std::size_t k = 1, count = all_.size(); k < count; ++k) {
      add_corners(Instant(all_[k - 1]), Instant(all_[k]), kMaxCorners);
    }
    sort();
  }

  [[nodiscard]] std::vector<Instant> all() && { return std::move(all_); }

 private:
  [[nodiscard]] Instant instant(double t_s) const {
    const profiles::PathMotion motion = law_.at(t_s);
    return {.t_s = t_s,
            .motion = motion,
            .j_before_mm_s3 = motion.j_mm_s3,
            .j_after_mm_s3 = motion.j_mm_s3};
  }
  void add(double t_s) { all_.push_back(instant(t_s)); }
  // A few after all others that are in order.
  void sort() {
    const auto earlier = [](const Instant& a, const Instant& b) { return a.t_s < b.t_s; };
    auto next = std::is_sorted_until(all_.begin(), all_.end(), earlier);
    for (; next != all_.end(); ++next) {
      std::rotate(std::upper_bound(all_.begin(), next, *next, earlier), next, next + 1);
    }
  }
  [[nodiscard]] double jerk(double t_s) const { return std::abs(law_.at(t_s).j_mm_s3); }
  [[nodiscard]] double jerk_of(std::size_t k) const { return std::abs(all_[k].motion.j_mm_s3); }

  // Where the tangents of two instants meet above both; what is there is no higher. Where it is as
  // high it is a corner, else there may be one on each side.
  // NOLINTNEXTLINE(misc-no-recursion): no deeper than kMaxCorners.
  void add_corners(const Instant& from, const Instant& to, int left) {
    const double step_s = to.t_s - from.t_s;
    const double bend = from.j_after_mm_s3 - to.j_before_mm_s3;
    const double high = std::max(from.motion.a_mm_s2, to.motion.a_mm_s2);
    if (left == 0 || !(bend * step_s > kSmallBend * high)) {
      return;
    }
    const double t_s =
        (to.motion.a_mm_s2 - from.motion.a_mm_s2 - to.j_before_mm_s3 * step_s) / bend;
    if (!(t_s > 0.0 && t_s < step_s)) {
      return;
    }
    Instant corner = instant(from.t_s + t_s);
    const double tangents = from.motion.a_mm_s2 + from.j_after_mm_s3 * t_s;
    if (tangents - corner.motion.a_mm_s2 <= kCorner * tangents) {
      corner.j_before_mm_s3 = from.j_after_mm_s3;
      corner.j_after_mm_s3 = to.j_before_mm_s3;
    } else {
      add_corners(from, corner, left - 1);
      add_corners(corner, to, left - 1);
    }
    all_.push_back(corner);
  }

  struct TimeSpan {
    double begin_s = 0.0;
    double end_s = 0.0;
  };

  // One peak lies in the span, and its mirror image beyond: golden sections.
  void add_peak(const TimeSpan& span, double known) {
    auto [begin_s, end_s] = span;
    constexpr double kGolden = 0.6180339887498949;
    double low_s = end_s - kGolden * (end_s - begin_s);
    double high_s = begin_s + kGolden * (end_s - begin_s);
    double low = jerk(low_s);
    double high = jerk(high_s);
    for (int i = 0; i < kPeakSteps; ++i) {
      if (low < high) {
        begin_s = std::exchange(low_s, high_s);
        low = high;
        high_s = begin_s + kGolden * (end_s - begin_s);
        high = jerk(high_s);
      } else {
        end_s = std::exchange(high_s, low_s);
        high = low;
        low_s = end_s - kGolden * (end_s - begin_s);
        low = jerk(low_s);
      }
    }
    if (low > kHigher * known) {
      add(low_s);
      add(law_.duration_s() - low_s);
    }
  }

  // The sine series may have its peaks, mirror images, closer to its ends than any share.
  void add_first_peak() {
    const double known = jerk_of(1);
    double t_s = all_[1].t_s;
    double before = known;
    double now = jerk(0.5 * t_s);
    while (now > kHigher * before) {
      t_s *= 0.5;
      before = now;
      now = jerk(0.5 * t_s);
    }
    if (before > known) {
      add_peak({0.5 * t_s, 2.0 * t_s}, known);
    }
  }

  const profiles::Transition& law_;
  std::vector<Instant> all_;
};

}  // namespace

std::vector<Instant> instants_of(const profiles::Transition& law) {
  assert(law.ramp().v_begin_mm_s <= law.ramp().v_end_mm_s);
  return Instants(law).all();
}

BetweenInstants::BetweenInstants(const Instant& from, const Instant& to)
    : from_(from.motion),
      duration_s_(to.t_s - from.t_s),
      jerk_mm_s3_(duration_s_ > 0.0 ? (to.motion.a_mm_s2 - from_.a_mm_s2) / duration_s_ : 0.0) {
  // Where it is not quite linear the end is met all the same.
  const double way_mm = to.motion.s_mm - from_.s_mm;
  scale_ = way_mm > 0.0 ? way_after_mm(duration_s_) / way_mm : 1.0;
}

double BetweenInstants::way_after_mm(double t_s) const {
  return t_s * (from_.v_mm_s + t_s * (from_.a_mm_s2 / 2.0 + t_s * jerk_mm_s3_ / 6.0));
}

double BetweenInstants::feedrate_after_mm_s(double t_s) const {
  return from_.v_mm_s + t_s * (from_.a_mm_s2 + t_s * jerk_mm_s3_ / 2.0);
}

profiles::PathMotion BetweenInstants::at(double distance_mm) const {
  const double way_mm = scale_ * (distance_mm - from_.s_mm);
  // From the end on: the way is convex over time, so Newton comes down to the place.
  double t_s = duration_s_;
  for (int i = 0; i < kNewtons; ++i) {
    const double off_mm = way_after_mm(t_s) - way_mm;
    if (!(off_mm > kClose * way_mm)) {
      break;
    }
    t_s -= off_mm / feedrate_after_mm_s(t_s);
  }
  return {.s_mm = distance_mm,
          .v_mm_s = feedrate_after_mm_s(t_s),
          .a_mm_s2 = from_.a_mm_s2 + jerk_mm_s3_ * t_s};
}

}  // namespace kerf::lookahead
