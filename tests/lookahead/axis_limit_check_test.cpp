// Every classical profile keeps the limits of each axis on NURBS, judged by differences of ticks.
#include "lookahead/classical/axis_limit_check.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"
#include "tests/lookahead/programs.hpp"
#include "tests/lookahead/velocity_segments.hpp"

namespace kerf::lookahead::test {
namespace {

struct LimitSet {
  MotionLimits each{};
  double chord_mm = 0.0;
};

const std::vector<LimitSet> kSets{
    {{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3}, 5e-4},
    {{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 20e3}, 1e-3},
    {{.velocity_mm_s = 200.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 30e3}, 1e-3}};

// On all axes alike, or two and three decades apart.
PlanLimits limits_of(const LimitSet& set, bool apart) {
  PlanLimits limits = axis_limits(set.each);
  limits.path.velocity_mm_s = set.each.velocity_mm_s;
  limits.chord_tolerance_mm = set.chord_mm;
  if (apart) {
    limits.axes[1].acceleration_mm_s2 *= 0.01;
    limits.axes[2].jerk_mm_s3 *= 0.001;
  }
  return limits;
}

// The largest figure of an axis over its limit, from ticks of blocks that follow each other. The
// trapezoid knows no jerk.
double largest_share(const std::vector<Block>& blocks, const PlanLimits& limits, ProfileKind kind) {
  const Motion motion = plan(blocks, {.limits = limits, .profile = Profile(kind)});
  const double ts = limits.period_s;
  std::vector<Position> ticks;
  std::size_t block = 0;
  double done_mm = 0.0;
  const auto count = static_cast<int>(std::ceil(motion.duration_s() / ts)) + 3;
  for (int i = -3; i <= count; ++i) {
    const double s = motion.at(std::clamp(i * ts, 0.0, motion.duration_s())).s_mm;
    while (block + 1 < blocks.size() && s - done_mm > blocks[block].length_mm) {
      done_mm += blocks[block++].length_mm;
    }
    ticks.push_back(curves::position_at(blocks[block].curve, s - done_mm));
  }
  double largest = 0.0;
  for (std::size_t i = 3; i < ticks.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x0 = ticks[i][k];
      const double x1 = ticks[i - 1][k];
      const double x2 = ticks[i - 2][k];
      const double x3 = ticks[i - 3][k];
      const MotionLimits& axis = limits.axes[k];
      largest = std::max({largest, std::abs(x0 - x1) / ts / axis.velocity_mm_s,
                          std::abs(x0 - 2.0 * x1 + x2) / (ts * ts) / axis.acceleration_mm_s2});
      if (kind != ProfileKind::trapezoid) {
        largest = std::max(largest,
                           std::abs(x0 - 3.0 * (x1 - x2) - x3) / (ts * ts * ts) / axis.jerk_mm_s3);
      }
    }
  }
  return largest;
}

// Of rounding: 1e-13 mm of a position is 1e-4 mm/s^3 and more.
constexpr double kStrict = 1.0 + 1e-4;

TEST(AxisLimitCheck, KeepsEachAxisOnTheReferenceCurvesWithEveryProfile) {
  std::size_t next_set = 0;
  for (const auto& [name, data] : curves::testing::shipped_curves()) {
    for (const ProfileKind kind : all_kinds()) {
      const LimitSet& set = kSets[next_set++ % kSets.size()];
      const PlanLimits limits = limits_of(set, false);
      const auto blocks = blocks_of({nurbs_move(data, set.each.velocity_mm_s)}, limits);
      EXPECT_LE(largest_share(blocks, limits, kind), kStrict)
          << name << " " << set.each.acceleration_mm_s2 << " " << profiles::name_of(kind);
    }
    ++next_set;
  }
}

// Points that march on, in three dimensions, with weights; inner knots up to degree - 1 times.
curves::NurbsData random_curve(std::mt19937_64& random, int degree) {
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const int points = degree + 1 + static_cast<int>(uniform(0.0, 12.0));
  const double size_mm = std::exp(uniform(std::log(0.05), std::log(20.0)));
  curves::NurbsData data{.degree = degree, .points = {}, .knots = {}};
  Position at{};
  for (int i = 0; i < points; ++i) {
    data.points.push_back({.position_mm = at, .weight = uniform(0.3, 3.0)});
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] += size_mm * ((k == 0 ? 0.7 : 0.0) + uniform(-0.6, 0.6));
    }
  }
  data.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
  int repeated = 0;
  for (int i = 0; i < points - degree - 1; ++i) {
    const bool repeat = i > 0 && repeated + 2 < degree && uniform(0.0, 1.0) < 0.4;
    repeated = repeat ? repeated + 1 : 0;
    data.knots.push_back(data.knots.back() + (repeat ? 0.0 : uniform(0.5, 2.0)));
  }
  data.knots.insert(data.knots.end(), static_cast<std::size_t>(degree) + 1,
                    data.knots.back() + 1.0);
  return data;
}

