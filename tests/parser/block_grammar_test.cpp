#include "parser/block/block_grammar.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kerf::parser {
namespace {

bool read(std::string_view line, BlockWords& block) {
  static Parameters parameters;
  static Evaluator evaluator(parameters);
  return read_block(line, block, evaluator);
}

TEST(Block, HoldsItsWordsWithTheirPlaces) {
  const std::string line = "/N7 g1x-2.5 Y 3 (note) m3 M8 G17;rest";
  BlockWords block;
  ASSERT_TRUE(read(line, block));
  EXPECT_TRUE(block.deleted);
  EXPECT_EQ(block.value('N'), 7.0);
  EXPECT_EQ(block.value('X'), -2.5);
  EXPECT_EQ(block.text(block.word('X')), "x-2.5");
  EXPECT_EQ(block.word('X').offset, 6U);
  EXPECT_EQ(block.text(block.word('Y')), "Y 3");
  EXPECT_FALSE(block.has('Z'));
  ASSERT_EQ(block.g_count, 2);
  EXPECT_EQ(block.g[0].value, 1.0);
  EXPECT_EQ(block.g[1].value, 17.0);
  ASSERT_EQ(block.m_count, 2);
  EXPECT_EQ(block.m[1].value, 8.0);
  EXPECT_EQ(block.remark, line.find(';') + 1);
}

TEST(Block, IsEmptyWhereTheLineHasNoWords) {
  BlockWords block;
  for (const char* const line : {"", "  \t", "(only a comment)", "; rest", "/", "(a)(b) ; c"}) {
    EXPECT_TRUE(read(line, block)) << line;
    EXPECT_TRUE(block.empty()) << line;
  }
}

TEST(Block, ForgetsTheLineBefore) {
  BlockWords block;
  ASSERT_TRUE(read("N1 G1 X1 M3", block));
  ASSERT_TRUE(read("Y2", block));
  EXPECT_EQ(block.present, letter_bit('Y'));
  EXPECT_EQ(block.g_count + block.m_count, 0);
}

TEST(Block, StopsWhereTheLineIsWrongWithTheWordsBeforeIt) {
  BlockWords block;
  const std::string line = "G1 X1 Y? Z2";
  EXPECT_FALSE(read(line, block));
  EXPECT_EQ(block.stopped_at, 6U);
  EXPECT_EQ(block.present, letter_bit('X'));
}

TEST(Block, KeepsBytesOfAnyEncodingInComments) {
  BlockWords block;
  EXPECT_TRUE(read("X1 (\xE4\xF6\xFC \xC3\xA9 \x7F)", block));
  EXPECT_TRUE(read("X1 ; \xFF\x80", block));
}

TEST(Block, SurvivesEveryByteInEveryPlace) {
  const std::string good = "/N7G1X-2.5 Y 3(n)M3;r";
  BlockWords block;
  int refused = 0;
  for (std::size_t place = 0; place < good.size(); ++place) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string line = good;
      line[place] = static_cast<char>(byte);
      const bool complete = read(line, block);
      refused += complete ? 0 : 1;
      ASSERT_LE(block.stopped_at, line.size());
      ASSERT_EQ(complete, block.stopped_at == line.size());
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace kerf::parser
