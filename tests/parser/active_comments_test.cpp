// What a program tells the operator in its comments, and to which block it belongs.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

struct Told {
  std::string text;
  std::uint32_t line = 0;
  std::size_t moves_before = 0;  // whose block comes before that of the message
};

std::vector<Told> told_by(const std::string& text, ReaderOptions options = {}) {
  options.keeps_messages = true;
  ProgramReader reader(options);
  reader.feed(text);
  reader.finish();
  std::vector<NumberedMessage> messages;
  std::vector<Move> moves;
  for (Move move;;) {
    const bool read = reader.next(move);
    messages.insert(messages.end(), reader.messages().begin(), reader.messages().end());
    if (!read) {
      break;
    }
    moves.push_back(move);
  }
  EXPECT_FALSE(reader.has_errors()) << text;
  std::vector<Told> told;
  for (const NumberedMessage& numbered : messages) {
    told.push_back({.text = numbered.message.text, .line = numbered.message.line});
    for (const Move& move : moves) {
      told.back().moves_before += move.block < numbered.block ? 1 : 0;
    }
  }
  return told;
}

void expect_told(const std::string& text, const std::vector<std::string>& expected) {
  std::vector<std::string> texts;
  for (const Told& told : told_by(text)) {
    texts.push_back(told.text);
  }
  EXPECT_EQ(texts, expected) << text;
}

TEST(ActiveComments, AreToldWithoutWhatIsAroundThem) {
  expect_told("(MSG, change the tool)\nM2\n", {"change the tool"});
  expect_told("( m S g ,\tA, b  )\nM2\n", {"A, b  "});
  expect_told("(print,x)(a plain one)\nM2\n", {});
  expect_told("G21 (a plain one) (debug,x)\nM2\n", {"x"});
  expect_told("(MSG)\n(MSGS, x)\n(message, x)\n; (MSG, x)\nM2\n", {});
}

TEST(ActiveComments, WriteVariablesAsNumbersOfSixDecimals) {
  expect_told("#1=1.5 #<a b>=-2\n(DEBUG, #1 and #<a b>mm, #[1])\nM2\n",
              {"1.500000 and -2.000000mm, 1.500000"});
  expect_told("#1=1\n(PRINT, #1)\n#1=2\n(PRINT, #1)\nM2\n", {"1.000000", "2.000000"});
  expect_told("(PRINT, #<never_set> #)\nM2\n", {"###### ######"});
  expect_told("(MSG, #1 as written)\nM2\n", {"#1 as written"});
}

// LinuxCNC assigns once a block is read, and a comment speaks when it is carried out.
TEST(ActiveComments, SeeTheAssignmentsOfTheirOwnBlock) {
  expect_told("#1=1\n#1=2 (PRINT, #1)\nG1 X#1 F100 (PRINT, #1)\nM2\n", {"2.000000", "2.000000"});
}

TEST(ActiveComments, BelongBeforeTheBlockTheyStandInOrTheNext) {
  const auto told =
      told_by("(MSG, a)\nG1 X1 F100\nX2 (MSG, b)\n(MSG, c)\nM0 (MSG, d)\n(MSG, e)\nM2\n(MSG, f)\n");
  ASSERT_EQ(told.size(), 5);
  const std::vector<std::size_t> before{0, 1, 2, 2, 3};
  const std::vector<std::uint32_t> lines{1, 3, 4, 5, 6};
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].moves_before, before[i]) << told[i].text;
    EXPECT_EQ(told[i].line, lines[i]) << told[i].text;
  }
}

TEST(ActiveComments, AreToldInEachTurnOfALoop) {
  expect_told("#1=0\no1 while [#1 LT 3]\n(PRINT, #1)\nG1 X#1 F100\n#1=[#1+1]\no1 endwhile\nM2\n",
              {"0.000000", "1.000000", "2.000000"});
}

TEST(ActiveComments, AreCommentsInTheFanucDialectAndWhereNobodyAsks) {
  EXPECT_TRUE(told_by("G21(MSG, a)\nM30\n", {.dialect = Dialect::fanuc}).empty());
  ProgramReader reader;
  reader.feed("(MSG, a)\nM2\n");
  reader.finish();
  Move move;
  while (reader.next(move)) {
    EXPECT_TRUE(reader.messages().empty());
  }
}

}  // namespace
}  // namespace kerf::parser