TEST(AxisLimitCheck, KeepsEachAxisOnRandomCurvesOfEveryDegree) {
  for (std::uint64_t seed = 1; seed <= 180; ++seed) {
    std::mt19937_64 random(seed);
    const int degree = 1 + static_cast<int>(seed % 9);
    const curves::NurbsData data = random_curve(random, degree);
    const LimitSet& set = kSets[seed % kSets.size()];
    const PlanLimits limits = limits_of(set, seed % 4 == 0);
    const auto blocks = blocks_of({nurbs_move(data, set.each.velocity_mm_s)}, limits);
    const ProfileKind kind = all_kinds()[seed / 2 % all_kinds().size()];
    EXPECT_LE(largest_share(blocks, limits, kind), kStrict)
        << "seed " << seed << " degree " << degree << " " << profiles::name_of(kind);
  }
}

// Along X, bent to Y: a made-up place without a third derivative.
TEST(AxisLimitCheck, AsksOfARampWhatTheAxisAcrossHasLeft) {
  const AxisLimitCurve axis_limits{{{.first = {1, 0, 0}, .second_per_mm = {0, 0.1, 0}}, 0.0},
                                   {{.first = {1, 0, 0}, .second_per_mm = {0, 0.1, 0}}, 100.0}};
  const Profile profile(ProfileKind::s_curve);
  const auto ramp = profile.fastest({.v_begin_mm_s = 10.0, .v_end_mm_s = 50.0},
                                    {.acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e4});
  const auto ask_at = [&](double jerk_mm_s3) {
    const MotionLimits axis{.jerk_mm_s3 = jerk_mm_s3};
    return ramp_reduction({.law = ramp}, axis_limits, {axis, axis, axis});
  };
  // Acceleration peaks at 500, where the feedrate is between 20 and 40: 3 q'' v a of Y is at most
  // 6000 there and at least 3000, and the jerk of X is 1e4.
  EXPECT_TRUE(ask_at(2e4).holds());
  const RampReduction less = ask_at(2.5e3);
  EXPECT_FALSE(less.holds());
  EXPECT_LT(less.acceleration, 1.0);
  EXPECT_GT(less.stretch, 1.0);
}

// A curve that leans alike into X and Y and turns into Y around the foot, within about a width.
struct BendCase {
  double peak_per_mm = 0.0;
  double width_mm = 0.0;

  [[nodiscard]] PathSample at(double s_mm) const {
    const double x = s_mm / width_mm;
    const double under = 1.0 + x * x;
    return {{.first = {0.7, 0.7, 0.0},
             .second_per_mm = {0.0, peak_per_mm / under, 0.0},
             .third_per_mm2 = {0.0, -2.0 * peak_per_mm * x / (width_mm * under * under), 0.0}},
            s_mm};
  }
  [[nodiscard]] AxisLimitCurve samples(double length_mm) const {
    AxisLimitCurve axis_limits;
    for (double s = 0.0; s < length_mm; s += 0.01 * std::max(width_mm, s)) {
      axis_limits.push_back(at(s));
    }
    axis_limits.push_back(at(length_mm));
    return axis_limits;
  }
};

