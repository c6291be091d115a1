#include "lookahead/classical/axis_limit_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kerf::lookahead {

namespace {

// What lines between samples and between instants may miss is kept free.
constexpr double kAim = 0.993;
// A term below this share of all that can be made smaller is left alone.
constexpr double kSmall = 0.1;
constexpr double kMin = 1e-3;         // of a limit: always left for changes of the feedrate
constexpr std::size_t kTogether = 8;  // instants
constexpr double kWithRounding = 1.0 - 1e-9;

class Asks {
 public:
  explicit Asks(const std::array<MotionLimits, 3>& axes) : axes_(axes) {}

  // Signs as the motion runs.
  void look(const PathSample& at, const profiles::PathMotion& motion) {
    for (std::size_t k = 0; k < 3; ++k) {
      const MotionLimits& axis = axes_[k];
      const AxisTerms terms = axis_terms(at, k, motion);
      if (std::abs(terms.acceleration_mm_s2()) > kAim * axis.acceleration_mm_s2) {
        const double left =
            std::max(kAim * axis.acceleration_mm_s2 - std::abs(terms.centripetal_mm_s2),
                     kMin * axis.acceleration_mm_s2);
        need_acceleration(left / std::abs(terms.tangential_mm_s2));
      }
      const double jumps = at.jumps_per_mm_s[k] * motion.v_mm_s * motion.v_mm_s;
      if (std::abs(terms.jerk_mm_s3()) + jumps > kAim * axis.jerk_mm_s3) {
        const double left = std::max(kAim * axis.jerk_mm_s3 - std::abs(terms.third_mm_s3) - jumps,
                                     kMin * axis.jerk_mm_s3);
        need_jerk(std::abs(terms.along_mm_s3), std::abs(terms.cross_mm_s3), left);
      }
    }
  }

  [[nodiscard]] const RampReduction& ask() const { return ask_; }

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
  RampReduction ask_;
};

// The most of some places and of the motion between some instants.
struct Most {
  PathSample path{};  // without signs
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;

  void add(const PathSample& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      path.first[k] = std::max(path.first[k], std::abs(at.first[k]));
      path.second_per_mm[k] = std::max(path.second_per_mm[k], std::abs(at.second_per_mm[k]));
      path.third_per_mm2[k] = std::max(path.third_per_mm2[k], std::abs(at.third_per_mm2[k]));
      path.jumps_per_mm_s[k] = std::max(path.jumps_per_mm_s[k], at.jumps_per_mm_s[k]);
    }
  }
  // As BetweenInstants has it.
  void add(const Instant& from, const Instant& to) {
    const double mean_mm_s2 = 0.5 * (from.motion.a_mm_s2 + to.motion.a_mm_s2);
    v_mm_s =
        std::max({v_mm_s, from.motion.v_mm_s + (to.t_s - from.t_s) * mean_mm_s2, to.motion.v_mm_s});
    a_mm_s2 = std::max({a_mm_s2, from.motion.a_mm_s2, to.motion.a_mm_s2});
    j_mm_s3 = std::max({j_mm_s3, std::abs(from.j_after_mm_s3), std::abs(to.j_before_mm_s3),
                        std::abs(to.j_after_mm_s3)});
  }

  // Whatever the signs are.
  [[nodiscard]] bool holds(const std::array<MotionLimits, 3>& axes) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const AxisTerms terms =
          axis_terms(path, k, {.v_mm_s = v_mm_s, .a_mm_s2 = a_mm_s2, .j_mm_s3 = j_mm_s3});
      const double jerk_mm_s3 = terms.jerk_mm_s3() + path.jumps_per_mm_s[k] * v_mm_s * v_mm_s;
      if (!(terms.acceleration_mm_s2() <= kWithRounding * kAim * axes[k].acceleration_mm_s2 &&
            jerk_mm_s3 <= kWithRounding * kAim * axes[k].jerk_mm_s3)) {
        return false;
      }
    }
    return true;
  }
};

PathSample between(const PathSample& a, const PathSample& b, double s_mm) {
  const double way = b.s_mm - a.s_mm;
  const double share = way != 0.0 ? (s_mm - a.s_mm) / way : 0.0;
  PathSample at{{}, s_mm};
  const auto line = [share](double x, double y) { return x + share * (y - x); };
  for (std::size_t k = 0; k < 3; ++k) {
    at.first[k] = line(a.first[k], b.first[k]);
    at.second_per_mm[k] = line(a.second_per_mm[k], b.second_per_mm[k]);
    at.third_per_mm2[k] = line(a.third_per_mm2[k], b.third_per_mm2[k]);
    at.jumps_per_mm_s[k] = line(a.jumps_per_mm_s[k], b.jumps_per_mm_s[k]);
  }
  return at;
}

