// Rows 1 to 14 of the table of faults: bytes, lines and words. README.md lists them.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "parser/program_reader.hpp"
#include "tests/faults/checked.hpp"

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
  for (const diagnostics::Diagnostic& diagnostic : reader.diagnostics()) {
    result.said += to_string(diagnostic, "").substr(1) + "\n";
  }
  result.grown_bytes = most - before;
  return result;
}

// The address sanitizer keeps freed memory for a while.
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kGrowth_bytes = 256 * kMegabyte;
#else
constexpr std::size_t kGrowth_bytes = 4 * kMegabyte;
#endif

TEST(TextFaults, Row01ALineWithoutEndIsRefusedInBoundedMemory) {
  const Streamed read = stream(std::string(64 * 1024, '1'), 256 * kMegabyte);
  EXPECT_EQ(read.said,
            "1:65537: error: the line is longer than the limit of 65536 bytes [E0006]\n");
  EXPECT_LT(read.grown_bytes, kGrowth_bytes);
}

TEST(TextFaults, Row02ALongProgramIsStreamedInConstantMemory) {
  std::string piece;
  while (piece.size() < 64 * 1024) {
    piece += "G1 X1.5 Y-2.25 F600 (" + std::string(200, 'c') + ")\nX2 Y3\n";
  }
  const Streamed read = stream(piece, 200 * kMegabyte);
  EXPECT_EQ(read.said, "");
  EXPECT_GT(read.moves, 1'000'000U);
  EXPECT_LT(read.grown_bytes, kGrowth_bytes);
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
                   "2:1: error: byte 0x1A is not allowed: the text goes on after it"));
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

}  // namespace
}  // namespace kerf::faults
