#include "parser/text/line_splitter.hpp"

#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::parser {
namespace {

struct Found {
  std::string text;
  std::uint32_t number;
  bool operator==(const Found&) const = default;
};
void PrintTo(const Found& found, std::ostream* out) {
  *out << found.number << ':' << found.text.substr(0, 20);
}

std::vector<Found> split(const std::string& text, std::size_t piece) {
  LineSplitter splitter;
  std::vector<Found> found;
  NumberedLine line;
  const auto fetch = [&] {
    while (splitter.next(line)) {
      found.push_back({line.too_long ? "too long" : std::string(line.text), line.number});
    }
  };
  for (std::size_t at = 0; at < text.size(); at += piece) {
    splitter.feed(std::string_view(text).substr(at, piece));
    fetch();
  }
  splitter.finish();
  fetch();
  return found;
}

class Pieces : public testing::TestWithParam<std::size_t> {};

TEST_P(Pieces, EveryLineEndCountsOnce) {
  const std::vector<Found> lines{{"a", 1}, {"b", 2}, {"", 3}, {"c", 4}};
  EXPECT_EQ(split("a\nb\n\nc", GetParam()), lines);
  EXPECT_EQ(split("a\rb\r\rc\r", GetParam()), lines);
  EXPECT_EQ(split("a\r\nb\r\n\r\nc\r\n", GetParam()), lines);
  EXPECT_EQ(split("a\n\rb\n\r\n\rc\n\r", GetParam()), lines);
  EXPECT_EQ(split("a\r\nb\n\rc\rd", GetParam()),
            (std::vector<Found>{{"a", 1}, {"b", 2}, {"c", 3}, {"d", 4}}));
  EXPECT_EQ(split("a\n\r\nb", GetParam()), (std::vector<Found>{{"a", 1}, {"", 2}, {"b", 3}}));
}

TEST_P(Pieces, ALineThatIsTooLongIsSaidOnceAndReadingGoesOn) {
  const std::string text = "a\n" + std::string(LineSplitter::kMaxLine + 1, 'x') + "\r\nb";
  EXPECT_EQ(split(text, GetParam()), (std::vector<Found>{{"a", 1}, {"too long", 2}, {"b", 3}}));
  const std::string fits(LineSplitter::kMaxLine, 'x');
  EXPECT_EQ(split(fits + "\nb", GetParam()), (std::vector<Found>{{fits, 1}, {"b", 2}}));
}

INSTANTIATE_TEST_SUITE_P(Of, Pieces, testing::Values(1, 2, 3, 7, 4096, 1'000'000));

TEST(LineSplitter, HoldsNoMoreThanALineOfALineThatNeverEnds) {
  LineSplitter splitter;
  NumberedLine line;
  const std::string piece(1 << 16, 'x');
  int lines = 0;
  for (int i = 0; i < 1000; ++i) {
    splitter.feed(piece);
    while (splitter.next(line)) {
      ++lines;
      EXPECT_TRUE(line.too_long);
    }
    ASSERT_LE(splitter.held_bytes(), 2 * (piece.size() + LineSplitter::kMaxLine));
  }
  EXPECT_EQ(lines, 1);
}

TEST(LineSplitter, FindsTheSameLinesHoweverMuchIsFedBeforeTheyAreRead) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    std::string text;
    for (int i = 0; i < 60; ++i) {
      text += "ab\r\n"[random() % 4];
    }
    LineSplitter splitter;
    std::vector<Found> found;
    NumberedLine line;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t piece = 1 + random() % 9;
      splitter.feed(std::string_view(text).substr(at, piece));
      at += piece;
      for (std::size_t i = random() % 4; i > 0 && splitter.next(line); --i) {
        found.push_back({std::string(line.text), line.number});
      }
    }
    splitter.finish();
    while (splitter.next(line)) {
      found.push_back({std::string(line.text), line.number});
    }
    EXPECT_EQ(found, split(text, text.size())) << round;
  }
}

TEST(LineSplitter, AnEmptyTextHasNoLine) {
  EXPECT_TRUE(split("", 1).empty());
}

}  // namespace
}  // namespace kerf::parser
