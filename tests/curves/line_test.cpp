#include "curves/line.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace kerf::curves {
namespace {

TEST(Line, RunsStraightAtUnitSpeed) {
  const auto line = Line::between({1.0, 2.0, 3.0}, {4.0, 6.0, 15.0});
  ASSERT_TRUE(line);
  EXPECT_DOUBLE_EQ(line->length_mm(), 13.0);
  const Position p = line->at(6.5);
  EXPECT_NEAR(p[0], 2.5, 1e-14);
  EXPECT_NEAR(p[1], 4.0, 1e-14);
  EXPECT_NEAR(p[2], 9.0, 1e-14);
  const PathDerivatives d = line->derivatives_at(6.5);
  EXPECT_NEAR(d.first[0], 3.0 / 13.0, 1e-15);
  EXPECT_NEAR(d.first[1], 4.0 / 13.0, 1e-15);
  EXPECT_NEAR(d.first[2], 12.0 / 13.0, 1e-15);
  EXPECT_EQ(d.second_per_mm, Position{});
  EXPECT_EQ(d.third_per_mm2, Position{});
}

TEST(Line, EndsExactlyWhereTheProgramSays) {
  const Position start{0.1, 0.2, 0.3};
  const Position end{-7.7, 1e3 / 3.0, 0.3};
  const auto line = Line::between(start, end);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->at(0.0), start);
  EXPECT_EQ(line->at(-1.0), start);
  EXPECT_EQ(line->at(line->length_mm()), end);
  EXPECT_EQ(line->at(1e9), end);
}

TEST(Line, KeepsItsDirectionHoweverShort) {
  const auto line = Line::between({0.0, 0.0, 0.0}, {3e-200, 4e-200, 0.0});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->direction()[0], 0.6, 1e-15);
  EXPECT_NEAR(line->direction()[1], 0.8, 1e-15);
}

TEST(Line, FillsTheBoxOfItsEnds) {
  const auto line = Line::between({1.0, 5.0, -2.0}, {3.0, 4.0, -2.0});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->extents().min_mm, (Position{1.0, 4.0, -2.0}));
  EXPECT_EQ(line->extents().max_mm, (Position{3.0, 5.0, -2.0}));
}

TEST(Line, RefusesToHaveNoLength) {
  const auto line = Line::between({1.0, 2.5, 3.0}, {1.0, 2.5, 3.0});
  ASSERT_FALSE(line);
  EXPECT_NE(line.error().message.find("(1, 2.5, 3)"), std::string::npos) << line.error().message;
}

TEST(Line, RefusesWhatIsNoNumberOrTooFarAway) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1.1e9}) {
    const auto end = Line::between({0.0, 0.0, 0.0}, {1.0, bad, 0.0});
    ASSERT_FALSE(end);
    EXPECT_EQ(end.error().where, CurveError::Where::point);
    EXPECT_EQ(end.error().index, 1U);
    const auto start = Line::between({0.0, 0.0, -bad}, {1.0, 0.0, 0.0});
    ASSERT_FALSE(start);
    EXPECT_EQ(start.error().index, 0U);
  }
}

}  // namespace
}  // namespace kerf::curves
