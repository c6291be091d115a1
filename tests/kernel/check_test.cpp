// A look at a program before anything moves.
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/machine.hpp>

#include "diagnostics/errors/pages.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/flow/reader_options.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

CheckReport check(const std::string& text, const MachineSettings& settings = {}) {
  bool given = false;
  return check_program(
      [&]() -> std::string_view {
        const bool first = !given;
        given = true;
        return first ? std::string_view(text) : std::string_view{};
      },
      settings);
}

MachineSettings table_of(double min_mm, double max_mm) {
  MachineSettings settings;
  for (auto& axis : settings.table.axes) {
    axis.travel = {.min_mm = min_mm, .max_mm = max_mm};
  }
  return settings;
}

TEST(Check, EndsAfterAHundredErrorsOfTheTextAndOfCurvesTogether) {
  std::string text = "G90 F100\n";
  for (int i = 0; i < 150; ++i) {
    text += i < 20 ? "X1 Q-\n" : "G92 X0 Y0\nG2 X0.01 Y0 I0.01\n";  // a centre that is the end
  }
  const CheckReport report = check(text + "M2\n");
  EXPECT_EQ(report.diagnostics.size(), 100U);
  EXPECT_EQ(report.diagnostics.back().page, &errors::kCurveRefused);
  EXPECT_EQ(report.diagnostics.back().source.line, 181U);
}

TEST(Check, FindsNothingWrongInARightProgram) {
  const CheckReport report = check(mixed_program());
  EXPECT_FALSE(report.has_errors());
  EXPECT_TRUE(report.limit_faults.empty());
  EXPECT_TRUE(report.moves);
}

TEST(Check, NamesTheLineOfEveryErrorInOrder) {
  const CheckReport report = check(
      "G21 G90 F1000\n"
      "G1 X1 @\n"
      "G1 X2\n"
      "G6.2 P3 K0 X9 Y9\n"  // not where the tool is
      "K0 X20 Y20\nK0 X30 Y0\nK1\nK1\nK1\n"
      "G1 X3\n"
      "G1 X4 X5\n"
      "M2\n");
  EXPECT_TRUE(report.has_errors());
  ASSERT_EQ(report.diagnostics.size(), 3U);
  EXPECT_EQ(report.diagnostics[0].source.line, 2U);
  EXPECT_EQ(report.diagnostics[1].source.line, 4U);
  EXPECT_EQ(report.diagnostics[2].source.line, 11U);
}

TEST(Check, ReadsInTheDialectOfTheMachineOrOfTheOptions) {
  const std::string macro = "O1\nIF [1 EQ 1] GOTO 5\nG1 X1 @\nN5 M30\n";
  EXPECT_TRUE(check(macro).has_errors());
  MachineSettings settings;
  settings.dialect = parser::Dialect::fanuc;
  EXPECT_FALSE(check(macro, settings).has_errors());
}

TEST(Check, NamesTheFileOfASubprogramThatLeavesTheTravel) {
  KernelOptions options;
  options.subprograms = [](std::string_view) {
    return parser::SubprogramText{"s.ngc", "o<s> sub\nG0 X500\no<s> endsub\n"};
  };
  bool given = false;
  const CheckReport report = check_program(
      [&]() -> std::string_view {
        const bool first = !given;
        given = true;
        return first ? "G21 G90\no<s> call\nM2\n" : "";
      },
      table_of(-100.0, 100.0), options);
  ASSERT_EQ(report.limit_faults.size(), 1U);
  EXPECT_EQ(report.limit_faults[0].file, "s.ngc");
  EXPECT_EQ(report.limit_faults[0].source.line, 2U);
}

TEST(Check, EndsWhenItIsAskedTo) {
  bool given = false;
  int asked = 0;
  check_program(
      [&]() -> std::string_view {
        const bool first = !given;
        given = true;
        return first ? "o1 while [1]\nG0 X1\nG0 X0\no1 endwhile\n" : "";
      },
      {}, {}, {.stop = [&] { return ++asked > 1000; }});
  EXPECT_EQ(asked, 1001);
}

