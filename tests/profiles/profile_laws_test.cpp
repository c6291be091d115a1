// What every feedrate law owes, whatever its formula.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <kerf/axes.hpp>

#include "profiles/profile.hpp"
#include "tests/profiles/laws.hpp"

namespace kerf::profiles::test {
namespace {

constexpr int kTrials = 300;

class ProfileLaws : public ::testing::TestWithParam<Law> {
 protected:
  [[nodiscard]] const Profile& profile() const { return GetParam().profile; }
};

INSTANTIATE_TEST_SUITE_P(All, ProfileLaws, ::testing::ValuesIn(all_laws()),
                         [](const auto& instance) { return instance.param.name; });

TEST(AllLaws, HaveEachProfileOfOneTransition) {
  const std::vector<Law> laws = all_laws();
  for (auto kind = 0U; kind < static_cast<unsigned>(ProfileKind::time_optimal); ++kind) {
    const auto is_of_kind = [kind](const Law& law) {
      return law.kind == static_cast<ProfileKind>(kind);
    };
    EXPECT_TRUE(std::any_of(laws.begin(), laws.end(), is_of_kind))
        << name_of(static_cast<ProfileKind>(kind));
  }
}

TEST_P(ProfileLaws, JoinBothFeedratesExactly) {
  Draw draw(1);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Ramp ramp = draw.ramp();
    const Transition transition = profile().fastest(ramp, draw.limits());
    if (transition.duration_s() == 0.0) {
      continue;
    }
    const PathMotion begin = transition.at(0.0);
    const PathMotion end = transition.at(transition.duration_s());
    ASSERT_EQ(begin.v_mm_s, ramp.v_begin_mm_s) << "seed " << draw.seed();
    ASSERT_EQ(begin.s_mm, 0.0);
    ASSERT_EQ(end.v_mm_s, ramp.v_end_mm_s);
    ASSERT_EQ(end.s_mm, transition.length_mm());
    if (GetParam().bounds_jerk) {
      ASSERT_EQ(begin.a_mm_s2, 0.0);
      ASSERT_EQ(end.a_mm_s2, 0.0);
    }
    ASSERT_TRUE(std::isfinite(begin.j_mm_s3) && std::isfinite(end.j_mm_s3));
  }
}

TEST_P(ProfileLaws, ClampTimesOutsideTheTransition) {
  const Transition transition = profile().fastest({.v_begin_mm_s = 5.0, .v_end_mm_s = 80.0},
                                                  {.acceleration_mm_s2 = 3e3, .jerk_mm_s3 = 55e3});
  EXPECT_EQ(transition.at(-1.0).v_mm_s, 5.0);
  EXPECT_EQ(transition.at(-1.0).s_mm, 0.0);
  EXPECT_EQ(transition.at(1e9).v_mm_s, 80.0);
  EXPECT_EQ(transition.at(1e9).s_mm, transition.length_mm());
}

// Simpson's rule over v, whose second derivative jumps at most, on 400 panels.
TEST_P(ProfileLaws, CoverTheIntegralOfTheFeedrate) {
  Draw draw(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Ramp ramp = draw.ramp();
    const Transition transition = profile().fastest(ramp, draw.limits());
    constexpr int kPanels = 400;
    const double step = transition.duration_s() / kPanels;
    const double v_max = std::max(ramp.v_begin_mm_s, ramp.v_end_mm_s);
    double sum = 0.0;
    for (int i = 0; i < kPanels; ++i) {
      const double t = i * step;
      sum += step / 6.0 *
             (transition.at(t).v_mm_s + 4.0 * transition.at(t + 0.5 * step).v_mm_s +
              transition.at(t + step).v_mm_s);
      ASSERT_NEAR(transition.at(t + step).s_mm, sum, 1e-6 * v_max * transition.duration_s())
          << "seed " << draw.seed() << " trial " << trial << " panel " << i;
    }
    ASSERT_NEAR(transition.length_mm(), sum, 1e-9 * v_max * transition.duration_s());
  }
}

// Feedrate and acceleration from central differences; jerk jumps, so it is integrated instead.
TEST_P(ProfileLaws, DifferentiateIntoEachOther) {
  const RampLimits limits{.acceleration_mm_s2 = 900.0, .jerk_mm_s3 = 4e4};
  for (const double v_end : {2.0, 30.0, 300.0}) {
    const Transition transition =
        profile().fastest({.v_begin_mm_s = 10.0, .v_end_mm_s = v_end}, limits);
    const double duration = transition.duration_s();
    const double h = 1e-5 * duration;
    for (int i = 1; i < 1000; ++i) {
      const double t = duration * (i + 0.123) / 1001.0;
      const PathMotion before = transition.at(t - h);
      const PathMotion here = transition.at(t);
      const PathMotion after = transition.at(t + h);
      ASSERT_NEAR(here.v_mm_s, (after.s_mm - before.s_mm) / (2.0 * h), 1e-5 * v_end);
      ASSERT_NEAR(here.a_mm_s2, (after.v_mm_s - before.v_mm_s) / (2.0 * h),
                  1e-4 * limits.acceleration_mm_s2);
      const double jerk = (after.a_mm_s2 - before.a_mm_s2) / (2.0 * h);
      const double low = std::min({before.j_mm_s3, here.j_mm_s3, after.j_mm_s3});
      const double high = std::max({before.j_mm_s3, here.j_mm_s3, after.j_mm_s3});
      ASSERT_GE(jerk, low - 1e-4 * limits.jerk_mm_s3) << "at t / T = " << t / duration;
      ASSERT_LE(jerk, high + 1e-4 * limits.jerk_mm_s3) << "at t / T = " << t / duration;
    }
  }
}

TEST_P(ProfileLaws, KeepTheLimitsAndUseOneOfThemUp) {
  Draw draw(3);
  for (int trial = 0; trial < kTrials; ++trial) {
    const RampLimits limits = draw.limits();
    const Ramp ramp = draw.ramp();
    const Transition transition = profile().fastest(ramp, limits);
    if (transition.duration_s() == 0.0) {
      continue;
    }
    double acceleration = 0.0;
    double jerk = 0.0;
    constexpr int kSamples = 2000;
    for (int i = 0; i <= kSamples; ++i) {
      const PathMotion motion = transition.at(transition.duration_s() * i / kSamples);
      acceleration = std::max(acceleration, std::abs(motion.a_mm_s2) / limits.acceleration_mm_s2);
      jerk = std::max(jerk, std::abs(motion.j_mm_s3) / limits.jerk_mm_s3);
      ASSERT_GE(motion.v_mm_s, std::min(ramp.v_begin_mm_s, ramp.v_end_mm_s));
      ASSERT_LE(motion.v_mm_s, std::max(ramp.v_begin_mm_s, ramp.v_end_mm_s));
      ASSERT_GE(motion.s_mm, 0.0);
      ASSERT_LE(motion.s_mm, transition.length_mm());
    }
    ASSERT_LE(acceleration, 1.0 + 1e-12) << "seed " << draw.seed() << " trial " << trial;
    if (GetParam().bounds_jerk) {
      ASSERT_LE(jerk, 1.0 + 1e-12) << "seed " << draw.seed() << " trial " << trial;
      ASSERT_GE(std::max(acceleration, jerk), 0.9999) << "trial " << trial;
    } else {
      ASSERT_GE(acceleration, 0.9999);
    }
  }
}

TEST_P(ProfileLaws, AreSymmetricAboutTheMiddle) {
  const Transition transition = profile().fastest({.v_begin_mm_s = 3.0, .v_end_mm_s = 90.0},
                                                  {.acceleration_mm_s2 = 2e3, .jerk_mm_s3 = 5e4});
  const double duration = transition.duration_s();
  for (int i = 0; i < 500; ++i) {
    const double t = duration * (i + 0.37) / 1000.0;
    const PathMotion early = transition.at(t);
    const PathMotion late = transition.at(duration - t);
    ASSERT_NEAR(early.v_mm_s + late.v_mm_s, 93.0, 1e-11);
    ASSERT_NEAR(early.a_mm_s2, late.a_mm_s2, 1e-9);
    ASSERT_NEAR(early.j_mm_s3, -late.j_mm_s3, 1e-7);
  }
}

TEST_P(ProfileLaws, MirrorWhenTheFeedratesAreSwapped) {
  Draw draw(4);
  for (int trial = 0; trial < 100; ++trial) {
    const RampLimits limits = draw.limits();
    const Ramp ramp{.v_begin_mm_s = draw.log_uniform({1e-3, 10.0}),
                    .v_end_mm_s = draw.log_uniform({11.0, 2000.0})};
    const Transition up = profile().fastest(ramp, limits);
    const Transition down = profile().fastest(
        {.v_begin_mm_s = ramp.v_end_mm_s, .v_end_mm_s = ramp.v_begin_mm_s}, limits);
    ASSERT_EQ(up.duration_s(), down.duration_s());
    ASSERT_EQ(up.reversed().ramp().v_begin_mm_s, ramp.v_end_mm_s);
    for (int i = 0; i < 20; ++i) {
      const double t = up.duration_s() * draw.uniform({0.0, 1.0});
      const PathMotion rising = up.at(t);
      for (const Transition& falling : {down, up.reversed()}) {
        const PathMotion mirror = falling.at(up.duration_s() - t);
        ASSERT_NEAR(mirror.v_mm_s, rising.v_mm_s, 1e-12 * ramp.v_end_mm_s);
        ASSERT_NEAR(mirror.s_mm, up.length_mm() - rising.s_mm, 1e-12 * up.length_mm());
        ASSERT_NEAR(mirror.a_mm_s2, -rising.a_mm_s2, 1e-9 * limits.acceleration_mm_s2);
      }
    }
  }
}

// For the trapezoid, which knows no jerk, than constant acceleration.
TEST_P(ProfileLaws, AreNeverFasterThanTheSCurve) {
  Draw draw(5);
  for (int trial = 0; trial < 5000; ++trial) {
    const RampLimits limits = draw.limits();
    const double dv = draw.log_uniform({1e-6, 2000.0});
    const double a = limits.acceleration_mm_s2;
    const double j = limits.jerk_mm_s3;
    const double s_curve = dv >= a * a / j ? dv / a + a / j : 2.0 * std::sqrt(dv / j);
    const double optimum = GetParam().bounds_jerk ? s_curve : dv / a;
    ASSERT_GE(profile().duration_s(dv, limits), optimum * (1.0 - 1e-13))
        << "seed " << draw.seed() << " trial " << trial;
    ASSERT_EQ(profile().duration_s(dv, limits), profile().duration_s(-dv, limits));
  }
}

TEST_P(ProfileLaws, TakeTheDurationThatTheyAnnounce) {
  Draw draw(6);
  for (int trial = 0; trial < kTrials; ++trial) {
    const RampLimits limits = draw.limits();
    const Ramp ramp = draw.ramp();
    const Transition transition = profile().fastest(ramp, limits);
    ASSERT_EQ(transition.duration_s(),
              profile().duration_s(ramp.v_end_mm_s - ramp.v_begin_mm_s, limits));
    ASSERT_EQ(transition.length_mm(), profile().length_mm(ramp, limits));
  }
}

TEST_P(ProfileLaws, StayConstantWhereBothFeedratesAreEqual) {
  const RampLimits limits{.acceleration_mm_s2 = 100.0, .jerk_mm_s3 = 1000.0};
  const Ramp level{.v_begin_mm_s = 7.0, .v_end_mm_s = 7.0};
  const Transition none = profile().fastest(level, limits);
  EXPECT_EQ(none.duration_s(), 0.0);
  EXPECT_EQ(none.at(0.0).v_mm_s, 7.0);
  EXPECT_EQ(none.at(0.0).s_mm, 0.0);
  const Shape shape = SineSeries{};
  const Transition held(level, 2.0, shape);
  for (const double t : {0.0, 0.5, 1.0, 1.7, 2.0}) {
    EXPECT_EQ(held.at(t).v_mm_s, 7.0);
    EXPECT_DOUBLE_EQ(held.at(t).s_mm, 7.0 * t);
    EXPECT_EQ(held.at(t).a_mm_s2, 0.0);
    EXPECT_EQ(held.at(t).j_mm_s3, 0.0);
  }
}

TEST_P(ProfileLaws, KeepTheirShapeWhenStretched) {
  const Transition fast = profile().fastest({.v_begin_mm_s = 20.0, .v_end_mm_s = 4.0},
                                            {.acceleration_mm_s2 = 700.0, .jerk_mm_s3 = 9e3});
  const Transition slow = fast.stretched(2.5);
  EXPECT_DOUBLE_EQ(slow.duration_s(), 2.5 * fast.duration_s());
  EXPECT_DOUBLE_EQ(slow.length_mm(), 2.5 * fast.length_mm());
  for (int i = 0; i <= 50; ++i) {
    const double t = fast.duration_s() * (i + 0.01) / 50.5;
    EXPECT_NEAR(slow.at(2.5 * t).v_mm_s, fast.at(t).v_mm_s, 1e-12);
    EXPECT_NEAR(slow.at(2.5 * t).a_mm_s2, fast.at(t).a_mm_s2 / 2.5, 1e-9);
    EXPECT_NEAR(slow.at(2.5 * t).j_mm_s3, fast.at(t).j_mm_s3 / 6.25, 1e-7);
  }
}

TEST_P(ProfileLaws, NeedNoTimeWhereNoLimitBinds) {
  const RampLimits none{.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = kUnbounded};
  EXPECT_EQ(profile().duration_s(100.0, none), 0.0);
  const Transition jump = profile().fastest({.v_begin_mm_s = 1.0, .v_end_mm_s = 9.0}, none);
  EXPECT_EQ(jump.duration_s(), 0.0);
  EXPECT_EQ(jump.at(0.0).v_mm_s, 9.0);
  EXPECT_TRUE(std::isfinite(jump.at(0.0).a_mm_s2) && std::isfinite(jump.at(0.0).j_mm_s3));
}

TEST_P(ProfileLaws, ObeyTheOneLimitThatBinds) {
  const RampLimits no_jerk{.acceleration_mm_s2 = 500.0, .jerk_mm_s3 = kUnbounded};
  const RampLimits no_acceleration{.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = 5e3};
  for (const RampLimits& limits : {no_jerk, no_acceleration}) {
    const Transition transition =
        profile().fastest({.v_begin_mm_s = 0.0, .v_end_mm_s = 50.0}, limits);
    ASSERT_TRUE(std::isfinite(transition.duration_s()));
    for (int i = 0; i <= 1000; ++i) {
      const PathMotion motion = transition.at(transition.duration_s() * i / 1000.0);
      ASSERT_LE(std::abs(motion.a_mm_s2), limits.acceleration_mm_s2 * (1.0 + 1e-12));
      if (GetParam().bounds_jerk) {
        ASSERT_LE(std::abs(motion.j_mm_s3), limits.jerk_mm_s3 * (1.0 + 1e-12));
      }
    }
  }
  EXPECT_GE(profile().duration_s(50.0, no_jerk), 0.1);  // dv / A
  if (GetParam().bounds_jerk) {
    EXPECT_GE(profile().duration_s(50.0, no_acceleration), 0.2);  // 2 sqrt(dv / J)
  }
}

}  // namespace
}  // namespace kerf::profiles::test
