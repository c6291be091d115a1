// When a block begins and how long it lasts, told from the plan.
#include "programs/kerf/run/block_watch.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

// Reads a program of four lines of motion of 10 mm and tells the watch of its moves.
void read_moves(BlockWatch& watch, const char* text) {
  parser::ProgramReader reader({.watcher = &watch});
  reader.feed(text);
  reader.finish();
  for (parser::Move move; reader.next(move);) {
    watch.move(move);
    if (std::holds_alternative<parser::DwellMove>(move.shape) ||
        std::holds_alternative<parser::EventMove>(move.shape)) {
      watch.rest({});
    }
  }
}

constexpr const char* kLines = "G1 X10 F600\nX20\nX30\nX40\nM2\n";

// At 10 mm/s along one curve of 40 mm, in two phases.
lookahead::Outbox one_curve_for_all() {
  lookahead::Outbox outbox;
  for (std::uint32_t i = 0; i < 4; ++i) {
    outbox.line_changes.push_back(
        {.curve = 1, .s_mm = 10.0 * i, .line = i + 1, .run_block = i + 1});
  }
  interp::Phase phase{.curve = 1,
                      .s_end_mm = 25.0,
                      .law = profiles::Transition::cruise(10.0, 25.0),
                      .line = 1,
                      .run_block = 1,
                      .has_changes = true};
  outbox.phases.push_back(phase);
  phase.begin.tick = 2500;
  phase.s_begin_mm = 25.0;
  phase.s_end_mm = 40.0;
  phase.line = 3;
  phase.run_block = 3;
  phase.law = profiles::Transition::cruise(10.0, 15.0);
  outbox.phases.push_back(phase);
  return outbox;
}

TEST(BlockWatch, FindsALineWithinACurveThatStandsForMany) {
  for (const std::uint32_t line : {1U, 2U, 3U, 4U}) {
    BlockWatch watch({.line = line});
    read_moves(watch, kLines);
    watch.planned(one_curve_for_all());
    ASSERT_TRUE(watch.begin_s()) << line;
    EXPECT_NEAR(*watch.begin_s(), line - 1.0, 1e-9) << line;
    EXPECT_NEAR(watch.duration_s(), 1.0, 1e-9) << line;
  }
}

TEST(BlockWatch, ABlockWithoutMotionBeginsWithTheNextOne) {
  BlockWatch watch({.line = 3});
  read_moves(watch, "G1 X10 F600\nX20\nG54\nX30\nX40\nM2\n");
  lookahead::Outbox outbox = one_curve_for_all();
  outbox.line_changes[2].line = 4;
  outbox.line_changes[2].run_block = 4;
  outbox.line_changes[3].line = 5;
  outbox.line_changes[3].run_block = 5;
  outbox.phases[1].line = 4;
  outbox.phases[1].run_block = 4;
  watch.planned(outbox);
  ASSERT_TRUE(watch.begin_s());
  EXPECT_NEAR(*watch.begin_s(), 2.0, 1e-9);
  EXPECT_EQ(watch.duration_s(), 0.0);
}

}  // namespace
}  // namespace kerf::program
