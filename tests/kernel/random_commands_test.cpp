// Random commands at random ticks of random programs.
#include <gtest/gtest.h>

#include "tests/kernel/commanded_run.hpp"

namespace kerf::test {
namespace {

#ifdef KERF_SLOW_BUILD
constexpr std::uint64_t kRuns = 5;
#else
constexpr std::uint64_t kRuns = 100;
#endif

class RandomCommands : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomCommands, KeepLimitsPathAndEnd) {
  for (std::uint64_t i = 0; i < kRuns; ++i) {
    const std::uint64_t seed = 5'000'000 + GetParam() * kRuns + i;
    const CommandedRun run = commanded_run(seed);
    ASSERT_EQ(run.complaint, "") << "seed " << seed << ": " << run.commands;
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomCommands, testing::Range<std::uint64_t>(0, 10));

class RandomMillingCommands : public testing::TestWithParam<std::uint64_t> {};

// In blends and merged runs, at waits, in rapids and feeds a revolution.
TEST_P(RandomMillingCommands, KeepLimitsPathAndEnd) {
  for (std::uint64_t i = 0; i < kRuns / 2; ++i) {
    const std::uint64_t seed = 110'000'000 + GetParam() * kRuns + i;
    const CommandedRun run = commanded_run(seed, Commands::all, Programs::milling);
    ASSERT_EQ(run.complaint, "") << "seed " << seed << ": " << run.commands;
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomMillingCommands, testing::Range<std::uint64_t>(0, 4));

TEST(OverrideSteps, MayComeEveryTenMilliseconds) {
  for (std::uint64_t seed = 1; seed <= kRuns / 5; ++seed) {
    const CommandedRun run = commanded_run(seed, Commands::override_steps);
    ASSERT_EQ(run.complaint, "") << "seed " << seed;
  }
}

// Found by a soak: on blocks of some nanometres next to no feedrate left no place for a rest.
TEST(RandomCommandsAgain, EndOnBlocksOfNanometresAtNextToNoFeedrate) {
  for (const std::uint64_t seed : {92'013'302U, 92'014'781U}) {
    const CommandedRun run = commanded_run(seed);
    EXPECT_EQ(run.complaint, "") << "seed " << seed;
  }
}

// Held a billionth of a millimetre before a rest: 28,872 cells of 1e-13 mm, and no memory left.
TEST(RandomCommandsAgain, HoldAtACrawlBesideARest) {
  const CommandedRun run = commanded_run(6'000'505);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// A corner that the S-curve had just passed would be a stop for the time optimum that took over:
// its ticks still see the corner.
TEST(RandomCommandsAgain, ChangeThePlanRightBehindACorner) {
  const CommandedRun run = commanded_run(92'000'583);
  EXPECT_EQ(run.complaint, "") << run.commands;
  const CommandedRun steps = commanded_run(92'015'521, Commands::override_steps);
  EXPECT_EQ(steps.complaint, "") << steps.commands;
}

// A cruise that another plan had cut short was taken to go to its end there.
TEST(RandomCommandsAgain, BrakeBehindACruiseThatWasCutShort) {
  for (const std::uint64_t seed : {98'016'160U, 98'019'409U}) {
    const CommandedRun run = commanded_run(seed);
    EXPECT_EQ(run.complaint, "") << "seed " << seed << ": " << run.commands;
  }
}

// A part of the next ramp, shorter than a tick, was planned after the rest: that was taken for the
// plan's end, and the tool was left in the ramp without a way to rest.
TEST(RandomCommandsAgain, RestWherePlanningIsLateRightBehindARest) {
  const CommandedRun run = commanded_run(95'000'872);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// The time optimum that stood in was faster than the profile may be where that came back.
TEST(RandomCommandsAgain, ComeBackToTheProfileInABend) {
  const CommandedRun run = commanded_run(92'003'656);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// Stopped at the end of the last block before a rest, where rounding leaves some feedrate.
TEST(RandomCommandsAgain, StopWhereNoBlockIsLeft) {
  const CommandedRun run = commanded_run(6'001'417);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// Held at the wait of single block, which is switched off then.
TEST(RandomCommandsAgain, HoldAtAWaitThatIsNoMore) {
  const CommandedRun run = commanded_run(5'000'511);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// At the tick at which a rest ends the tool rests still, and what follows was emitted.
TEST(RandomCommandsAgain, SingleBlockWhereARestEnds) {
  const CommandedRun run = commanded_run(10'094);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// Within a spline of degree 2, a tick after the place where its curvature jumps.
TEST(RandomCommandsAgain, OverrideBehindAJumpOfCurvature) {
  const CommandedRun run = commanded_run(25'449);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// What was planned ends in motion between two ticks, and the next plan begins there, not at the
// tick.
TEST(RandomCommandsAgain, OverrideWherePlannedMotionEndsBetweenTicks) {
  const CommandedRun run = commanded_run(103'271);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// A way to rest in steps passed a knot of degree 2 faster than its jump of curvature allows.
TEST(RandomCommandsAgain, HoldBeforeAJumpOfCurvatureWithinACurve) {
  const CommandedRun run = commanded_run(5'000'582);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// Planning was late, and the way to rest that was taken leads over the end of a block.
TEST(RandomCommandsAgain, HoldOnAWayToRestOverTwoBlocks) {
  const CommandedRun run = commanded_run(30'343);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// After a stop in a hold, whose blocks are dropped: it had looked for one more way to rest.
TEST(RandomCommandsAgain, ResumeBehindAStopThatFollowsAHold) {
  const CommandedRun run = commanded_run(90'000'842);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

// A lower override comes while the tool brakes for a hold under a higher one, and then it goes on
// before it rests.
TEST(RandomCommandsAgain, OverrideInAHoldThatIsResumedBeforeItsRest) {
  const CommandedRun run = commanded_run(90'009'357);
  EXPECT_EQ(run.complaint, "") << run.commands;
}

TEST(RandomCommandsAgain, GiveTheSameTicks) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const CommandedRun one = commanded_run(seed);
    const CommandedRun two = commanded_run(seed);
    ASSERT_EQ(one.ticks, two.ticks) << "seed " << seed;
    ASSERT_EQ(one.fingerprint, two.fingerprint) << "seed " << seed;
  }
}

}  // namespace
}  // namespace kerf::test
