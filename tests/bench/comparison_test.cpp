// The verdict of kerf-bench papers can fail.
#include "bench/papers/comparison.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace kerf::bench {
namespace {

constexpr double kPublished = 4.417;

// The row that the figure gets, and the verdict.
struct Judged {
  std::string row;
  bool holds = false;
};

Judged judged(const PaperFigure& figure) {
  Comparison table;
  table.add(figure);
  testing::internal::CaptureStdout();
  table.print("## Of one");
  const std::string text = testing::internal::GetCapturedStdout();
  testing::internal::CaptureStdout();
  const bool holds = table.judge();
  testing::internal::GetCapturedStdout();
  const std::size_t begin = text.rfind("| time");
  return {.row = text.substr(begin, text.find('\n', begin) - begin), .holds = holds};
}

PaperFigure time_of(double here) {
  return {.name = "time", .published = kPublished, .decimals = 3, .here = here};
}

TEST(PapersVerdict, CallsWhatIsTheSameToTheLastDigitReproduced) {
  const Judged found = judged(time_of(4.418));
  EXPECT_TRUE(found.holds);
  EXPECT_EQ(found.row, "| time | 4.417 | 4.418 | reproduced |  |  |");
}

TEST(PapersVerdict, FailsWhereAFigureIsFartherAway) {
  EXPECT_FALSE(judged(time_of(4.419)).holds);
}

TEST(PapersVerdict, StatesTheBandThatReplacesTheLastDigit) {
  PaperFigure figure = time_of(4.419);
  figure.tolerance = 0.005;
  const Judged found = judged(figure);
  EXPECT_TRUE(found.holds);
  EXPECT_EQ(found.row, "| time | 4.417 | 4.419 | reproduced | 0.005 |  |");
}

TEST(PapersVerdict, StatesTheBandInWhichAFigureApproaches) {
  PaperFigure figure = time_of(4.421);
  figure.band = 0.006;
  figure.why = "below the scan";
  EXPECT_EQ(judged(figure).row, "| time | 4.417 | 4.421 | approached | 0.006 | below the scan |");
  figure.impossible = true;
  EXPECT_EQ(judged(figure).row, "| time | 4.417 | 4.421 | impossible | 0.006 | below the scan |");
}

TEST(PapersVerdict, FailsWhereAFigureLeavesItsBand) {
  PaperFigure figure = time_of(4.424);
  figure.band = 0.006;
  figure.why = "below the scan";
  EXPECT_FALSE(judged(figure).holds);
}

TEST(PapersVerdict, FailsWhereNobodySaysWhatPartsTheFigures) {
  PaperFigure figure = time_of(4.421);
  figure.band = 0.006;
  EXPECT_FALSE(judged(figure).holds);
}

TEST(PapersVerdict, FailsWhereAFigureIsNoNumber) {
  PaperFigure figure = time_of(std::numeric_limits<double>::quiet_NaN());
  figure.band = 0.006;
  figure.why = "below the scan";
  EXPECT_FALSE(judged(figure).holds);
}

TEST(PapersVerdict, FailsWhereWhatIsRequiredDoesNotHold) {
  Comparison table;
  table.require("the limit of 55000 is kept", true);
  testing::internal::CaptureStdout();
  EXPECT_TRUE(table.judge());
  table.require("the limit of 55000 is kept", false);
  EXPECT_FALSE(table.judge());
  testing::internal::GetCapturedStdout();
}

}  // namespace
}  // namespace kerf::bench
