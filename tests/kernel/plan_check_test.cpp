// A plan that is not that of its blocks is found out.
#include "kernel/plan_check.hpp"

#include <gtest/gtest.h>

#include "curves/line.hpp"

namespace kerf {
namespace {

lookahead::Block block(double length_mm, std::uint32_t line) {
  lookahead::Block block{.curve = curves::Line::between({0, 0, 0}, {length_mm, 0, 0}).value()};
  block.line = line;
  block.length_mm = length_mm;
  block.along.feedrate_mm_s = 100.0;
  return block;
}

struct CheckedWay {
  double begin_mm = 0.0;
  double end_mm = 0.0;
};

interp::Phase phase(std::uint64_t curve, const CheckedWay& way, double path_begin_mm = 0.0) {
  return {.curve = curve,
          .s_begin_mm = way.begin_mm,
          .s_end_mm = way.end_mm,
          .path_begin_mm = path_begin_mm,
          .law = profiles::Transition::cruise(100.0, way.end_mm - way.begin_mm),
          .line = 7};
}

interp::Phase end_of_program() {
  return {.law = profiles::Transition::rest(0.0), .ends_at_rest = true, .ends_program = true};
}

std::string fault_of(const std::vector<interp::Phase>& phases, double feedrate_mm_s = 100.0) {
  PlanCheck check;
  for (const std::uint32_t line : {3U, 4U}) {
    lookahead::Block next = block(line == 3U ? 10.0 : 5.0, line);
    next.along.feedrate_mm_s = feedrate_mm_s;
    check.pushed(next);
  }
  for (const interp::Phase& phase : phases) {
    lookahead::Outbox outbox;
    outbox.phases.push_back(phase);
    check.emitted(outbox);
  }
  return check.fault() ? std::to_string(check.fault()->line) + ": " + check.fault()->what : "";
}

TEST(PlanCheck, HoldsForEveryBlockInOrderAndToItsEnd) {
  EXPECT_EQ(
      fault_of({phase(1, {0, 4}), phase(1, {4, 10}), phase(2, {0, 5}, 10.0), end_of_program()}),
      "");
}

TEST(PlanCheck, FindsABlockThatIsLeftOut) {
  EXPECT_EQ(fault_of({phase(1, {0, 10}), end_of_program()}),
            "4: the program ends at 10 mm of a block of 5 mm");
}

TEST(PlanCheck, FindsABlockThatIsLeftInTheMiddle) {
  EXPECT_NE(fault_of({phase(1, {0, 4}), phase(2, {0, 5}, 4.0)}), "");
  EXPECT_NE(fault_of({phase(1, {0, 4}), end_of_program()}), "");
}

TEST(PlanCheck, FindsAGapAndAWayBack) {
  EXPECT_NE(fault_of({phase(1, {0, 4}), phase(1, {5, 10})}), "");
  EXPECT_NE(fault_of({phase(1, {0, 4}), phase(1, {3, 10})}), "");
}

TEST(PlanCheck, FindsALawThatDoesNotCoverItsWay) {
  interp::Phase short_law = phase(1, {0, 10});
  short_law.law = profiles::Transition::cruise(100.0, 1e-16);
  EXPECT_NE(fault_of({short_law}), "");
}

TEST(PlanCheck, FindsAFeedrateAboveTheBlocks) {
  EXPECT_EQ(fault_of({phase(1, {0, 10})}, 99.0),
            "7: a feedrate of 100 mm/s is planned, above 99 mm/s");
}

TEST(PlanCheck, FindsAPathThatIsCountedWrong) {
  EXPECT_NE(fault_of({phase(1, {0, 10}), phase(2, {0, 5}, 9.5)}), "");
}

TEST(PlanCheck, FindsMotionBehindTheLastBlock) {
  EXPECT_NE(fault_of({phase(1, {0, 10}), phase(2, {0, 5}, 10.0), phase(3, {0, 5}, 15.0)}), "");
}

TEST(PlanCheck, FindsAPlanThatGoesOnAndComesNowhere) {
  std::vector<interp::Phase> phases{phase(1, {0, 4})};
  phases.resize(2000, phase(1, {4, 4}));
  EXPECT_NE(fault_of(phases), "");
}

// The way to rest from where the first plan has come to.
std::string fault_of_takeover(const interp::Phase& planned, const interp::Phase& takes_over) {
  PlanCheck check;
  check.pushed(block(10.0, 3));
  check.pushed(block(5.0, 4));
  lookahead::Outbox outbox;
  outbox.phases = {planned};
  check.emitted(outbox);
  check.taken_over();
  outbox.phases = {takes_over};
  check.emitted(outbox);
  return check.fault() ? check.fault()->what : "";
}

TEST(PlanCheck, LetsAPlanTakeOverAtTheBeginOfABlockBehindOneThatIsPlannedToItsEnd) {
  EXPECT_EQ(fault_of_takeover(phase(1, {0, 10}), phase(2, {0, 2}, 10.0)), "");
  EXPECT_NE(fault_of_takeover(phase(1, {0, 9}), phase(2, {0, 2}, 10.0)), "");
  EXPECT_NE(fault_of_takeover(phase(1, {0, 10}), phase(2, {1, 2}, 10.0)), "");
  EXPECT_NE(fault_of_takeover(phase(1, {0, 10}), phase(2, {0, 2}, 9.0)), "");
  EXPECT_NE(fault_of_takeover(phase(1, {0, 10}), phase(3, {0, 2}, 10.0)), "");
}

TEST(PlanCheck, LetsAStoppedProgramEndWhereItIs) {
  PlanCheck check;
  check.pushed(block(10.0, 3));
  lookahead::Outbox outbox;
  outbox.phases = {phase(1, {0, 4}), end_of_program()};
  check.stop();
  check.emitted(outbox);
  EXPECT_FALSE(check.fault());
}

TEST(PlanCheck, FindsADeviationAboveItsTolerance) {
  PlanCheck check;
  check.judge({.distance_mm = 0.0101, .line = 12, .tolerance_mm = 0.01});
  ASSERT_TRUE(check.fault());
  EXPECT_EQ(check.fault()->line, 12U);
}

}  // namespace
}  // namespace kerf
