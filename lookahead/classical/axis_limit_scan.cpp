#include "lookahead/classical/axis_limit_scan.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kerf::lookahead {

using curves::NurbsCurve;
using curves::NurbsPiece;
using curves::vec;

namespace {

// Of an axis' limits, what curvature at constant feedrate may take.
constexpr double kAccelerationShare = 0.9;
constexpr double kJerkShare = 0.7;
// Of a limit, or of a feedrate: what lines between samples may miss.
constexpr double kMissed = 0.0015;
constexpr int kPartsOfPiece = 4;
constexpr int kMaxHalvings = 8;
constexpr double kJump = 1e-6;  // of curvature's size: what is less is rounding
constexpr double kStepPeak = 0.75;
// The support of a third difference, and what acceleration adds to its way.
constexpr double kReachTicks = 3.3;

// The largest v with step v^2 + third v^3 <= bound: Newton from above on a convex function.
double jerk_feedrate_mm_s(double step, double third, double bound) {
  double v = kUnbounded;
  if (step > 0.0) {
    v = std::sqrt(bound / step);
  }
  if (third > 0.0) {
    v = std::min(v, std::cbrt(bound / third));
  }
  if (!(step > 0.0 && third > 0.0) || !std::isfinite(v)) {
    return v;
  }
  for (int i = 0; i < 6; ++i) {
    v -= (v * v * (step + v * third) - bound) / (v * (2.0 * step + 3.0 * third * v));
  }
  return v;
}

class Scan {
 public:
  Scan(const NurbsCurve& curve, double feedrate_mm_s, const PlanLimits& limits)
      : curve_(curve), cap_mm_s_(feedrate_mm_s), limits_(limits) {}

  AxisLimitCurve samples() {
    for (const NurbsPiece& piece : curve_.pieces()) {
      add_piece(piece);
    }
    add_jumps();
    return std::move(samples_);
  }

 private:
  struct Jump {
    double s_mm = 0.0;
    double reach_mm = 0.0;
    curves::Position jerk_per_mm_s{};
  };

  void find_feedrate(PathSample& sample) const {
    sample.feedrate_mm_s = kUnbounded;
    for (std::size_t k = 0; k < 3; ++k) {
      const MotionLimits& axis = limits_.axes[k];
      const auto bind = [&](double v_mm_s, Constraint limit) {
        sample.bind_feedrate(v_mm_s, interp::of_axis(limit, k));
      };
      const double second = std::abs(sample.second_per_mm[k]);
      if (sample.first[k] != 0.0) {
        const double share = second > 0.0 ? 1.0 - kMissed : 1.0;
        bind(share * axis.velocity_mm_s / std::abs(sample.first[k]), Constraint::x_velocity);
      }
      if (second > 0.0) {
        bind(std::sqrt(kAccelerationShare * axis.acceleration_mm_s2 / second),
             Constraint::x_acceleration);
      }
      bind(jerk_feedrate_mm_s(sample.jumps_per_mm_s[k], std::abs(sample.third_per_mm2[k]),
                              kJerkShare * axis.jerk_mm_s3),
           Constraint::x_jerk);
    }
  }

  [[nodiscard]] PathSample sample_at(const NurbsPiece& piece, double s_mm) const {
    PathSample sample{piece.derivatives_at(s_mm), s_mm};
    find_feedrate(sample);
    return sample;
  }

  // Whether the line from a to b misses what is in the middle.
  [[nodiscard]] bool misses(const PathSample& a, const PathSample& m, const PathSample& b) const {
    const double v = std::min(cap_mm_s_, m.feedrate_mm_s);
    const double line =
        0.5 * (std::min(cap_mm_s_, a.feedrate_mm_s) + std::min(cap_mm_s_, b.feedrate_mm_s));
    if (line - v > kMissed * v) {
      return true;
    }
    const auto off = [](const curves::Position& x, const curves::Position& y,
                        const curves::Position& z,
                        std::size_t k) { return std::abs(y[k] - 0.5 * (x[k] + z[k])); };
    for (std::size_t k = 0; k < 3; ++k) {
      const MotionLimits& axis = limits_.axes[k];
      if (off(a.first, m.first, b.first, k) > kMissed ||
          off(a.second_per_mm, m.second_per_mm, b.second_per_mm, k) * v * v >
              kMissed * axis.acceleration_mm_s2 ||
          off(a.third_per_mm2, m.third_per_mm2, b.third_per_mm2, k) * v * v * v >
              kMissed * axis.jerk_mm_s3) {
        return true;
      }
    }
    return false;
  }

  // NOLINTNEXTLINE(misc-no-recursion): no deeper than kMaxHalvings.
  void add_between(const NurbsPiece& piece, const PathSample& a, const PathSample& b,
                   int halvings) {
    const PathSample middle = sample_at(piece, 0.5 * (a.s_mm + b.s_mm));
    const bool finer = halvings < kMaxHalvings && misses(a, middle, b);
    if (finer) {
      add_between(piece, a, middle, halvings + 1);
    }
    samples_.push_back(middle);
    if (finer) {
      add_between(piece, middle, b, halvings + 1);
    }
  }

  void add_piece(const NurbsPiece& piece) {
    PathSample from = sample_at(piece, piece.s_begin_mm);
    add_first(from);
    for (int i = 1; i <= kPartsOfPiece; ++i) {
      const double share = static_cast<double>(i) / kPartsOfPiece;
      const PathSample to =
          sample_at(piece, i == kPartsOfPiece
                               ? piece.s_end_mm
                               : piece.s_begin_mm + share * (piece.s_end_mm - piece.s_begin_mm));
      add_between(piece, from, to, 0);
      samples_.push_back(to);
      from = to;
    }
  }

