// Rows 15 to 30 of the table of faults: what a program says. README.md lists them.
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/machine.hpp>

#include "diagnostics/errors/pages.hpp"
#include "parser/program_reader.hpp"
#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/io/subprogram_folder.hpp"
#include "tests/faults/checked.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::faults {
namespace {

using parser::Move;
using parser::ProgramReader;

TEST(LanguageFaults, Row15AFeedIsNeededAndOneOutOfReachIsAWarning) {
  EXPECT_TRUE(check("G1 X1\nM2\n").has_errors());
  EXPECT_TRUE(check("G1 X1 F0\nM2\n").has_errors());
  EXPECT_TRUE(check("G1 X1 F-1\nM2\n").has_errors());
  EXPECT_TRUE(check("G1 X1 F1e9\nM2\n").has_errors());
  MachineSettings machine;
  machine.limits.path.velocity_mm_s = 500.0;
  for (auto& axis : machine.limits.axes) {
    axis.velocity_mm_s = 100.0;
  }
  EXPECT_EQ(said_of("G0 X0.5\nG1 X1 F6000\nM2\n", {}, machine), "");
  EXPECT_TRUE(says(said_of("G0 X0.5\nG1 X1 F6001\nM2\n", {}, machine), "reaches 6000 mm/min"));
  const std::string fast = "G0 X0\nG1 X1 Y1 Z1 F10393\nM2\n";  // 100 mm/s times the root of 3
  EXPECT_EQ(said_of("G0 X0\nG1 X1 Y1 Z1 F10392\nM2\n", {}, machine), "");
  EXPECT_TRUE(says(said_of(fast, {}, machine), "2:1: warning: a feed of 10393 mm/min"));
  EXPECT_FALSE(check(fast, {}, machine).has_errors());
  machine.limits.path.velocity_mm_s = 50.0;
  EXPECT_TRUE(
      says(said_of("G1 X1 F3001\nX2 F9999\nM2\n", {}, machine), "the machine reaches 3000 mm/min"));
  EXPECT_EQ(check("G1 X1 F3001\nX2 F9999\nM2\n", {}, machine).diagnostics.size(), 1U);
}

TEST(LanguageFaults, Row16InverseTimeNeedsItsFeedAndFeedPerTurnASpindle) {
  EXPECT_TRUE(says(said_of_block("G93 G1 X1 F2\nX2"), "2:1: error"));
  EXPECT_TRUE(says(said_of_block("G95 G1 X1 F0.2"), "1:"));
}

TEST(LanguageFaults, Row17ArcsThatAreNoneAreRefusedWithTheirRadii) {
  EXPECT_TRUE(says(said_of_block("F100 G2 X10 Y0 I4"), "start (4.000) and end (6.000)"));
  EXPECT_TRUE(says(said_of_block("F100 G2 X10 R4"), "a radius of at least 5.000 mm"));
  EXPECT_TRUE(says(said_of_block("F100 G2 X0 Y0 R4"), "cannot be a full circle"));
  EXPECT_EQ(said_of_block("F100 G2 I5"), "") << "a full circle";
  EXPECT_EQ(said_of_block("F100 G2 I5 Z3"), "") << "a helix";
  EXPECT_FALSE(check("F100 G2 X0.000000001 Y0 R1\nM2\n").has_errors()) << "a tiny arc";
  EXPECT_EQ(said_of_block("F100 G2 X10 Y0 R999999"), "") << "an arc all but straight";
}

TEST(LanguageFaults, Row18UnitsChangeExactly) {
  const std::vector<Move> moves =
      moves_of("G20 F10 G1 X1\nG21 X50.8\nG20 G2 X3 I0.5\nG21 X101.6 I12.7\nM2\n");
  EXPECT_EQ(x_of(moves.at(0)), 25.4);
  EXPECT_EQ(x_of(moves.at(1)), 50.8);
  EXPECT_DOUBLE_EQ(std::get<parser::ArcMove>(moves.at(2).shape).end_mm[0], 76.2);
  EXPECT_DOUBLE_EQ(std::get<parser::ArcMove>(moves.at(2).shape).centre_mm[0], 63.5);
  EXPECT_DOUBLE_EQ(std::get<parser::ArcMove>(moves.at(3).shape).centre_mm[0], 88.9);
}

TEST(LanguageFaults, Row19DeepBracketsAreAnErrorAndNoOverflow) {
  const std::string deep = "G0 X" + std::string(10'000, '[') + "1" + std::string(10'000, ']');
  EXPECT_TRUE(says(said_of_block(deep), "at most 64 levels"));
}

TEST(LanguageFaults, Row20AnExpressionIsBoundedByItsLine) {
  std::string sum = "G0 X[1";
  for (int i = 0; i < 1'000'000; ++i) {
    sum += "+1";
  }
  EXPECT_TRUE(says(said_of_block(sum + "]"), "1:65537: error: the line is longer"));
  std::string fits = "G0 X[1";
  for (int i = 0; i < 30'000; ++i) {
    fits += "+1";
  }
  EXPECT_EQ(x_of(moves_of(fits + "]\nM2\n").at(0)), 30'001.0);
}

TEST(LanguageFaults, Row21WhatHasNoValueIsAnError) {
  for (const char* const value :
       {"[1/0]", "SQRT[-1]", "ACOS[2]", "[0**-1]", "[5 MOD 0]", "LN[0]"}) {
    EXPECT_TRUE(says(said_of_block(std::string("G0 X") + value), "1:")) << value;
    EXPECT_TRUE(check(std::string("G0 X") + value + "\nM2\n").has_errors()) << value;
  }
  EXPECT_TRUE(check("G0 X[TAN[90]]\nM2\n").has_errors()) << "beyond any machine at the least";
}

TEST(LanguageFaults, Row22ALoopWithoutMotionIsNamedAndEnded) {
  parser::ReaderOptions options;
  options.max_idle_steps = 100'000;
  ProgramReader reader(options);
  reader.feed("G0 X1\no1 while [1]\n#1=[#1+1]\no1 endwhile\nM2\n");
  reader.finish();
  for (Move move; reader.next(move);) {
  }
  ASSERT_TRUE(reader.has_errors());
  EXPECT_EQ(reader.diagnostics().back().source.line, 2U);
  EXPECT_TRUE(says(reader.diagnostics().back().message, "without motion"));
}

TEST(LanguageFaults, Row23ALoopOfEndlessMotionEndsWithTheTimeThatIsAllowed) {
  bool given = false;
  const CheckReport report = check_program(
      [&]() -> std::string_view {
        const bool first = !given;
        given = true;
        return first ? "o1 while [1]\nG0 X1\nG0 X0\no1 endwhile\n" : "";
      },
      default_machine(), {}, {.max_time_s = 60.0});
  ASSERT_TRUE(report.has_errors());
  EXPECT_EQ(report.diagnostics.front().page, &errors::kTooLong);
  EXPECT_GT(report.diagnostics.front().source.line, 1U);
}

TEST(LanguageFaults, Row24EndlessRecursionIsAnError) {
  EXPECT_TRUE(says(said_of("o1 sub\no1 call\no1 endsub\no1 call\nM2\n"), "at most 32"));
}

TEST(LanguageFaults, Row25ASubprogramIsNeverReadFromElsewhere) {
  const program::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "inside");
  std::ofstream(folder / "outside.ngc") << "o<outside> sub\nG0 X5\no<outside> endsub\nM2\n";
  std::ofstream(folder / "inside/real.ngc") << "o<alias> sub\nG0 X5\no<alias> endsub\nM2\n";
  std::filesystem::create_symlink("../outside.ngc", folder / "inside/outside.ngc");
  std::filesystem::create_symlink("real.ngc", folder / "inside/alias.ngc");
  KernelOptions options;
  options.subprograms =
      program::subprograms_beside((folder / "inside/main.ngc").string(), parser::Dialect::rs274);
  EXPECT_TRUE(says(said_of("o<missing> call\nM2\n", options), "o<missing> is not found"));
  EXPECT_TRUE(says(said_of("o<../outside> call\nM2\n", options), "is not found"));
  EXPECT_TRUE(says(said_of("o</etc/passwd> call\nM2\n", options), "is not found"));
  EXPECT_TRUE(says(said_of("o<outside> call\nM2\n", options),
                   "is not read: it is a symbolic link out of the program's folder [E0560]"));
  EXPECT_EQ(said_of("o<alias> call\nM2\n", options), "") << "a link within the folder";
}

TEST(LanguageFaults, Row26VariablesThatDoNotExistAreErrorsAndUnsetOnesWarnings) {
  EXPECT_TRUE(says(said_of_block("G0 X#<never>"), "#<never> is not set"));
  EXPECT_TRUE(says(said_of_block("#10000000=1"), "does not exist"));
  EXPECT_TRUE(says(said_of_block("#5420=1"), "read-only"));
  EXPECT_EQ(said_of_block("G0 X#100\nX#100\n#101=#100"),
            "1:5: warning: #100 was never set: it counts as 0 [E0412]\n");
}

TEST(LanguageFaults, Row26UnsetVariablesAreNoFlood) {
  const std::string loop = "#1=100\no1 while [#1 LT 1000]\n#2=#[#1]\n#1=[#1+1]\no1 endwhile\nG0 X1";
  EXPECT_EQ(said_of_block(loop), "3:4: warning: #100 was never set: it counts as 0 [E0412]\n");
  EXPECT_EQ(said_of_block("o1 sub\nG0 X[#1+#2]\no1 endsub\no1 call [5]"), "")
      << "what a call leaves out is 0";
  EXPECT_EQ(said_of_block("o1 if [#100 EQ 0]\n#100=5\no1 endif\nG0 X#100"),
            "1:8: warning: #100 was never set: it counts as 0 [E0412]\n");
}

TEST(LanguageFaults, Row26AMillionNamesAreKeptAndNoMore) {
  ProgramReader reader;
  std::string text;
  for (int i = 0; i <= 1'000'000; ++i) {
    text += (i % 2 == 0 ? "#<a" : "#<_b") + std::to_string(i) + ">=1\n";
  }
  reader.feed(text);
  for (Move move; reader.next(move);) {
  }
  ASSERT_EQ(reader.diagnostics().size(), 1U);
  EXPECT_EQ(reader.diagnostics().front().source.line, 1'000'001U);
}

TEST(LanguageFaults, Row27ASubprogramIsReadOnce) {
  const program::TemporaryFolder folder;
  const std::string file = (folder / "sub.ngc").string();
  std::ofstream(file) << "first";
  const auto source =
      program::subprograms_beside((folder / "main.ngc").string(), parser::Dialect::rs274);
  EXPECT_EQ(source("sub")->text, "first");
  std::ofstream(file) << "second";
  EXPECT_EQ(source("sub")->text, "first");
}

TEST(LanguageFaults, Row28CodesThatWouldRunProgramsAreRefused) {
  for (int code = 100; code <= 199; ++code) {
    EXPECT_TRUE(check("M" + std::to_string(code) + " P1\nM2\n").has_errors()) << code;
  }
}

TEST(LanguageFaults, Row29AMessageIsACommentAndNothingElse) {
  EXPECT_EQ(said_of_block("(MSG,<script>x</script>)\nG0 X1"), "");
  EXPECT_EQ(moves_of("(MSG,<script>x</script>)\nM2\n").size(), 1U);
}

TEST(LanguageFaults, Row29AnAbortEndsTheProgramWhereItIsReached) {
  EXPECT_EQ(said_of("G0 X1\n( abort, no probe: stop )\nG0 X2\nG0 @\nM2\n"),
            "2:1: error: the program aborts itself: no probe: stop  [E0561]\n");
  EXPECT_EQ(said_of_block("o1 if [0]\n(ABORT, never)\no1 endif\nG0 X1"), "");
  EXPECT_TRUE(says(said_of_block("o1 if [1]\n(ABORT, now)\no1 endif\nG0 X1"), "2:1: error"));
  EXPECT_EQ(said_of_block("(ABORT, x) (the last one counts)\nG0 X1 ; (ABORT, y)"), "");
  EXPECT_EQ(said_of_block("(abortive, x)\n(ABORT)\nG0 X1"), "");
}

TEST(LanguageFaults, Row30OnlyTextFromFilesAndPipesIsAProgram) {
  const program::TemporaryFolder folder;
  EXPECT_FALSE(program::ProgramFile::open(folder.path().string())) << "a folder";
  EXPECT_FALSE(program::ProgramFile::open("/dev/zero")) << "would never end";
  EXPECT_TRUE(says(said_of("\x1F\x8B\x08"), "[E0001]")) << "an archive is not unpacked";
}

}  // namespace
}  // namespace kerf::faults
