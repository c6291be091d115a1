#include <algorithm>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "parser/modal/machine_source.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

// The top at Z2, the sides at X10 and X20, open to the other sides; for ways along X or Z. Tool 9
// is 30 mm long.
class Block final : public AssumedMachine {
 public:
  bool has_surface() const override { return true; }
  bool touches(const ProbedWay& way) const override {
    return is_inside(way.from_mm, length_mm(way));
  }
  std::optional<Point> change_of_contact(const ProbedWay& way) const override {
    if (is_inside(way.from_mm, length_mm(way)) == is_inside(way.to_mm, length_mm(way))) {
      return std::nullopt;
    }
    const bool along_z = way.from_mm[2] != way.to_mm[2];
    Point place = way.from_mm;
    if (along_z) {
      place[2] = 2.0 + length_mm(way);
    } else {
      place[0] = std::min(way.from_mm[0], way.to_mm[0]) < 10.0 ? 10.0 : 20.0;
    }
    return place;
  }
  bool digital(std::size_t input) const override { return input == 4; }
  double analog(std::size_t input) const override { return input == 2 ? 1.5 : 0.0; }
  double spindle_time_s(double /*from_per_min*/, double /*to_per_min*/) const override {
    return 0.0;
  }

 private:
  static double length_mm(const ProbedWay& way) { return way.tool == 9 ? 30.0 : 0.0; }
  static bool is_inside(const Point& place, double length_mm) {
    return place[0] >= 10.0 && place[0] <= 20.0 && place[2] - length_mm <= 2.0;
  }
};

ReaderOptions with_block() {
  ReaderOptions options;
  options.answers.assumed = std::make_shared<const Block>();
  return options;
}

std::vector<std::string> probe_steps_of(const std::string& text) {
  const Program program = read_program(text + "\nM2\n", with_block());
  std::vector<std::string> steps;
  for (const Move& move : program.moves) {
    steps.push_back(text_of(move));
  }
  if (program.has_errors) {
    steps.push_back(to_string(program.diagnostics.front(), "p"));
  }
  return steps;
}

TEST(Probe, EndsAtRestWhereItTouchesAndKeepsThePlace) {
  const auto steps = probe_steps_of("F60 G0 X15 Z10\nG38.2 Z-5\nG0 Z[#5063 + 4]\nX#5070");
  EXPECT_EQ(steps, (std::vector<std::string>{
                       "1: rapid to 15 0 10", "2: line to 15 0 2 feed 1 exact stop",
                       "3: rapid to 15 0 6", "4: rapid to 1 0 6", "5: program end 0"}));
}

TEST(Probe, GivesThePlaceInTheCoordinatesOfTheProgram) {
  const auto steps =
      probe_steps_of("F60 G10 L2 P1 X3 Z1\nG0 X12 Z9\nG38.2 Z-5\nG0 Z8\nX#5061 Z#5063");
  EXPECT_EQ(steps.at(1), "3: line to 15 0 2 feed 1 exact stop");
  EXPECT_EQ(steps.at(3), "5: rapid to 15 0 2");
}

TEST(Probe, TouchesWithTheTipOfTheToolInTheSpindle) {
  const auto steps = probe_steps_of("F60 T9 M6\nG0 X15 Z50\nG38.2 Z-5");
  EXPECT_EQ(steps.back(), "4: program end 0");
  EXPECT_NE(std::find(steps.begin(), steps.end(), "3: line to 15 0 32 feed 1 exact stop"),
            steps.end());
}

TEST(Probe, InVainIsAnErrorOrANoughtIn5070) {
  EXPECT_EQ(probe_steps_of("F60 G38.2 X5").back(), "p:1:5: error: G38.2 met nothing [E0854]");
  EXPECT_EQ(probe_steps_of("F60 G0 X15\nG38.4 X16").back(),
            "p:2:1: error: G38.4 ended in contact [E0854]");
  const auto steps = probe_steps_of("F60 G38.3 X5\nG0 X#5070");
  EXPECT_EQ(steps.at(0), "1: line to 5 0 0 feed 1 exact stop");
  EXPECT_EQ(steps.at(1), "2: rapid to 0 0 0");
}

