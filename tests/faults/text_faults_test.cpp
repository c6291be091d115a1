// Rows 1 to 30 of the table of faults: programs as text. README.md lists them.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "kernel/check.hpp"
#include "kernel/machine_file.hpp"
#include "parser/errors/machine.hpp"
#include "parser/program_reader.hpp"
#include "programs/program_file.hpp"
#include "programs/subprogram_folder.hpp"
#include "tests/faults/checked.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::faults {
namespace {

using parser::Move;
using parser::ProgramReader;

std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  file >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

constexpr std::size_t kMegabyte = 1'000'000;

// How much the process grows while it reads the text, given again and again.
struct Streamed {
  std::size_t grown_bytes = 0;
  std::uint64_t moves = 0;
  std::string said;
};
Streamed stream(std::string_view piece, std::size_t bytes) {
  Streamed result;
  ProgramReader reader;
  const std::size_t before = resident_bytes();
  std::size_t most = before;
  Move move;
  for (std::size_t fed = 0; fed < bytes; fed += piece.size()) {
    reader.feed(piece);
    while (reader.next(move)) {
      ++result.moves;
    }
    most = std::max(most, resident_bytes());
  }
  for (const parser::Diagnostic& diagnostic : reader.diagnostics()) {
    result.said += to_string(diagnostic, "").substr(1) + "\n";
  }
  result.grown_bytes = most - before;
  return result;
}

std::vector<Move> moves_of(std::string_view text) {
  ProgramReader reader;
  reader.feed(text);
  reader.finish();
  std::vector<Move> moves;
  for (Move move; reader.next(move);) {
    moves.push_back(move);
  }
  EXPECT_FALSE(reader.has_errors()) << reader.diagnostics().front().message;
  return moves;
}

double x_of(const Move& move) {
  return std::get<parser::LineMove>(move.shape).end_mm[0];
}

TEST(TextFaults, Row01ALineWithoutEndIsRefusedInBoundedMemory) {
  const Streamed read = stream(std::string(64 * 1024, '1'), 256 * kMegabyte);
  EXPECT_EQ(read.said,
            "1:65537: error: the line is longer than the limit of 65536 bytes [E0006]\n");
  EXPECT_LT(read.grown_bytes, 4 * kMegabyte);
}

TEST(TextFaults, Row02ALongProgramIsStreamedInConstantMemory) {
  std::string piece;
  while (piece.size() < 64 * 1024) {
    piece += "G1 X1.5 Y-2.25 F600 (" + std::string(200, 'c') + ")\nX2 Y3\n";
  }
  const Streamed read = stream(piece, 200 * kMegabyte);
  EXPECT_EQ(read.said, "");
  EXPECT_GT(read.moves, 1'000'000U);
  EXPECT_LT(read.grown_bytes, 4 * kMegabyte);
}

TEST(TextFaults, Row03NulInALineIsRefused) {
  EXPECT_EQ(said_of_block(std::string("G0 X1\0Y5", 8)),
            "1:6: error: byte 0x00 is not allowed [E0023]\n");
  EXPECT_EQ(said_of_block(std::string("G0 X1 (a\0b)", 11)),
            "1:9: error: byte 0x00 is not allowed [E0023]\n");
}

TEST(TextFaults, Row04AByteOrderMarkIsIgnoredAndUtf16IsNamed) {
  EXPECT_EQ(said_of_block("\xEF\xBB\xBFG0 X1"), "1:1: warning: byte order mark ignored [E0005]\n");
  const std::string wide("\xFF\xFEG\0000\0 \0X\0001\0\n\0", 14);
  EXPECT_TRUE(says(said_of(wide), "UTF-16"));
  EXPECT_TRUE(says(said_of(std::string("\xFE\xFF\0G\0000", 6)), "UTF-16"));
}

TEST(TextFaults, Row05OtherThanAsciiStandsInCommentsOnly) {
  EXPECT_EQ(said_of_block("G0 X1 (\xC3\xA4\xC3\xB6 \xE2\x82\xAC) ; \xC2\xA0"), "");
  EXPECT_TRUE(says(said_of_block("G0 X1 \xC3\xA4"), "(U+00E4) is not allowed"));
  EXPECT_TRUE(says(said_of_block("G0\xC2\xA0X1"), "1:3: error: bytes 0xC2 0xA0 (no-break"));
  EXPECT_TRUE(says(said_of_block("G0 X\xE2\x88\x92"
                                 "5"),
                   "is not a minus sign"));
  EXPECT_TRUE(says(said_of_block("G0 X1 \xE4"), "byte 0xE4 is not allowed"));
}

TEST(TextFaults, Row06EveryLineEndIsTheSame) {
  const std::string lines = "G0 X1\nX2\nX3\nM2";
  for (const char* const end : {"\n", "\r", "\r\n"}) {
    std::string text;
    for (const char c : lines) {
      text += c == '\n' ? end : std::string(1, c);
    }
    for (const std::string& whole : {text, text + end}) {
      EXPECT_EQ(said_of(whole), "");
      EXPECT_EQ(moves_of(whole).size(), 4U);
      EXPECT_EQ(moves_of(whole).at(2).source.line, 3U);
    }
  }
  EXPECT_EQ(moves_of("G0 X1\rX2\r\nX3\nX4").size(), 4U);
}

TEST(TextFaults, Row06CtrlZMayEndTheTextAndNotInterruptIt) {
  const std::string ignored = "byte 0x1A (Ctrl-Z) at the end of the text is ignored [E0015]\n";
  EXPECT_EQ(said_of("G0 X1\nM2\n\x1A"), "3:1: warning: " + ignored);
  EXPECT_EQ(said_of("G0 X1\nM2\x1A"), "2:3: warning: " + ignored);
  EXPECT_EQ(said_of("G0 X1\nM2\n\x1A\x1A\x1A\n"), "3:1: warning: " + ignored);
  EXPECT_TRUE(says(said_of("G0 X1\n\x1A"), "2:1: warning: " + ignored));
  EXPECT_FALSE(check("G0 X1\n\x1A").has_errors());
  EXPECT_FALSE(check("o1 if [1]\nG0 X1\no1 endif\n\x1A").has_errors());
  EXPECT_TRUE(says(said_of("G0 X1\n\x1A\nG0 X2\nM2\n"),
                   "2:1: error: byte 0x1A is not allowed: the text goes on behind it"));
  EXPECT_TRUE(says(said_of("G0 X1\x1A Y2\nM2\n"), "1:6: error: byte 0x1A is not allowed"));
}

TEST(TextFaults, Row07AnOpenOrNestedCommentIsRefused) {
  EXPECT_TRUE(says(said_of_block("G0 X1 (open"), "1:7: error: the comment opened here"));
  EXPECT_TRUE(says(said_of_block("G0 X1 (a (b) c)"), "1:10: error: '(' inside a comment"));
  EXPECT_EQ(said_of_block("G0 X1 (a ; b) Y2"), "");
  EXPECT_EQ(moves_of("G0 X1 (a ; b) Y2\nM2\n").size(), 2U);
}

TEST(TextFaults, Row08WhatFollowsTheClosingPercentIsIgnoredWithANote) {
  EXPECT_EQ(said_of("%\nG0 X1\n%\n"), "");
  EXPECT_EQ(said_of("%\nG0 X1\n%\nG0 X2 @@\n"),
            "4:1: warning: text after the closing '%' is ignored [E0010]\n");
  EXPECT_TRUE(says(said_of("%\nG0 X1\n"), "no closing '%'"));
}

TEST(TextFaults, Row09AProgramWithoutABlockIsAnError) {
  for (const char* const text : {"", "\n\n", "(only)\n; comments\n", "\x1A"}) {
    EXPECT_TRUE(says(said_of(text), "the program is empty [E0004]"));
  }
}

TEST(TextFaults, Row10HalfNumbersAreRefused) {
  for (const char* const word : {"X1.2.3", "X--1", "X.", "X", "X+-1", "X1-"}) {
    EXPECT_TRUE(check(std::string("G0 ") + word + "\nM2\n").has_errors()) << word;
    EXPECT_TRUE(says(said_of_block(std::string("G0 ") + word), "1:")) << word;
  }
}

TEST(TextFaults, Row11NoNumberIsNanOrInfiniteOrHasAnExponent) {
  for (const char* const word :
       {"Xnan", "Xinf", "X-inf", "X1e308", "X1e5", "X[1e5]", "XINFINITY"}) {
    EXPECT_TRUE(check(std::string("G0 ") + word + "\nM2\n").has_errors()) << word;
  }
  EXPECT_TRUE(says(said_of_block("G0 X1e5"), "exponent"));
}

TEST(TextFaults, Row12CoordinatesBeyondAnyMachineAreRefused) {
  EXPECT_TRUE(check("G0 X" + std::string(200, '9') + "\nM2\n").has_errors());
  EXPECT_TRUE(says(said_of_block("G0 X1000000"), "1:4: error"));
  EXPECT_TRUE(check("G20 G0 X39371\nM2\n").has_errors()) << "in inch";
  EXPECT_TRUE(check("G91\no1 repeat [3]\nG0 X900000\no1 endrepeat\nM2\n").has_errors());
}

TEST(TextFaults, Row13TinyNumbersAreZero) {
  const std::string tiny = "0." + std::string(400, '0') + "1";
  const std::vector<Move> moves =
      moves_of("G0 X1\nX" + tiny + "\nX1\nX-0\nX1\nX0." + std::string(400, '5') + "\nM2\n");
  EXPECT_EQ(x_of(moves.at(1)), 0.0);
  EXPECT_EQ(x_of(moves.at(3)), 0.0);
  EXPECT_EQ(x_of(moves.at(5)), 5.0 / 9.0);
  EXPECT_TRUE(says(said_of_block("G0 X1\nX" + tiny), "2:1: warning"));
}

TEST(TextFaults, Row14RepeatedWordsAndUnknownCodesAreRefused) {
  EXPECT_TRUE(says(said_of_block("G0 X1 X2"), "1:7: error: X is given twice"));
  EXPECT_TRUE(says(said_of_block("G0 G1 X1 F100"), "1:4: error"));
  EXPECT_TRUE(says(said_of_block("G20 G21"), "1:5: error"));
  EXPECT_TRUE(says(said_of_block("G123 X1"), "1:1: error"));
  EXPECT_TRUE(says(said_of_block("M777"), "1:1: error"));
}

TEST(TextFaults, Row15AFeedIsNeededAndOneOutOfReachIsAWarning) {
  EXPECT_TRUE(check("G1 X1\nM2\n").has_errors());
  EXPECT_TRUE(check("G1 X1 F0\nM2\n").has_errors());
  EXPECT_TRUE(check("G1 X1 F-1\nM2\n").has_errors());
  EXPECT_TRUE(check("G1 X1 F1e9\nM2\n").has_errors());
  MachineSettings machine;
  machine.limits.path.velocity_mm_s = 500.0;
  for (auto& axis : machine.limits.axes) {
    axis.velocity_mm_s = 100.0;
  }
  const std::string fast = "G0 X0.5\nG1 X1 F10393\nM2\n";  // 100 mm/s times the root of 3
  EXPECT_EQ(said_of("G0 X0.5\nG1 X1 F10392\nM2\n", {}, machine), "");
  EXPECT_TRUE(says(said_of(fast, {}, machine), "2:1: warning: a feed of 10393 mm/min"));
  EXPECT_FALSE(check(fast, {}, machine).has_errors());
  machine.limits.path.velocity_mm_s = 50.0;
  EXPECT_TRUE(
      says(said_of("G1 X1 F3001\nX2 F9999\nM2\n", {}, machine), "the machine reaches 3000 mm/min"));
  EXPECT_EQ(check("G1 X1 F3001\nX2 F9999\nM2\n", {}, machine).diagnostics.size(), 1U);
}

TEST(TextFaults, Row16InverseTimeNeedsItsFeedAndFeedPerTurnASpindle) {
  EXPECT_TRUE(says(said_of_block("G93 G1 X1 F2\nX2"), "2:1: error"));
  EXPECT_TRUE(says(said_of_block("G95 G1 X1 F0.2"), "1:"));
}

TEST(TextFaults, Row17ArcsThatAreNoneAreRefusedWithTheirRadii) {
  EXPECT_TRUE(says(said_of_block("F100 G2 X10 Y0 I4"), "start (4.000) and end (6.000)"));
  EXPECT_TRUE(says(said_of_block("F100 G2 X10 R4"), "a radius of at least 5.000 mm"));
  EXPECT_TRUE(says(said_of_block("F100 G2 X0 Y0 R4"), "cannot be a full circle"));
  EXPECT_EQ(said_of_block("F100 G2 I5"), "") << "a full circle";
  EXPECT_EQ(said_of_block("F100 G2 I5 Z3"), "") << "a helix";
  EXPECT_FALSE(check("F100 G2 X0.000000001 Y0 R1\nM2\n").has_errors()) << "a tiny arc";
  EXPECT_EQ(said_of_block("F100 G2 X10 Y0 R999999"), "") << "an arc all but straight";
}

TEST(TextFaults, Row18UnitsChangeExactly) {
  const std::vector<Move> moves =
      moves_of("G20 F10 G1 X1\nG21 X50.8\nG20 G2 X3 I0.5\nG21 X101.6 I12.7\nM2\n");
  EXPECT_EQ(x_of(moves.at(0)), 25.4);
  EXPECT_EQ(x_of(moves.at(1)), 50.8);
  EXPECT_DOUBLE_EQ(std::get<parser::ArcMove>(moves.at(2).shape).end_mm[0], 76.2);
  EXPECT_DOUBLE_EQ(std::get<parser::ArcMove>(moves.at(2).shape).centre_mm[0], 63.5);
  EXPECT_DOUBLE_EQ(std::get<parser::ArcMove>(moves.at(3).shape).centre_mm[0], 88.9);
}

TEST(TextFaults, Row19DeepBracketsAreAnErrorAndNoOverflow) {
  const std::string deep = "G0 X" + std::string(10'000, '[') + "1" + std::string(10'000, ']');
  EXPECT_TRUE(says(said_of_block(deep), "at most 64 levels"));
}

TEST(TextFaults, Row20AnExpressionIsBoundedByItsLine) {
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

TEST(TextFaults, Row21WhatHasNoValueIsAnError) {
  for (const char* const value :
       {"[1/0]", "SQRT[-1]", "ACOS[2]", "[0**-1]", "[5 MOD 0]", "LN[0]"}) {
    EXPECT_TRUE(says(said_of_block(std::string("G0 X") + value), "1:")) << value;
    EXPECT_TRUE(check(std::string("G0 X") + value + "\nM2\n").has_errors()) << value;
  }
  EXPECT_TRUE(check("G0 X[TAN[90]]\nM2\n").has_errors()) << "beyond any machine at the least";
}

TEST(TextFaults, Row22ALoopWithoutMotionIsNamedAndEnded) {
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

TEST(TextFaults, Row23ALoopOfEndlessMotionEndsWithTheTimeThatIsAllowed) {
  bool given = false;
  const CheckReport report = check_program(
      [&]() -> std::string_view {
        const bool first = !given;
        given = true;
        return first ? "o1 while [1]\nG0 X1\nG0 X0\no1 endwhile\n" : "";
      },
      default_machine(), {}, {.max_time_s = 60.0});
  ASSERT_TRUE(report.has_errors());
  EXPECT_EQ(report.diagnostics.front().page, &parser::errors::kTooLong);
  EXPECT_GT(report.diagnostics.front().source.line, 1U);
}

TEST(TextFaults, Row24EndlessRecursionIsAnError) {
  EXPECT_TRUE(says(said_of("o1 sub\no1 call\no1 endsub\no1 call\nM2\n"), "at most 32"));
}

TEST(TextFaults, Row25ASubprogramIsNeverReadFromElsewhere) {
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

TEST(TextFaults, Row26VariablesThatDoNotExistAreErrorsAndUnsetOnesWarnings) {
  EXPECT_TRUE(says(said_of_block("G0 X#<never>"), "#<never> is not set"));
  EXPECT_TRUE(says(said_of_block("#10000000=1"), "does not exist"));
  EXPECT_TRUE(says(said_of_block("#5420=1"), "read-only"));
  EXPECT_EQ(said_of_block("G0 X#100\nX#100\n#101=#100"),
            "1:5: warning: #100 was never set: it counts as 0 [E0412]\n");
}

TEST(TextFaults, Row26UnsetVariablesAreNoFlood) {
  const std::string loop = "#1=100\no1 while [#1 LT 1000]\n#2=#[#1]\n#1=[#1+1]\no1 endwhile\nG0 X1";
  EXPECT_EQ(said_of_block(loop), "3:4: warning: #100 was never set: it counts as 0 [E0412]\n");
  EXPECT_EQ(said_of_block("o1 sub\nG0 X[#1+#2]\no1 endsub\no1 call [5]"), "")
      << "what a call leaves out is 0";
  EXPECT_EQ(said_of_block("o1 if [#100 EQ 0]\n#100=5\no1 endif\nG0 X#100"),
            "1:8: warning: #100 was never set: it counts as 0 [E0412]\n");
}

TEST(TextFaults, Row26AMillionNamesAreKeptAndNoMore) {
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

TEST(TextFaults, Row27ASubprogramIsReadOnce) {
  const program::TemporaryFolder folder;
  const std::string file = (folder / "sub.ngc").string();
  std::ofstream(file) << "first";
  const auto source =
      program::subprograms_beside((folder / "main.ngc").string(), parser::Dialect::rs274);
  EXPECT_EQ(source("sub")->text, "first");
  std::ofstream(file) << "second";
  EXPECT_EQ(source("sub")->text, "first");
}

TEST(TextFaults, Row28CodesThatWouldRunProgramsAreRefused) {
  for (int code = 100; code <= 199; ++code) {
    EXPECT_TRUE(check("M" + std::to_string(code) + " P1\nM2\n").has_errors()) << code;
  }
}

TEST(TextFaults, Row29AMessageIsACommentAndNothingElse) {
  EXPECT_EQ(said_of_block("(MSG,<script>x</script>)\nG0 X1"), "");
  EXPECT_EQ(moves_of("(MSG,<script>x</script>)\nM2\n").size(), 1U);
}

TEST(TextFaults, Row29AnAbortEndsTheProgramWhereItIsReached) {
  EXPECT_EQ(said_of("G0 X1\n( abort, no probe: stop )\nG0 X2\nG0 @\nM2\n"),
            "2:1: error: the program aborts itself: no probe: stop  [E0561]\n");
  EXPECT_EQ(said_of_block("o1 if [0]\n(ABORT, never)\no1 endif\nG0 X1"), "");
  EXPECT_TRUE(says(said_of_block("o1 if [1]\n(ABORT, now)\no1 endif\nG0 X1"), "2:1: error"));
  EXPECT_EQ(said_of_block("(ABORT, x) (the last one counts)\nG0 X1 ; (ABORT, y)"), "");
  EXPECT_EQ(said_of_block("(abortive, x)\n(ABORT)\nG0 X1"), "");
}

TEST(TextFaults, Row30OnlyTextFromFilesAndPipesIsAProgram) {
  const program::TemporaryFolder folder;
  EXPECT_FALSE(program::ProgramFile::open(folder.path().string())) << "a folder";
  EXPECT_FALSE(program::ProgramFile::open("/dev/zero")) << "would never end";
  EXPECT_TRUE(says(said_of("\x1F\x8B\x08"), "[E0001]")) << "an archive is not unpacked";
}

}  // namespace
}  // namespace kerf::faults
