#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "parser/program_reader.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

std::string moves_and_messages(const Program& program) {
  std::string text;
  for (const Move& move : program.moves) {
    text += text_of(move) + " from " + text_of(move.start_mm) + " at " +
            std::to_string(move.source.column) + '\n';
  }
  for (const diagnostics::Diagnostic& diagnostic : program.diagnostics) {
    text += to_string(diagnostic, "p") + '\n';
  }
  return text + (program.at_end ? "end" : "open");
}

TEST(ProgramReader, GivesTheSameHoweverTheTextIsCut) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  const std::filesystem::path root = std::filesystem::path(KERF_SOURCE_DIR) / "tests/parser";
  int programs = 0;
  for (const char* const folder : {"golden", "bad"}) {
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".ngc") {
        continue;
      }
      const std::string text = read_file(entry.path());
      const std::string whole = moves_and_messages(read_program(text));
      const std::size_t piece = 1 + random() % 40;
      EXPECT_EQ(moves_and_messages(read_program(text, {}, 1)), whole) << entry.path();
      EXPECT_EQ(moves_and_messages(read_program(text, {}, piece)), whole)
          << entry.path() << ' ' << piece;
      ++programs;
    }
  }
  EXPECT_GT(programs, 150);
}

TEST(ProgramReader, ReadsEveryKindOfLineEndAlike) {
  const std::string text = "G21 G90\nG0 X1\n\n(c)\nG1 Y2 F60\nM2\n";
  const std::string expected = moves_and_messages(read_program(text));
  for (const char* const line_end : {"\r\n", "\r", "\n\r"}) {
    std::string other;
    for (const char c : text) {
      other += c == '\n' ? line_end : std::string(1, c);
    }
    EXPECT_EQ(moves_and_messages(read_program(other)), expected);
  }
  EXPECT_EQ(moves_and_messages(read_program(text.substr(0, text.size() - 1))), expected);
}

TEST(ProgramReader, IgnoresCaseBlanksAndLeadingZeros) {
  const auto shapes = [](std::string_view text) {
    std::string result;
    for (const Move& move : moves_of(text)) {
      result += text_of(move) + '\n';
    }
    return result;
  };
  const std::string expected = shapes("G1 X10.5 Y-2 F600\nG2 X12.5 I1");
  EXPECT_EQ(shapes("g01x0010.500y-02.f0600\ng2x12.5i1."), expected);
  EXPECT_EQ(shapes("G 1 X 10.5 \t Y - 2 F600\nG2X12.5I+1"), expected);
}

TEST(ProgramReader, LeavesOutDeletedBlocksWhenAsked) {
  const std::string text = "/G0 X1\nG0 X2\n /G0 X3 typing error\n";
  ReaderOptions options;
  options.block_delete = BlockDelete::all();
  const Program program = read_program(text, options);
  ASSERT_EQ(program.moves.size(), 1U);
  EXPECT_EQ(std::get<LineMove>(program.moves[0].shape).end_mm[0], 2.0);
  EXPECT_FALSE(program.has_errors);
  EXPECT_TRUE(read_program(text).has_errors);
}

// A program and what comes after its switches were changed.
std::string moves_of_halves(const std::string& before, const BlockDelete& switches,
                            const std::string& behind) {
  ProgramReader reader{ReaderOptions{}};
  std::string moves;
  Move move;
  const auto fetch = [&] {
    while (reader.next(move)) {
      moves += text_of(move) + '\n';
    }
  };
  reader.feed(before);
  fetch();
  reader.set_block_delete(switches);
  reader.feed(behind);
  reader.finish();
  fetch();
  for (const auto& diagnostic : reader.diagnostics()) {
    moves += to_string(diagnostic, "p") + '\n';
  }
  return moves;
}

TEST(ProgramReader, LeavesOutStatementsAsPlainBlocksBySwitchesThatCameBeforeThem) {
  const std::string sub = "G21 G90 F600\no1 sub\nG1 Y7\no1 endsub\n";
  EXPECT_EQ(moves_of_halves(sub, BlockDelete::all(), "/o1 call\n/G1 Y3\nG1 X2\nM2\n"),
            moves_of_halves(sub, BlockDelete{}, "\n\nG1 X2\nM2\n"));
}

