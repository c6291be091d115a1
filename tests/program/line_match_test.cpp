#include "programs/kerf/compare/line_match.hpp"

#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

using Lines = std::vector<std::string>;

// "1=1 2-3=2 4=": the lines of each pair.
std::string pairs_of(const Lines& first, const Lines& second) {
  const auto words = [](const LineSpan& span) {
    if (span.is_empty()) {
      return std::string();
    }
    const std::string begin = std::to_string(span.first);
    return span.count() == 1 ? begin : begin + "-" + std::to_string(span.last);
  };
  std::string text;
  for (const MatchedLines& pair : match_lines(first, second)) {
    text += (text.empty() ? "" : " ") + words(pair.first) + "=" + words(pair.second);
  }
  return text;
}

TEST(LineMatch, PairsEachLineOfATextWithItself) {
  EXPECT_EQ(pairs_of({"a", "b", "b"}, {"a", "b", "b"}), "1=1 2=2 3=3");
  EXPECT_EQ(pairs_of({}, {}), "");
}

TEST(LineMatch, LetsNothingStandForWhatIsNew) {
  EXPECT_EQ(pairs_of({"a", "b"}, {"a", "x", "y", "b"}), "1=1 =2-3 2=4");
  EXPECT_EQ(pairs_of({"a", "x", "b"}, {"a", "b"}), "1=1 2= 3=2");
  EXPECT_EQ(pairs_of({}, {"a"}), "=1");
}

TEST(LineMatch, PairsChangedLinesOneByOneWhereThereAreAsMany) {
  EXPECT_EQ(pairs_of({"a", "F100", "F200", "b"}, {"a", "F150", "F250", "b"}), "1=1 2=2 3=3 4=4");
  EXPECT_EQ(pairs_of({"a", "F100", "F200", "b"}, {"a", "F150", "b"}), "1=1 2-3=2 4=3");
}

TEST(LineMatch, FindsALineAmongManyThatAreAlike) {
  EXPECT_EQ(pairs_of({"x", "y", "x", "y", "one", "x", "y"}, {"x", "y", "one", "y", "x", "y"}),
            "1=1 2=2 3-4= 5=3 =4 6=5 7=6");
}

TEST(LineMatch, KeepsTheOrderOfLinesThatHaveMoved) {
  EXPECT_EQ(pairs_of({"a", "b", "c", "d"}, {"d", "a", "b", "c"}), "=1 1=2 2=3 3=4 4=");
}

TEST(LineMatch, DoesNotMindNumbersCommentsBlanksAndSmallLetters) {
  EXPECT_EQ(pairs_of({"N10 G1 X1", "g1x2 (here)", "N30 X3 ; there", "(a)"},
                     {"G1X1", "new", "N5 G1 X2", "X3", "(b)"}),
            "1=1 =2 2=3 3=4 4=5");
  EXPECT_EQ(pairs_of({"N", "a"}, {"new", "N", "a"}), "=1 1=2 2=3") << "N alone is no number";
}

TEST(LineMatch, TakesEachLineOnceAndInOrder) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const auto text = [&random] {
      Lines lines(random() % 40);
      for (std::string& line : lines) {
        line = std::to_string(random() % 12);
      }
      return lines;
    };
    const Lines first = text();
    const Lines second = text();
    std::uint32_t next_first = 1;
    std::uint32_t next_second = 1;
    for (const MatchedLines& pair : match_lines(first, second)) {
      ASSERT_EQ(pair.first.first, next_first);
      ASSERT_EQ(pair.second.first, next_second);
      next_first += pair.first.count();
      next_second += pair.second.count();
    }
    EXPECT_EQ(next_first, first.size() + 1);
    EXPECT_EQ(next_second, second.size() + 1);
  }
}

// A quadratic method would take hours here.
TEST(LineMatch, TakesManyLinesWithoutOneInCommon) {
  Lines first;
  Lines second;
  for (int i = 0; i < 200'000; ++i) {
    first.push_back("X" + std::to_string(i));
    second.push_back("Y" + std::to_string(i));
  }
  second.emplace_back("end");
  const auto pairs = match_lines(first, second);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].second.last, 200'001U);
}

TEST(LineMatch, KnowsCommentsAndSequenceNumbersWhereverTheyStand) {
  const std::string alike = "1=1 2=2 3=3";
  EXPECT_EQ(pairs_of({"a", "(x; y) G1 X50", "b"}, {"a", "G1X50 ; (no", "b"}), alike);
  EXPECT_EQ(pairs_of({"a", "/N10 G0 X1", "/2 N7 M0"}, {"a", "/ N11 G0 X1", "/2N9M0"}), alike);
  EXPECT_EQ(pairs_of({"a", "/N10 G0 X1"}, {"a", "N10 G0 X1"}), "1=1 2=2") << "changed";
  EXPECT_EQ(pairs_of({"a", "/N10 G0 X1", "b"}, {"a", "b"}), "1=1 2= 3=2");
}

TEST(LineMatch, CountsLinesAsTheyAreReadWhateverEndsThem) {
  EXPECT_EQ(lines_of("a\nb\r\n\rc"), (Lines{"a", "b", "", "c"}));
  EXPECT_EQ(lines_of(""), Lines{});
}

}  // namespace
}  // namespace kerf::program