CheckReport check_for(double max_time_s, const std::string& text) {
  bool given = false;
  MachineSettings settings;
  settings.limits.path.velocity_mm_s = 100.0;
  return check_program(
      [&]() -> std::string_view {
        return std::exchange(given, true) ? std::string_view() : std::string_view(text);
      },
      settings, {}, {.max_time_s = max_time_s});
}

TEST(Check, EndsAnEndlessLoopWithMotionAtTheBlockThatTakesItTooLong) {
  const CheckReport report =
      check_for(1000.0, "G21 G90\no1 while [1]\nG1 X10 F600\nG0 X0\no1 endwhile\n");
  ASSERT_EQ(report.diagnostics.size(), 1U);
  EXPECT_EQ(report.diagnostics[0].page, &errors::kTooLong);
  EXPECT_EQ(report.diagnostics[0].source.line, 3U);  // 1 s forth, 0.1 s back
  EXPECT_EQ(report.diagnostics[0].message,
            "up to here the program takes more than the 1000 s that are allowed");
}

// 2 micrometres a round: by its length it could go on for months.
TEST(Check, EndsAnEndlessLoopThatHardlyMovesAfterSoManyMoves) {
  const std::string text = "G21 G90 F600\no1 while [1]\nG1 X0.001\nX0\no1 endwhile\n";
  bool given = false;
  const CheckReport report = check_program(
      [&]() -> std::string_view {
        return std::exchange(given, true) ? std::string_view() : std::string_view(text);
      },
      default_machine(), {}, {.max_time_s = 3e6, .max_moves = 1000});
  ASSERT_TRUE(report.has_errors());
  EXPECT_EQ(report.diagnostics.back().page, &errors::kTooManyMoves);
  EXPECT_EQ(report.diagnostics.back().source.line, 3U);  // the 1001st move
  EXPECT_EQ(report.diagnostics.back().message,
            "up to here the program has more than the 1000 moves that are allowed");
}

TEST(Check, EndsAnEndlessLoopThatHasAnError) {
  const CheckReport report =
      check_for(1000.0, "G21 G90\no1 while [1]\nG0 X10\nG0 X0\nG1 X@\no1 endwhile\n");
  EXPECT_TRUE(report.has_errors());
}

TEST(Check, CountsDwellsAndLetsAProgramTakeAllTheTimeItMay) {
  EXPECT_FALSE(check_for(60.0, "G21 G90\nG4 P50\nG1 X10 F60\nM2\n").has_errors());
  EXPECT_TRUE(check_for(59.9, "G21 G90\nG4 P50\nG1 X10 F60\nM2\n").has_errors());
}

TEST(Check, TakesTheBulgeOfAnArcIntoTheExtents) {
  const CheckReport report = check("G21 G90 G1 X10 Y0 F600\nG3 X-10 Y0 I-10\nM2\n");
  ASSERT_TRUE(report.moves);
  EXPECT_NEAR(report.extents.max_mm[1], 10.0, 1e-12);
  EXPECT_EQ(report.extents.min_mm[0], -10.0);
  EXPECT_EQ(report.extents.max_mm[0], 10.0);
  EXPECT_EQ(report.extents.min_mm[1], 0.0);
}

TEST(Check, TakesTheBulgeOfACurveIntoTheExtents) {
  // A quadratic Bezier curve, from 0 over (5, 10) to (10, 0): its top is at y = 5.
  const CheckReport report =
      check("G21 G90\nG6.2 P3 K0 X0 Y0 F600\nK0 X5 Y10\nK0 X10 Y0\nK1\nK1\nK1\nM2\n");
  ASSERT_FALSE(report.has_errors());
  EXPECT_NEAR(report.extents.max_mm[1], 5.0, 1e-9);
}

TEST(Check, HasTheLengthOfAllMovesAsTheyAreProgrammed) {
  EXPECT_EQ(check("G1 X3 Y4 F600\nG0 X0 Y0\nG4 P2\nM2\n").length_mm, 10.0);
  EXPECT_NEAR(check("G2 X20 Y0 R10 F600\nM2\n").length_mm, 10.0 * std::acos(-1.0), 1e-12);
}

TEST(Check, SaysThatAProgramDoesNotMove) {
  const CheckReport report = check("G21 G90\nM3 S100\nG4 P1\nM2\n");
  EXPECT_FALSE(report.has_errors());
  EXPECT_FALSE(report.moves);
}

