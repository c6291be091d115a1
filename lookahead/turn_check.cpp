#include "lookahead/turn_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace kerf::lookahead {

namespace {

constexpr int kInstants = 96;
// What lines between samples and between instants may miss is kept free.
constexpr double kAim = 0.993;
// A term below this share of all that can be made smaller is left alone.
constexpr double kSmall = 0.1;
constexpr double kSmallKink = 0.01;     // of the acceleration
constexpr int kPeakSteps = 12;          // of a search for a peak of jerk between instants
constexpr double kSteep = 0.01;         // beside such a peak, of it
constexpr double kHigher = 1.0 + 1e-3;  // than what is looked at anyway
constexpr double kLeast = 1e-3;         // of a limit: always left for changes of the feedrate

class Asks {
 public:
  explicit Asks(const std::array<MotionLimits, 3>& axes) : axes_(axes) {}

  // Signs as the motion runs.
  void look(const TurnSample& at, double v, double a, double j) {
    for (std::size_t k = 0; k < 3; ++k) {
      const MotionLimits& axis = axes_[k];
      const double turning = at.second_per_mm[k] * v * v;
      const double change = at.first[k] * a;
      if (std::abs(change + turning) > kAim * axis.acceleration_mm_s2) {
        const double left = std::max(kAim * axis.acceleration_mm_s2 - std::abs(turning),
                                     kLeast * axis.acceleration_mm_s2);
        need_acceleration(left / std::abs(change));
      }
      const double along = at.first[k] * j;
      const double cross = 3.0 * at.second_per_mm[k] * v * a;
      const double third = at.third_per_mm2[k] * v * v * v;
      const double jumps = at.jumps_per_mm_s[k] * v * v;
      if (std::abs(along + cross + third) + jumps > kAim * axis.jerk_mm_s3) {
        const double left =
            std::max(kAim * axis.jerk_mm_s3 - std::abs(third) - jumps, kLeast * axis.jerk_mm_s3);
        need_jerk(std::abs(along), std::abs(cross), left);
      }
    }
  }

  [[nodiscard]] const TurnAsk& ask() const { return ask_; }

 private:
  void need_acceleration(double factor) {
    if (factor < 1.0) {
      ask_.acceleration = std::min(ask_.acceleration, factor);
      ask_.stretch = std::max(ask_.stretch, 1.0 / factor);
    }
  }

  void need_jerk(double along, double cross, double left) {
    const double sum = along + cross;
    if (sum <= left) {
      return;
    }
    const double factor = left / sum;
    if (along > kSmall * sum) {
      ask_.jerk = std::min(ask_.jerk, factor);
    }
    if (cross > kSmall * sum) {
      ask_.acceleration = std::min(ask_.acceleration, factor);
    }
    // along / x^2 + cross / x = left
    const double x = (cross + std::sqrt(cross * cross + 4.0 * left * along)) / (2.0 * left);
    ask_.stretch = std::max(ask_.stretch, x);
  }

  const std::array<MotionLimits, 3>& axes_;
  TurnAsk ask_;
};

// The acceleration where the tangents of two instants meet, which is no lower than any between
// them; 0: no higher than theirs.
double kink_mm_s2(const profiles::PathMotion& from, const profiles::PathMotion& to, double step_s) {
  const double bend = from.j_mm_s3 - to.j_mm_s3;
  const double high = std::max(from.a_mm_s2, to.a_mm_s2);
  if (!(bend * step_s > kSmallKink * high)) {
    return 0.0;
  }
  const double t = (to.a_mm_s2 - from.a_mm_s2 - to.j_mm_s3 * step_s) / bend;
  return t > 0.0 && t < step_s ? from.a_mm_s2 + from.j_mm_s3 * t : 0.0;
}

TurnSample between(const TurnSample& a, const TurnSample& b, double s_mm) {
  const double way = b.s_mm - a.s_mm;
  const double share = way != 0.0 ? (s_mm - a.s_mm) / way : 0.0;
  TurnSample at{.s_mm = s_mm};
  const auto line = [share](double x, double y) { return x + share * (y - x); };
  for (std::size_t k = 0; k < 3; ++k) {
    at.first[k] = line(a.first[k], b.first[k]);
    at.second_per_mm[k] = line(a.second_per_mm[k], b.second_per_mm[k]);
    at.third_per_mm2[k] = line(a.third_per_mm2[k], b.third_per_mm2[k]);
    at.jumps_per_mm_s[k] = line(a.jumps_per_mm_s[k], b.jumps_per_mm_s[k]);
  }
  return at;
}

// The shares of a climb's duration at which it is looked at: closer to each other at both ends,
// where the sine series has its peaks of jerk.
std::array<double, kInstants + 1> make_shares() {
  std::array<double, kInstants + 1> shares{};
  for (std::size_t k = 0; k < shares.size(); ++k) {
    shares[k] = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / kInstants);
  }
  return shares;
}

