// The text of a part program means the path that is kept beside it.
#include "bench/part_programs.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "parser/program_reader.hpp"

namespace kerf::bench {
namespace {

void expect_text_means_path(const PartProgram& program) {
  parser::ProgramReader reader({.start_mm = program.start_mm});
  reader.feed("G21 G90 G17 G94 G64 P0.01 F600\n");
  reader.feed(program.body);
  reader.finish();
  std::size_t next = 0;
  for (parser::Move move; reader.next(move);) {
    if (std::holds_alternative<parser::EventMove>(move.shape)) {
      continue;
    }
    while (next < program.path.size() && program.path[next].length_mm() == 0.0) {
      ++next;  // no move
    }
    ASSERT_LT(next, program.path.size());
    const PathElement& element = program.path[next++];
    ASSERT_EQ(move.source.line, element.line);
    ASSERT_EQ(move.start_mm, element.from_mm);
    if (const auto* arc = std::get_if<parser::ArcMove>(&move.shape)) {
      ASSERT_EQ(arc->end_mm, element.to_mm);
      ASSERT_EQ(arc->clockwise, element.sweep_rad < 0.0);
      ASSERT_NEAR(arc->centre_mm[0], element.centre_mm[0], 1e-12);
      ASSERT_NEAR(arc->centre_mm[1], element.centre_mm[1], 1e-12);
      ASSERT_LT(distance_mm(element.at(0.0), element.from_mm), 1e-9);
      ASSERT_LT(distance_mm(element.at(1.0), element.to_mm), 1e-9);
    } else {
      ASSERT_EQ(std::get<parser::LineMove>(move.shape).end_mm, element.to_mm);
    }
  }
  EXPECT_EQ(next, program.path.size());
  EXPECT_FALSE(reader.has_errors());
}

TEST(PartPrograms, MeanThePathThatIsKeptBesideThem) {
  expect_text_means_path(raster(2000));
  expect_text_means_path(flower(3));
  expect_text_means_path(flower(6));
  expect_text_means_path(straight(200.0, 1000));
  expect_text_means_path(square(100.0));
  expect_text_means_path(spiral({.lines = 500}));
  expect_text_means_path(engraving());
  expect_text_means_path(pocket());
  expect_text_means_path(small_loops(20));
}

TEST(PartPrograms, TakeStepsOfTheLengthThatIsAsked) {
  for (const PathElement& element : flower(6).path) {
    ASSERT_NEAR(element.length_mm(), 0.1, 1e-4);
  }
  const PartProgram turns = spiral({});
  ASSERT_EQ(turns.path.size(), 50'000U);
  for (const PathElement& element : turns.path) {
    ASSERT_NEAR(element.length_mm(), 0.1, 3e-4);
  }
  EXPECT_NEAR(std::hypot(turns.path.back().to_mm[0], turns.path.back().to_mm[1]), 40.0, 0.05);
}

TEST(PartPrograms, HaveTheRasterOfItsLinesWithItsStepsBetweenRows) {
  const PartProgram program = raster(10'000);
  ASSERT_EQ(program.path.size(), 10'000U);
  EXPECT_EQ(program.path[500].from_mm[0], 100.0);
  EXPECT_EQ(program.path[500].to_mm[0], 100.0);
  EXPECT_EQ(program.path[500].to_mm[1], 0.2);
  EXPECT_EQ(program.path[501].to_mm[0], 99.8);
}

}  // namespace
}  // namespace kerf::bench