TEST(Check, NamesTheBlockThatLeavesTheTravel) {
  const CheckReport report =
      check("G21 G90 G1 X10 F600\nX30\nX0\nY-21\nY0\nM2\n", table_of(-20.0, 20.0));
  EXPECT_FALSE(report.has_errors());
  // Out, and back: both blocks are outside.
  ASSERT_EQ(report.limit_faults.size(), 4U);
  EXPECT_EQ(report.limit_faults[0].source.line, 2U);
  EXPECT_NE(report.limit_faults[0].message.find("x goes 10 mm beyond"), std::string::npos)
      << report.limit_faults[0].message;
  EXPECT_EQ(report.limit_faults[1].source.line, 3U);
  EXPECT_EQ(report.limit_faults[2].source.line, 4U);
  EXPECT_EQ(report.limit_faults[3].source.line, 5U);
}

TEST(Check, RefusesTheBadInputThatLeavesTheTravel) {
  std::ifstream file(std::string(KERF_SOURCE_DIR) +
                     "/tests/parser/bad_inputs/142_axis_soft_limit.ngc");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const CheckReport report = check(text, table_of(-300.0, 300.0));
  ASSERT_FALSE(report.limit_faults.empty());
  EXPECT_EQ(report.limit_faults[0].source.line, 5U);
}

// The greatest of the curves in bad_inputs/ that are right goes on to X310.
TEST(Check, TheDefaultTableHasRoomForALongCurve) {
  std::ifstream file(std::string(KERF_SOURCE_DIR) +
                     "/tests/parser/bad_inputs/280_nurbs_many_points.ngc");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const CheckReport report = check(text, default_machine());
  EXPECT_FALSE(report.has_errors());
  EXPECT_TRUE(report.limit_faults.empty());
}

TEST(Check, SeesAnArcThatOnlyBulgesOutOfTheTravel) {
  const std::string text = "G21 G90 G1 X18 Y0 F600\nG3 X18 Y10 J5\nG1 X0\nM2\n";
  EXPECT_TRUE(check(text, table_of(-30.0, 23.1)).limit_faults.empty());
  const CheckReport report = check(text, table_of(-30.0, 22.9));
  ASSERT_EQ(report.limit_faults.size(), 1U);
  EXPECT_EQ(report.limit_faults[0].source.line, 2U);
}

TEST(Check, ReadsTextInPiecesOfAnySize) {
  const std::string text = "G21 G90 G1 X10 F600\nG1 X20 @\nM2\n";
  std::size_t at = 0;
  const CheckReport report = check_program(
      [&]() -> std::string_view {
        const std::string_view piece =
            at < text.size() ? std::string_view(text).substr(at, 1) : std::string_view{};
        ++at;
        return piece;
      },
      MachineSettings{});
  ASSERT_EQ(report.diagnostics.size(), 1U);
  EXPECT_EQ(report.diagnostics[0].source.line, 2U);
}

// What takes a curve or a travel to be found is not.
TEST(Check, OfTheSyntaxIsOfTheTextAlone) {
  const auto syntax_of = [](std::string_view text) {
    bool first = true;
    return check_syntax([&] { return std::exchange(first, false) ? text : std::string_view(); },
                        default_machine(), {}, {.max_time_s = 1000.0});
  };
  EXPECT_TRUE(syntax_of("G21 G90\nG1 X1 F600\nG1 X@\nM2\n").has_errors());
  const std::string far = "G21 G90\nG1 X100000 F6000000\nM2\n";
  EXPECT_FALSE(check(far, default_machine()).limit_faults.empty());
  EXPECT_TRUE(syntax_of(far).limit_faults.empty());
  EXPECT_FALSE(syntax_of(far).has_errors());
  EXPECT_FALSE(syntax_of(far).moves);
  // 17 rounds of 60 s
  EXPECT_TRUE(syntax_of("o1 while [1]\nG4 P60\no1 endwhile\n").has_errors());
  EXPECT_TRUE(syntax_of("G21 G90 F600\no1 while [1]\nG1 X10\nX0\no1 endwhile\n").has_errors());
}

}  // namespace
}  // namespace kerf::test