// The samples in the order in which a ramp meets them.
class Way {
 public:
  Way(const PlacedRamp& ramp, const AxisLimitCurve& axis_limits)
      : ramp_(&ramp), axis_limits_(&axis_limits) {
    while (has_next() && distance_mm() <= 0.0) {
      ++next_;
    }
  }

  [[nodiscard]] bool has_next() const { return next_ < axis_limits_->size(); }
  [[nodiscard]] const PathSample& next() const { return sample(next_); }
  // Of the next sample from the foot.
  [[nodiscard]] double distance_mm() const {
    return ramp_->direction * (next().s_mm - ramp_->foot_mm);
  }
  // The next sample.
  [[nodiscard]] bool comes_before(double distance_mm) const {
    return has_next() && this->distance_mm() < distance_mm;
  }
  void pass() { ++next_; }
  // Passes all that come before; most: of them and of the two beside them.
  void pass_until(double distance_mm, Most& most) {
    most.add(sample(next_ > 0 ? next_ - 1 : 0));
    for (; comes_before(distance_mm); pass()) {
      most.add(next());
    }
    most.add(sample(std::min(next_, axis_limits_->size() - 1)));
  }
  // Before the next sample.
  [[nodiscard]] PathSample at(double distance_mm) const {
    return between(sample(next_ > 0 ? next_ - 1 : 0),
                   sample(std::min(next_, axis_limits_->size() - 1)),
                   ramp_->foot_mm + ramp_->direction * distance_mm);
  }

 private:
  [[nodiscard]] const PathSample& sample(std::size_t i) const {
    return (*axis_limits_)[ramp_->direction > 0.0 ? i : axis_limits_->size() - 1 - i];
  }

  const PlacedRamp* ramp_;
  const AxisLimitCurve* axis_limits_;
  std::size_t next_ = 0;
};

// Looks at a ramp from its foot on, some instants together first: where nothing between them can be
// too much, whatever the signs, none of them is looked at alone.
class RampLook {
 public:
  RampLook(const PlacedRamp& ramp, const AxisLimitCurve& axis_limits,
           const std::array<MotionLimits, 3>& axes)
      : direction_(ramp.direction),
        axes_(axes),
        instants_(instants_of(ramp.law)),
        way_(ramp, axis_limits),
        asks_(axes) {}

  RampReduction reduction() && {
    for (std::size_t begin = 0; begin < instants_.size(); begin += kTogether) {
      const Span span{.begin = begin, .end = std::min(begin + kTogether, instants_.size())};
      if (!passes(span)) {
        look_at_each(span);
      }
    }
    return asks_.ask();
  }

 private:
  struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  struct Jerks {
    double before_mm_s3 = 0.0;
    double after_mm_s3 = 0.0;
  };

  [[nodiscard]] const Instant& before(std::size_t i) const { return instants_[i > 0 ? i - 1 : 0]; }

  // From the instant before the first to the last, where all of it holds.
  bool passes(const Span& span) {
    Most most;
    for (std::size_t i = span.begin; i < span.end; ++i) {
      most.add(before(i), instants_[i]);
    }
    Way behind = way_;
    behind.pass_until(instants_[span.end - 1].motion.s_mm, most);
    if (!most.holds(axes_)) {
      return false;
    }
    way_ = behind;
    return true;
  }

  void look_at_each(const Span& span) {
    for (std::size_t i = span.begin; i < span.end; ++i) {
      const Instant& now = instants_[i];
      if (way_.comes_before(now.motion.s_mm)) {
        const BetweenInstants motion(before(i), now);
        for (; way_.comes_before(now.motion.s_mm); way_.pass()) {
          look(way_.next(), motion.at(way_.distance_mm()),
               {before(i).j_after_mm_s3, now.j_before_mm_s3});
        }
      }
      look(way_.at(now.motion.s_mm), now.motion, {now.j_before_mm_s3, now.j_after_mm_s3});
    }
  }

  void look(const PathSample& at, profiles::PathMotion motion, const Jerks& jerks) {
    motion.a_mm_s2 *= direction_;
    motion.j_mm_s3 = jerks.before_mm_s3;
    asks_.look(at, motion);
    if (jerks.after_mm_s3 != jerks.before_mm_s3) {
      motion.j_mm_s3 = jerks.after_mm_s3;
      asks_.look(at, motion);
    }
  }

  double direction_;
  const std::array<MotionLimits, 3>& axes_;
  std::vector<Instant> instants_;
  Way way_;
  Asks asks_;
};

}  // namespace

RampReduction ramp_reduction(const PlacedRamp& ramp, const AxisLimitCurve& axis_limits,
                             const std::array<MotionLimits, 3>& axes) {
  return RampLook(ramp, axis_limits, axes).reduction();
}

}  // namespace kerf::lookahead