TEST(Probe, WithoutASurfaceSaysSo) {
  EXPECT_EQ(first_message("F60 G38.2 X5"),
            "1:5: error: G38.2 met nothing (the machine file has no [probe])");
  EXPECT_EQ(first_message("F60 G38.5 X5"),
            "1:5: error: G38.5 begins without contact (the machine file has no [probe])");
}

TEST(Probe, AwayFromContactEndsWhereItIsLost) {
  EXPECT_EQ(probe_steps_of("F60 G0 X15\nG38.4 Z9").at(1), "2: line to 15 0 2 feed 1 exact stop");
  const auto steps = probe_steps_of("F60 G0 X15 Z10\nG38.2 Z-5\nG38.4 Z9\nG0 X#5070");
  EXPECT_EQ(steps.at(2), "4: rapid to 1 0 2");
}

TEST(Probe, TowardsContactMustNotBeginThere) {
  EXPECT_EQ(probe_steps_of("F60 G0 X15\nG38.3 Z-9").back(),
            "p:2:1: error: G38.3 begins in contact [E0852]");
}

// The tool rests for each.
TEST(Probe, InputsOfTheAssumedMachineAnswerM66) {
  EXPECT_EQ(probe_steps_of("M66 P4 L0\nG0 X[#5399]").at(1), "2: rapid to 1 0 0");
  EXPECT_EQ(probe_steps_of("M66 E2\nG0 X[#5399]").at(1), "2: rapid to 1.5 0 0");
  EXPECT_EQ(probe_steps_of("M66 P4 L3 Q5\nG0 X[#5399]").at(1), "2: rapid to 1 0 0");
  EXPECT_EQ(probe_steps_of("M66 P4 L4 Q5\nG0 X[#5399]").at(1), "2: rapid to -1 0 0");
}

// Everything of the block comes out, and nothing after it is read before the answer.
TEST(Probe, WaitsForTheMachineThatIsAsked) {
  ReaderOptions options;
  options.answers.is_asked = true;
  ProgramReader reader(options);
  reader.feed("F60 G38.2 Z-5\nG91 G0 X#5063 Z1\nM2\n");
  reader.finish();
  std::vector<std::string> steps;
  Move move;
  while (reader.next(move)) {
    steps.push_back(text_of(move));
  }
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps.at(1), "1: line to 0 0 -5 feed 1 exact stop");
  ASSERT_TRUE(reader.question());
  EXPECT_FALSE(reader.at_end());
  reader.answer({.found = true, .place_mm = {0.0, 0.0, -3.0}, .rest_mm = {0.0, 0.0, -3.5}});
  ASSERT_TRUE(reader.next(move));
  EXPECT_EQ(text_of(move), "2: rapid to -3 0 -2.5");
  EXPECT_EQ(move.start_mm, (Point{0.0, 0.0, -3.5}));
}

// Views into the text that is fed go with what is fed next.
TEST(Probe, IsShownWithItsLineWhereMoreTextCameBeforeTheAnswer) {
  ReaderOptions options;
  options.answers.is_asked = true;
  ProgramReader reader(options);
  const std::string probe = "G38.2 Z-5 F60 (the top of the work)";
  reader.feed(probe + "\nG1 X1\n");
  Move move;
  while (reader.next(move)) {
  }
  ASSERT_TRUE(reader.question());
  reader.feed(std::string(1000, ' ') + "\nM2\n");
  reader.answer({.found = false});
  ASSERT_EQ(reader.diagnostics().size(), 1U);
  EXPECT_EQ(reader.diagnostics().front().block.text, probe);
}

TEST(Probe, IsAModeOfItsOwn) {
  EXPECT_EQ(probe_steps_of("F60 G38.3 X5\nX15").at(1), "2: line to 10 0 0 feed 1 exact stop");
}

// The places of moves are used again.
TEST(Probing, AndCyclesAreOverWithTheirBlock) {
  const Program program = read_program(
      "G21 G90 F600 G0 X0 Z10\nG38.3 X5\nG1 X6\nG81 X8 Z-1 R2\nG80\nG1 X9\nM2\n", with_block());
  ASSERT_FALSE(program.has_errors);
  for (const Move& move : program.moves) {
    EXPECT_EQ(move.probes, move.source.line == 2 && std::holds_alternative<LineMove>(move.shape))
        << text_of(move);
    EXPECT_EQ(move.in_cycle, move.source.line == 4) << text_of(move);
  }
}

}  // namespace
}  // namespace kerf::parser
