// Lines of the program on a block that stands for many of them, from the plan to the tick.
#include <memory>

#include <gtest/gtest.h>

#include "interp/interpolator.hpp"
#include "lookahead/path/block.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr ProfileKind kBothKinds[] = {ProfileKind::time_optimal, ProfileKind::s_curve};

// A row of lines, an arc and a curve, of which the first and the last stand for many lines.
std::vector<Block> marked_blocks() {
  const curves::NurbsData curve = curves::testing::shipped_curve("rational4");
  const Position begin = curve.points.front().position_mm;
  const Position from{begin[0] - 60.0, begin[1], begin[2]};
  std::vector<Block> blocks =
      blocks_of({line_move({from, begin}, 80.0), nurbs_move(curve, 60.0)}, mill());
  blocks[0].line = 10;
  blocks[0].marks = {{.s_mm = 0.0, .line = 10, .run_block = 1},
                     {.s_mm = 20.0, .line = 11, .run_block = 2},
                     {.s_mm = 20.001, .line = 12, .run_block = 3},
                     {.s_mm = 59.5, .line = 13, .run_block = 4}};
  const double length = blocks[1].length_mm;
  for (std::uint32_t i = 0; i < 100; ++i) {
    blocks[1].marks.push_back({.s_mm = length * i / 100.0, .line = 20 + i, .run_block = 5 + i});
  }
  blocks[1].line = 20;
  return blocks;
}

TEST(LineMarks, APlaceBelongsToTheMarkBeforeIt) {
  const Block block = marked_blocks().front();
  EXPECT_EQ(block.mark_at(0.0).line, 10U);
  EXPECT_EQ(block.mark_at(19.999).line, 10U);
  EXPECT_EQ(block.mark_at(20.0).line, 11U);
  EXPECT_EQ(block.mark_at(20.0005).s_mm, 20.0);
  EXPECT_EQ(block.mark_at(60.0).line, 13U);
  EXPECT_EQ(block.mark_at(60.0).run_block, 4U);
}

TEST(LineMarks, WithoutMarksABlockIsOfOneLine) {
  Block block = marked_blocks().front();
  block.marks.clear();
  block.run_block = 8;
  EXPECT_EQ(block.mark_at(30.0).line, 10U);
  EXPECT_EQ(block.mark_at(30.0).run_block, 8U);
  EXPECT_EQ(block.mark_at(30.0).s_mm, 0.0);
}

TEST(LineMarks, APhaseIsOfTheLineWhereItBegins) {
  for (const ProfileKind kind : kBothKinds) {
    const std::vector<Block> blocks = marked_blocks();
    Planner planner({.limits = mill(), .profile = Profile{kind}});
    for (const interp::Phase& phase : run(planner, blocks).phases) {
      if (phase.run_block != 0) {
        const LineMark mark = blocks[phase.curve - 1].mark_at(phase.s_begin_mm);
        EXPECT_EQ(phase.line, mark.line);
        EXPECT_EQ(phase.run_block, mark.run_block);
      }
    }
  }
}

TEST(LineMarks, EveryTickIsOfTheLineAtItsPlace) {
  for (const ProfileKind kind : kBothKinds) {
    const std::vector<Block> blocks = marked_blocks();
    Planner planner({.limits = mill(), .profile = Profile{kind}});
    const Outbox outbox = run(planner, blocks);
    const auto queue = std::make_unique<interp::MotionQueue>();
    for (const interp::CurvePiece& piece : outbox.pieces) {
      ASSERT_TRUE(queue->push(piece));
    }
    for (const interp::LineChange& change : outbox.line_changes) {
      ASSERT_TRUE(queue->push(change));
    }
    for (const interp::Phase& phase : outbox.phases) {
      ASSERT_TRUE(queue->push(phase));
    }
    queue->commit();
    interp::Interpolator interpolator(*queue, kTs, {});
    interp::Setpoint setpoint;
    while (interpolator.next(setpoint) == interp::TickStatus::running) {
      const bool first = setpoint.s_mm < blocks[0].length_mm;
      const double s = setpoint.s_mm - (first ? 0.0 : blocks[0].length_mm);
      const LineMark before = blocks[first ? 0 : 1].mark_at(std::max(s - 1e-9, 0.0));
      const LineMark after = blocks[first ? 0 : 1].mark_at(s + 1e-9);
      ASSERT_TRUE(setpoint.line == before.line || setpoint.line == after.line) << setpoint.s_mm;
    }
    EXPECT_EQ(setpoint.line, 99U) << "the end is of the line that ends the program";
  }
}

TEST(LineMarks, AStopOnTheWayIsOfTheLineWhereItEnds) {
  for (const ProfileKind kind : kBothKinds) {
    const std::vector<Block> blocks = marked_blocks();
    Planner planner({.limits = mill(), .profile = Profile{kind}, .may_hold = true});
    for (const Block& block : blocks) {
      planner.push(Block(block));
    }
    planner.plan_to_rest();
    Outbox outbox;
    while (outbox.phases.empty() || outbox.phases.back().s_end_mm < 15.0) {
      ASSERT_TRUE(planner.emit(outbox));
    }
    Outbox stop;
    ASSERT_TRUE(planner.stop({.tick = outbox.phases.back().begin.tick}, stop));
    const interp::Phase& rest = stop.phases.back();
    ASSERT_TRUE(rest.ends_program);
    EXPECT_EQ(rest.line, blocks[rest.curve - 1].mark_at(rest.s_begin_mm).line);
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
