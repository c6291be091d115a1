#include "machine/envelope.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace {

using kerf::curves::Extents;
using kerf::curves::Position;
using kerf::machine::describe;
using kerf::machine::Envelope;
using kerf::machine::kTravelToleranceMm;
using kerf::machine::outside_travel;

const Envelope kEnvelope{{{.min_mm = -300.0, .max_mm = 300.0},
                          {.min_mm = -200.0, .max_mm = 250.0},
                          {.min_mm = -100.0, .max_mm = 0.0}}};

TEST(Envelope, LetsEveryPointInsideAndOnTheLimitPass) {
  EXPECT_FALSE(outside_travel(kEnvelope, Position{0.0, 0.0, -50.0}));
  EXPECT_FALSE(outside_travel(kEnvelope, Position{300.0, -200.0, 0.0}));
  EXPECT_FALSE(outside_travel(kEnvelope, Position{300.0 + 0.9 * kTravelToleranceMm, 0.0, 0.0}));
}

TEST(Envelope, NamesTheAxisTheLimitAndByHowMuch) {
  const auto excess = outside_travel(kEnvelope, Position{0.0, -212.5, 0.0});
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->axis, 1);
  EXPECT_FALSE(excess->above);
  EXPECT_EQ(excess->limit_mm, -200.0);
  EXPECT_EQ(excess->by_mm, 12.5);
  EXPECT_EQ(describe(*excess), "y goes 12.5 mm beyond its lower limit of -200 mm");
}

TEST(Envelope, CatchesAnythingBeyondTheTolerance) {
  const auto excess = outside_travel(kEnvelope, Position{0.0, 0.0, 1.5 * kTravelToleranceMm});
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->axis, 2);
  EXPECT_TRUE(excess->above);
}

TEST(Envelope, ChoosesTheAxisThatIsFarthestOutside) {
  const auto excess = outside_travel(kEnvelope, Position{301.0, 260.0, -105.0});
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->axis, 1);
  EXPECT_TRUE(excess->above);
  EXPECT_EQ(excess->by_mm, 10.0);
}

TEST(Envelope, ChecksBothSidesOfABox) {
  EXPECT_FALSE(outside_travel(
      kEnvelope, Extents{.min_mm = {-300.0, -200.0, -100.0}, .max_mm = {300.0, 250.0, 0.0}}));
  const auto excess = outside_travel(
      kEnvelope, Extents{.min_mm = {-303.0, 0.0, -50.0}, .max_mm = {302.0, 10.0, 0.0}});
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->axis, 0);
  EXPECT_FALSE(excess->above);
  EXPECT_EQ(excess->by_mm, 3.0);
}

TEST(Envelope, WithoutTravelBoundsNothingButTakesNoNaN) {
  const Envelope open{};
  EXPECT_FALSE(outside_travel(open, Position{1e300, -1e300, 0.0}));
  const auto excess =
      outside_travel(open, Position{0.0, 0.0, std::numeric_limits<double>::quiet_NaN()});
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->axis, 2);
  EXPECT_EQ(describe(*excess), "z is not a finite number");
}

}  // namespace
