#include "profiles/transition.hpp"

#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"

namespace kerf::profiles::test {
namespace {

static_assert(std::is_trivially_copyable_v<Transition>);
static_assert(noexcept(Transition{}.at(0.0)));
static_assert(sizeof(Transition) <= 64);

TEST(Transition, CruisesAtConstantFeedrateOverItsLength) {
  const Transition cruise = Transition::cruise(40.0, 10.0);
  EXPECT_DOUBLE_EQ(cruise.duration_s(), 0.25);
  EXPECT_DOUBLE_EQ(cruise.length_mm(), 10.0);
  EXPECT_DOUBLE_EQ(cruise.at(0.1).s_mm, 4.0);
  EXPECT_EQ(cruise.at(0.1).v_mm_s, 40.0);
  EXPECT_EQ(cruise.at(0.1).a_mm_s2, 0.0);
  EXPECT_EQ(cruise.at(0.25).s_mm, cruise.length_mm());
}

TEST(Transition, CruisesOverNoLengthWithoutDividingByZero) {
  const Transition cruise = Transition::cruise(40.0, 0.0);
  EXPECT_EQ(cruise.duration_s(), 0.0);
  EXPECT_EQ(cruise.at(0.0).s_mm, 0.0);
  EXPECT_EQ(cruise.at(0.0).v_mm_s, 40.0);
}

TEST(Transition, SlowedDownIsAtTheSamePlacesLater) {
  const Transition ramp({.v_begin_mm_s = 20.0, .v_end_mm_s = 60.0}, 0.5, Quintic{});
  const Transition slowed = ramp.slowed(4.0);
  EXPECT_EQ(slowed.length_mm(), ramp.length_mm());
  for (const double t : {0.0, 0.1, 0.25, 0.4, 0.5}) {
    const PathMotion fast = ramp.at(t);
    const PathMotion slow = slowed.at(4.0 * t);
    EXPECT_NEAR(slow.s_mm, fast.s_mm, 1e-12);
    EXPECT_NEAR(slow.v_mm_s, fast.v_mm_s / 4.0, 1e-12);
    EXPECT_NEAR(slow.a_mm_s2, fast.a_mm_s2 / 16.0, 1e-9);
    EXPECT_NEAR(slow.j_mm_s3, fast.j_mm_s3 / 64.0, 1e-9);
  }
}

TEST(Transition, RestsForItsDuration) {
  const Transition rest = Transition::rest(3.0);
  EXPECT_EQ(rest.duration_s(), 3.0);
  EXPECT_EQ(rest.length_mm(), 0.0);
  EXPECT_EQ(rest.at(1.0).s_mm, 0.0);
  EXPECT_EQ(rest.at(1.0).v_mm_s, 0.0);
}

TEST(Transition, TakesATimeThatIsNoNumberForTheStart) {
  const Transition ramp({.v_begin_mm_s = 2.0, .v_end_mm_s = 4.0}, 1.0, Quintic{});
  const PathMotion motion = ramp.at(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(motion.v_mm_s, 2.0);
  EXPECT_EQ(motion.s_mm, 0.0);
}

// Falling to rest, the last instants are those of phi'' alone: v = |j| tau^2 / 2 with tau to go.
// Measured from the start instead, v would carry an error of 1e-14 of the feedrate at the start.
TEST(Transition, FallsToRestToFullPrecision) {
  const RampLimits limits{.acceleration_mm_s2 = 1e3, .jerk_mm_s3 = 1e4};
  const Transition fall =
      Profile{ProfileKind::s_curve}.fastest({.v_begin_mm_s = 1000.0, .v_end_mm_s = 0.0}, limits);
  const double t = fall.duration_s() * (1.0 - 0x1p-30);
  const double left_s = fall.duration_s() - t;  // exact
  EXPECT_NEAR(fall.at(t).v_mm_s / (0.5 * 1e4 * left_s * left_s), 1.0, 1e-12);
}

TEST(ProfileNames, AreReadBack) {
  using enum ProfileKind;
  for (const ProfileKind kind : {trapezoid, s_curve, sine, quintic, sine_series, sigmoid}) {
    ASSERT_TRUE(profile_kind(name_of(kind)).has_value());
    EXPECT_EQ(*profile_kind(name_of(kind)), kind);
  }
  EXPECT_EQ(name_of(s_curve), "s-curve");
  EXPECT_EQ(name_of(sine_series), "sine-series");
  EXPECT_FALSE(profile_kind("S-Curve").has_value());
  EXPECT_FALSE(profile_kind("").has_value());
}

}  // namespace
}  // namespace kerf::profiles::test