  // The end of the piece before stands at the same place.
  void add_first(const PathSample& first) {
    if (!samples_.empty()) {
      const PathSample& last = samples_.back();
      const double size = std::max(vec(last.second_per_mm).norm(), vec(first.second_per_mm).norm());
      const Eigen::Vector3d jump = vec(first.second_per_mm) - vec(last.second_per_mm);
      if (jump.norm() > kJump * size) {
        add_jump(first.s_mm, jump);
      }
    }
    samples_.push_back(first);
  }

  void add_jump(double s_mm, const Eigen::Vector3d& curvature_per_mm) {
    Jump jump{.s_mm = s_mm};
    double v = cap_mm_s_;
    for (std::size_t k = 0; k < 3; ++k) {
      jump.jerk_per_mm_s[k] =
          kStepPeak * std::abs(curvature_per_mm[static_cast<Eigen::Index>(k)]) / limits_.period_s;
      v = std::min(v, jerk_feedrate_mm_s(jump.jerk_per_mm_s[k], 0.0,
                                         kJerkShare * limits_.axes[k].jerk_mm_s3));
    }
    jump.reach_mm = kReachTicks * limits_.period_s * v;
    jumps_.push_back(jump);
  }

  void insert(double s_mm) {
    if (!(s_mm > 0.0 && s_mm < curve_.length_mm())) {
      return;
    }
    const auto place = std::ranges::lower_bound(samples_, s_mm, {}, &PathSample::s_mm);
    if (place->s_mm != s_mm) {
      samples_.insert(place, sample_at(curve_.pieces()[curve_.piece_index(s_mm)], s_mm));
    }
  }

  void add_jumps() {
    for (const Jump& jump : jumps_) {
      insert(jump.s_mm - jump.reach_mm);
      insert(jump.s_mm + jump.reach_mm);
    }
    for (const Jump& jump : jumps_) {
      auto sample =
          std::ranges::lower_bound(samples_, jump.s_mm - jump.reach_mm, {}, &PathSample::s_mm);
      for (; sample != samples_.end() && sample->s_mm <= jump.s_mm + jump.reach_mm; ++sample) {
        for (std::size_t k = 0; k < 3; ++k) {
          sample->jumps_per_mm_s[k] += jump.jerk_per_mm_s[k];
        }
      }
    }
    if (!jumps_.empty()) {
      for (PathSample& sample : samples_) {
        find_feedrate(sample);
      }
    }
  }

  const NurbsCurve& curve_;
  double cap_mm_s_;
  const PlanLimits& limits_;
  AxisLimitCurve samples_;
  std::vector<Jump> jumps_;
};

// A line through values over s.
double between(double s0, double v0, double s1, double v1, double s) {
  return s1 > s0 ? v0 + (v1 - v0) * (s - s0) / (s1 - s0) : std::min(v0, v1);
}

// At a place; after: the limit curve's first sample after that.
FeedSample sample_at(double s_mm, const VelocityLimitCurve& limit_curve, std::size_t after) {
  after = std::min(after, limit_curve.size() - 1);
  const FeedSample& next = limit_curve[after];
  const FeedSample& last = limit_curve[after > 0 ? after - 1 : 0];
  return {.u = between(last.s_mm, last.u, next.s_mm, next.u, s_mm),
          .s_mm = s_mm,
          .v_mm_s = between(last.s_mm, last.v_mm_s, next.s_mm, next.v_mm_s, s_mm)};
}

// Of samples at one place the slower counts.
void append(const FeedSample& sample, VelocityLimitCurve& curve) {
  if (!curve.empty() && (sample.s_mm <= curve.back().s_mm || sample.u <= curve.back().u)) {
    curve.back().v_mm_s = std::min(curve.back().v_mm_s, sample.v_mm_s);
  } else {
    curve.push_back(sample);
  }
}

}  // namespace

AxisLimitCurve scan_axis_limits(const NurbsCurve& curve, double feedrate_mm_s,
                                const PlanLimits& limits) {
  const bool any =
      std::any_of(limits.axes.begin(), limits.axes.end(), [](const MotionLimits& axis) {
        return std::isfinite(axis.velocity_mm_s) || std::isfinite(axis.acceleration_mm_s2) ||
               std::isfinite(axis.jerk_mm_s3);
      });
  return any ? Scan(curve, feedrate_mm_s, limits).samples() : AxisLimitCurve{};
}

VelocityLimitCurve lower_limit_curve(const VelocityLimitCurve& limit_curve,
                                     const AxisLimitCurve& axis_limits) {
  assert(!limit_curve.empty());
  VelocityLimitCurve lower;
  const double cap =
      std::max_element(limit_curve.begin(), limit_curve.end(),
                       [](const FeedSample& a, const FeedSample& b) { return a.v_mm_s < b.v_mm_s; })
          ->v_mm_s;
  const auto turn = [&](std::size_t i) { return std::min(cap, axis_limits[i].feedrate_mm_s); };
  std::size_t c = 0;
  std::size_t t = 0;
  while (c < limit_curve.size() || t < axis_limits.size()) {
    FeedSample sample;
    if (t == axis_limits.size() ||
        (c < limit_curve.size() && limit_curve[c].s_mm <= axis_limits[t].s_mm)) {
      sample = limit_curve[c++];
      if (t > 0 && t < axis_limits.size()) {
        sample.v_mm_s = std::min(sample.v_mm_s, between(axis_limits[t - 1].s_mm, turn(t - 1),
                                                        axis_limits[t].s_mm, turn(t), sample.s_mm));
      }
    } else {
      sample = sample_at(axis_limits[t].s_mm, limit_curve, c);
      sample.v_mm_s = std::min(turn(t), sample.v_mm_s);
      ++t;
    }
    append(sample, lower);
  }
  return lower;
}

}  // namespace kerf::lookahead
