// How far a law reaches: it attains what it says, and nothing above.
#include "profiles/reach.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <kerf/axes.hpp>

#include "profiles/profile.hpp"
#include "tests/profiles/laws.hpp"

namespace kerf::profiles::test {
namespace {

constexpr RampLimits kPaper{.acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55000.0};

class ReachLaws : public ::testing::TestWithParam<Law> {
 protected:
  [[nodiscard]] const Profile& profile() const { return GetParam().profile; }
  [[nodiscard]] double both_legs_mm(const Ramp& ends, double cruise,
                                    const RampLimits& limits) const {
    return profile().fastest({ends.v_begin_mm_s, cruise}, limits).length_mm() +
           profile().fastest({cruise, ends.v_end_mm_s}, limits).length_mm();
  }
};

INSTANTIATE_TEST_SUITE_P(All, ReachLaws, ::testing::ValuesIn(all_laws()),
                         [](const auto& instance) { return instance.param.name; });

TEST_P(ReachLaws, AttainTheReachAndNothingAbove) {
  Draw draw(11);
  for (int trial = 0; trial < 5000; ++trial) {
    const RampLimits limits = draw.limits();
    const Approach approach{.v_mm_s = draw.feedrate(), .length_mm = draw.length()};
    const double reach = profile().reach_mm_s(approach, limits);
    ASSERT_GE(reach, approach.v_mm_s);
    const auto length = [&](double v) {
      return profile().fastest({approach.v_mm_s, v}, limits).length_mm();
    };
    ASSERT_LE(length(reach), approach.length_mm) << "seed " << draw.seed() << " trial " << trial;
    ASSERT_GT(length(reach * (1.0 + 1e-13)), approach.length_mm)
        << "seed " << draw.seed() << " trial " << trial << " v " << approach.v_mm_s << " L "
        << approach.length_mm;
  }
}

TEST_P(ReachLaws, StopAtTheCap) {
  Draw draw(12);
  for (int trial = 0; trial < 1000; ++trial) {
    const RampLimits limits = draw.limits();
    Approach approach{.v_mm_s = draw.feedrate(), .length_mm = draw.length()};
    const double reach = profile().reach_mm_s(approach, limits);
    approach.v_cap_mm_s = approach.v_mm_s * draw.log_uniform({1.0, 100.0}) + 1e-3;
    ASSERT_NEAR(profile().reach_mm_s(approach, limits), std::min(reach, approach.v_cap_mm_s),
                1e-13 * reach);
    ASSERT_LE(profile().reach_mm_s(approach, limits), approach.v_cap_mm_s);
  }
}

TEST_P(ReachLaws, GoNowhereWithoutLength) {
  EXPECT_EQ(profile().reach_mm_s({.v_mm_s = 0.0, .length_mm = 0.0}, kPaper), 0.0);
  EXPECT_EQ(profile().reach_mm_s({.v_mm_s = 12.0, .length_mm = 0.0}, kPaper), 12.0);
}

TEST_P(ReachLaws, AreUnboundedWhereNoLimitBinds) {
  const RampLimits none{.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = kUnbounded};
  EXPECT_EQ(profile().reach_mm_s({.v_mm_s = 1.0, .length_mm = 1.0}, none), kUnbounded);
  EXPECT_EQ(profile().reach_mm_s({.v_mm_s = 1.0, .length_mm = 1.0, .v_cap_mm_s = 50.0}, none),
            50.0);
  const Ramp ends{.v_begin_mm_s = 3.0, .v_end_mm_s = 4.0};
  EXPECT_EQ(profile().peak_mm_s(ends, {.length_mm = 1.0, .v_cap_mm_s = 60.0}, none), 60.0);
}

TEST_P(ReachLaws, HoldUnderOneLimitAlone) {
  for (const RampLimits& limits :
       {RampLimits{.acceleration_mm_s2 = 100.0, .jerk_mm_s3 = kUnbounded},
        RampLimits{.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = 1000.0}}) {
    if (!GetParam().bounds_jerk && std::isinf(limits.acceleration_mm_s2)) {
      continue;
    }
    const double reach = profile().reach_mm_s({.v_mm_s = 2.0, .length_mm = 30.0}, limits);
    EXPECT_NEAR(profile().length_mm({2.0, reach}, limits), 30.0, 1e-11);
    const Ramp ends{.v_begin_mm_s = 2.0, .v_end_mm_s = 9.0};
    const double peak =
        profile().peak_mm_s(ends, {.length_mm = 30.0, .v_cap_mm_s = kUnbounded}, limits);
    EXPECT_NEAR(both_legs_mm(ends, peak, limits), 30.0, 1e-11);
  }
}

TEST_P(ReachLaws, FillTheRoomUnderTheCruise) {
  Draw draw(13);
  for (int trial = 0; trial < 2000; ++trial) {
    const RampLimits limits = draw.limits();
    Ramp ends = draw.ramp();
    if (draw.once_in(8)) {
      ends.v_end_mm_s = ends.v_begin_mm_s;
    }
    const double direct = profile().length_mm(ends, limits);
    const double length =
        direct > 0.0 ? direct * (1.0 + draw.log_uniform({1e-9, 1e6})) : draw.length();
    const double peak =
        profile().peak_mm_s(ends, {.length_mm = length, .v_cap_mm_s = kUnbounded}, limits);
    ASSERT_GE(peak, std::max(ends.v_begin_mm_s, ends.v_end_mm_s));
    ASSERT_LE(both_legs_mm(ends, peak, limits), length)
        << "seed " << draw.seed() << " trial " << trial;
    ASSERT_GT(both_legs_mm(ends, peak * (1.0 + 1e-12), limits), length)
        << "seed " << draw.seed() << " trial " << trial << " ends " << ends.v_begin_mm_s << " "
        << ends.v_end_mm_s << " length " << length << " direct " << direct;
    const double cap = std::max({ends.v_begin_mm_s, ends.v_end_mm_s, 0.5 * peak});
    ASSERT_EQ(profile().peak_mm_s(ends, {.length_mm = length, .v_cap_mm_s = cap}, limits), cap);
  }
}

TEST_P(ReachLaws, StayAtTheFasterEndWhereOnlyTheDirectTransitionFits) {
  Draw draw(14);
  for (int trial = 0; trial < 500; ++trial) {
    const RampLimits limits = draw.limits();
    const Ramp ends = draw.ramp();
    const double faster = std::max(ends.v_begin_mm_s, ends.v_end_mm_s);
    const double direct = profile().length_mm(ends, limits);
    const double short_by_rounding = direct * (1.0 - 1e-15);
    const double peak = profile().peak_mm_s(
        ends, {.length_mm = short_by_rounding, .v_cap_mm_s = kUnbounded}, limits);
    ASSERT_EQ(peak, faster) << "seed " << draw.seed() << " trial " << trial;
  }
}

// v^2 = v0^2 + 2 A L, from textbook kinematics.
TEST(Reach, OfTheTrapezoidIsThatOfConstantAcceleration) {
  const Profile trapezoid(ProfileKind::trapezoid);
  EXPECT_DOUBLE_EQ(trapezoid.reach_mm_s({.v_mm_s = 30.0, .length_mm = 0.2}, kPaper),
                   std::sqrt(900.0 + 2.0 * 3000.0 * 0.2));
  // 2 v^2 = b^2 + e^2 + 2 A L
  EXPECT_DOUBLE_EQ(trapezoid.peak_mm_s({.v_begin_mm_s = 10.0, .v_end_mm_s = 40.0},
                                       {.length_mm = 2.0, .v_cap_mm_s = 1e6}, kPaper),
                   std::sqrt((100.0 + 1600.0 + 2.0 * 3000.0 * 2.0) / 2.0));
}

// From rest under jerk alone L = dv sqrt(dv / J), so dv = (L^2 J)^(1/3).
TEST(Reach, OfTheSCurveFromRestIsACubeRoot) {
  const Profile s_curve(ProfileKind::s_curve);
  for (const double length : {1e-9, 1e-6, 1e-3, 0.05, 1.0}) {
    const double expected = std::cbrt(length * length * kPaper.jerk_mm_s3);
    ASSERT_LT(expected, 3000.0 * 3000.0 / 55000.0);  // acceleration does not bind
    EXPECT_NEAR(s_curve.reach_mm_s({.v_mm_s = 0.0, .length_mm = length}, kPaper), expected,
                4e-15 * expected);
  }
  // A round example in which it does: A = 10, J = 10, dv = 20 takes T = 2 + 1 s, L = 10 * 3.
  EXPECT_NEAR(s_curve.reach_mm_s({.v_mm_s = 0.0, .length_mm = 30.0},
                                 {.acceleration_mm_s2 = 10.0, .jerk_mm_s3 = 10.0}),
              20.0, 1e-13);
  // And with a start in motion, v = 5: L = (5 + 10) * 3.
  EXPECT_NEAR(s_curve.reach_mm_s({.v_mm_s = 5.0, .length_mm = 45.0},
                                 {.acceleration_mm_s2 = 10.0, .jerk_mm_s3 = 10.0}),
              25.0, 1e-13);
}

}  // namespace
}  // namespace kerf::profiles::test