TEST(ProgramReader, KeepsWhatASwitchLeftOutWhereItIsReadAgain) {
  ReaderOptions options;
  options.block_delete = BlockDelete::all();
  ProgramReader reader(options);
  reader.feed("G21 G90 F600\no1 repeat [2]\n/o2 call\n/G1 Y3\nG1 X1\nG1 X2\no1 endrepeat\n");
  Move move;
  ASSERT_TRUE(reader.next(move));
  reader.set_block_delete(BlockDelete{});
  reader.feed("M2\n");
  reader.finish();
  int lines = 1;
  while (reader.next(move)) {
    if (const auto* line = std::get_if<LineMove>(&move.shape)) {
      ++lines;
      EXPECT_EQ(line->end_mm[1], 0.0);
    }
  }
  EXPECT_EQ(lines, 4);
  EXPECT_FALSE(reader.has_errors());
}

TEST(ProgramReader, RoundsCoordinatesBelowTheResolutionAndSaysSoOnce) {
  const Program program =
      read_program("G0 X1\nX0.00000000004\nG0 X-0.000000000004 Y2\nG1 X3 F0.0000000001\nM2\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(message_line(program.diagnostics[0], "p"),
            "p:2:1: warning: X: the value is below the resolution of 1e-9, rounded to 0");
  EXPECT_EQ(std::get<LineMove>(program.moves[1].shape).end_mm[0], 0.0);
}

TEST(ProgramReader, StartsWhereItIsTold) {
  ReaderOptions options;
  options.start_mm = {1, 2, 3};
  const Program program = read_program("G91 G0 X1\nM2\n", options);
  EXPECT_EQ(program.moves[0].start_mm, (Point{1, 2, 3}));
  EXPECT_EQ(std::get<LineMove>(program.moves[0].shape).end_mm, (Point{2, 2, 3}));
}

TEST(ProgramReader, IsAtTheEndOnlyAfterTheLastMove) {
  ProgramReader reader;
  reader.feed("G0 X1\nM2\nG0 X5\n");
  Move move;
  ASSERT_TRUE(reader.next(move));
  EXPECT_FALSE(reader.at_end());
  ASSERT_TRUE(reader.next(move));
  EXPECT_TRUE(reader.at_end());
  EXPECT_EQ(std::get<EventMove>(move.shape).kind, EventKind::program_end);
  EXPECT_FALSE(reader.next(move));
}

TEST(ProgramReader, WaitsForTheEndOfALine) {
  ProgramReader reader;
  Move move;
  reader.feed("G0 X1");
  EXPECT_FALSE(reader.next(move));
  reader.feed("5\n");
  ASSERT_TRUE(reader.next(move));
  EXPECT_EQ(std::get<LineMove>(move.shape).end_mm[0], 15.0);
}

TEST(ProgramReader, ReportsAHundredErrorsAndStops) {
  std::string text;
  for (int i = 0; i < 300; ++i) {
    text += "G0 X!\n";
  }
  const Program program = read_program(text);
  const auto errors = std::count_if(program.diagnostics.begin(), program.diagnostics.end(),
                                    [](const diagnostics::Diagnostic& diagnostic) {
                                      return diagnostic.severity == diagnostics::Severity::error;
                                    });
  EXPECT_EQ(errors, 100);
  EXPECT_EQ(program.diagnostics.back().message, "too many errors: the rest is not read");
  EXPECT_TRUE(program.at_end);
}

TEST(ProgramReader, ManyWarningsDoNotPileUp) {
  std::string text;
  for (int i = 0; i < 3000; ++i) {
    text += "G0 X1 " + std::to_string(i % 10) + "\n";
  }
  EXPECT_LE(read_program(text + "M2\n").diagnostics.size(), 102U);
}

TEST(ProgramReader, ReportsOneErrorForABlock) {
  const Program program = read_program("G1 X2 R3 Q4 A5 F-1\nM2\n");
  EXPECT_EQ(program.diagnostics.size(), 1U);
}

TEST(ProgramReader, GoesOnAtTheNextBlockWithTheEndPointOfTheWrongOne) {
  const Program program = read_program("F60 G0 X10 Y10\nG1 X0 Y0 R1\nG2 X2 I1\nM2\n");
  EXPECT_EQ(program.diagnostics.size(), 1U) << "the arc is right only from X0 Y0";
  EXPECT_EQ(program.diagnostics[0].source.line, 2U);
}

TEST(ProgramReader, SaysWhereALineIsTooLong) {
  const std::string text = "G0 X1\nG1 (" + std::string(70'000, 'c') + ")\nM2\n";
  const Program program = read_program(text);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(message_line(program.diagnostics[0], "f"),
            "f:2:65537: error: the line is longer than the limit of 65536 bytes");
}

}  // namespace
}  // namespace kerf::parser