struct Instant {
  double t_s = 0.0;
  profiles::PathMotion motion{};
};

// When a climb is looked at: at those shares, and where between them its jerk is highest.
class Instants {
 public:
  explicit Instants(const profiles::Transition& law) : law_(law) {
    static const std::array<double, kInstants + 1> kShares = make_shares();
    for (const double share : kShares) {
      add(law.duration_s() * share);
    }
    add_first_peak();
    for (std::size_t k = 1; k <= kInstants / 2; ++k) {  // the law is its own mirror image
      const double beside = std::min(jerk_of(k - 1), jerk_of(k + 1));
      if (jerk_of(k) > jerk_of(k - 1) && jerk_of(k) >= jerk_of(k + 1) &&
          jerk_of(k) - beside > kSteep * jerk_of(k)) {
        add_peak(all_[k - 1].t_s, all_[k + 1].t_s, jerk_of(k));
      }
    }
    std::sort(all_.begin(), all_.end(),
              [](const Instant& a, const Instant& b) { return a.t_s < b.t_s; });
  }

  [[nodiscard]] const std::vector<Instant>& all() const { return all_; }

 private:
  void add(double t_s) { all_.push_back({.t_s = t_s, .motion = law_.at(t_s)}); }
  [[nodiscard]] double jerk(double t_s) const { return std::abs(law_.at(t_s).j_mm_s3); }
  [[nodiscard]] double jerk_of(std::size_t k) const { return std::abs(all_[k].motion.j_mm_s3); }

  // One peak lies between the two, and its mirror image: golden sections.
  void add_peak(double begin_s, double end_s, double known) {
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
      add_peak(0.5 * t_s, 2.0 * t_s, known);
    }
  }

  const profiles::Transition& law_;
  std::vector<Instant> all_;
};

// The samples in the order in which a climb meets them.
class Way {
 public:
  Way(const PlacedClimb& climb, const Turning& turning) : climb_(climb), turning_(turning) {
    while (has_next() && distance_mm() <= 0.0) {
      ++next_;
    }
  }

  [[nodiscard]] bool has_next() const { return next_ < turning_.size(); }
  [[nodiscard]] const TurnSample& next() const { return sample(next_); }
  // Of the next sample from the foot.
  [[nodiscard]] double distance_mm() const {
    return climb_.direction * (next().s_mm - climb_.foot_mm);
  }
  void pass() { ++next_; }
  // Before the next sample.
  [[nodiscard]] TurnSample at(double distance_mm) const {
    return between(sample(next_ > 0 ? next_ - 1 : 0), sample(std::min(next_, turning_.size() - 1)),
                   climb_.foot_mm + climb_.direction * distance_mm);
  }

 private:
  [[nodiscard]] const TurnSample& sample(std::size_t i) const {
    return turning_[climb_.direction > 0.0 ? i : turning_.size() - 1 - i];
  }

  const PlacedClimb& climb_;
  const Turning& turning_;
  std::size_t next_ = 0;
};

}  // namespace

TurnAsk ask_turning(const PlacedClimb& climb, const Turning& turning,
                    const std::array<MotionLimits, 3>& axes) {
  const Instants instants(climb.law);
  Asks asks(axes);
  Way way(climb, turning);
  double t_before_s = 0.0;
  profiles::PathMotion before = climb.law.at(0.0);
  // Jerk may jump between the two instants: both are looked at.
  const auto look_between = [&](const TurnSample& at, const profiles::PathMotion& now, double v,
                                double a) {
    asks.look(at, v, climb.direction * a, before.j_mm_s3);
    asks.look(at, v, climb.direction * a, now.j_mm_s3);
  };
  for (const auto& [t_s, now] : instants.all()) {
    for (; way.has_next() && way.distance_mm() < now.s_mm; way.pass()) {
      const double x = (way.distance_mm() - before.s_mm) / (now.s_mm - before.s_mm);
      // Linear over the way is v^2, not v: near a slow foot the difference is large.
      const double squared = before.v_mm_s * before.v_mm_s;
      look_between(way.next(), now, std::sqrt(squared + x * (now.v_mm_s * now.v_mm_s - squared)),
                   before.a_mm_s2 + x * (now.a_mm_s2 - before.a_mm_s2));
    }
    const double kink = kink_mm_s2(before, now, t_s - t_before_s);
    if (kink != 0.0) {
      look_between(way.at(0.5 * (before.s_mm + now.s_mm)), now, 0.5 * (before.v_mm_s + now.v_mm_s),
                   kink);
    }
    asks.look(way.at(now.s_mm), now.v_mm_s, climb.direction * now.a_mm_s2, now.j_mm_s3);
    before = now;
    t_before_s = t_s;
  }
  return asks.ask();
}

}  // namespace kerf::lookahead