// What Y takes of its limits at the most, in all and of curvature alone.
struct Taken {
  double acceleration_mm_s2 = 0.0;
  double curvature_acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;
  double curvature_jerk_mm_s3 = 0.0;
};

// From 5000 instants of it, close to each other at the foot.
Taken taken_of(const Transition& ramp, const BendCase& bend) {
  Taken taken;
  constexpr int kDense = 5000;
  for (int i = 0; i <= kDense; ++i) {
    const double x = static_cast<double>(i) / kDense;
    const profiles::PathMotion at = ramp.at(ramp.duration_s() * x * x);
    const PathSample curve = bend.at(at.s_mm);
    const double v = at.v_mm_s;
    const auto widen = [](double& most, double value) { most = std::max(most, std::abs(value)); };
    const double from_curvature = curve.second_per_mm[1] * v * v;
    const double third = curve.third_per_mm2[1] * v * v * v;
    widen(taken.acceleration_mm_s2, curve.first[1] * at.a_mm_s2 + from_curvature);
    widen(taken.curvature_acceleration_mm_s2, from_curvature);
    widen(taken.jerk_mm_s3,
          curve.first[1] * at.j_mm_s3 + 3.0 * curve.second_per_mm[1] * v * at.a_mm_s2 + third);
    widen(taken.curvature_jerk_mm_s3, third);
  }
  return taken;
}

// Also where the acceleration has a corner between two instants that are looked at, beside a turn
// that is much shorter than the ramp.
TEST(AxisLimitCheck, LetsNoRampPassThatTakesAllThatAnAxisHas) {
  std::mt19937_64 random(1);
  const auto log_uniform = [&random](double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  int looked_at = 0;
  for (int i = 0; i < 1000; ++i) {
    const ProfileKind kind = all_kinds()[static_cast<std::size_t>(i) % all_kinds().size()];
    SCOPED_TRACE(testing::Message() << i << " " << profiles::name_of(kind));
    const double foot_mm_s = log_uniform(1e-3, 10.0);
    const profiles::RampLimits limits{.acceleration_mm_s2 = log_uniform(1.0, 1e3),
                                      .jerk_mm_s3 = log_uniform(1e2, 1e5)};
    const Transition ramp =
        Profile(kind).fastest({.v_begin_mm_s = foot_mm_s, .v_end_mm_s = 30.0}, limits);
    const double width_mm = ramp.length_mm() * log_uniform(1e-7, 1e-1);
    // Some of the acceleration at the foot, or at the width if the ramp is faster there.
    const double squared = foot_mm_s * foot_mm_s + limits.acceleration_mm_s2 * width_mm;
    const BendCase bend{.peak_per_mm = limits.acceleration_mm_s2 * log_uniform(0.1, 3.0) / squared,
                        .width_mm = width_mm};
    const AxisLimitCurve axis_limits = bend.samples(ramp.length_mm());
    const Taken taken = taken_of(ramp, bend);
    const auto holds = [&](const MotionLimits& of_y) {
      return ramp_reduction({.law = ramp}, axis_limits, {MotionLimits{}, of_y, MotionLimits{}})
          .holds();
    };
    // Else it is not below what curvature allows.
    if (taken.curvature_acceleration_mm_s2 < 0.9 * taken.acceleration_mm_s2) {
      ++looked_at;
      EXPECT_FALSE(holds({.acceleration_mm_s2 = taken.acceleration_mm_s2}));
      EXPECT_TRUE(holds({.acceleration_mm_s2 = 1.02 * taken.acceleration_mm_s2}));
    }
    if (kind != ProfileKind::trapezoid && taken.curvature_jerk_mm_s3 < 0.7 * taken.jerk_mm_s3) {
      ++looked_at;
      EXPECT_FALSE(holds({.jerk_mm_s3 = taken.jerk_mm_s3}));
    }
  }
  EXPECT_GT(looked_at, 1000);
}

}  // namespace
}  // namespace kerf::lookahead::test
