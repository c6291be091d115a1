// Which curves are taken for lines.
#include <gtest/gtest.h>

#include "curves/curve_builders.hpp"

namespace kerf::curves {
namespace {

std::vector<NurbsCurve> parts_of(std::vector<ControlPoint> points) {
  const auto p = points.size() - 1;
  std::vector<double> knots(p + 1, 0.0);
  knots.insert(knots.end(), p + 1, 1.0);
  return NurbsCurve::make(
             {.degree = static_cast<int>(p), .points = std::move(points), .knots = knots})
      .value();
}

TEST(Straight, IsACurveWhosePointsAreOnALineButForItsDigits) {
  const auto parts = parts_of({{{1.0, 2.0, 3.0}},
                               {{1.3, 2.0 + 1e-10, 3.0 - 1e-10}, 50.0},
                               {{1.4, 2.0 - 1e-10, 3.0}, 0.1},
                               {{2.0, 2.0, 3.0 + 1e-10}}});
  ASSERT_EQ(parts.size(), 1U);
  const auto line = straight(parts.front());
  ASSERT_TRUE(line);
  EXPECT_EQ(line->at(0.0), parts.front().at(0.0));
  EXPECT_EQ(line->at(line->length_mm()), (Position{2.0, 2.0, 3.0 + 1e-10}));
  for (double s = 0.0; s < line->length_mm(); s += 1e-3) {
    EXPECT_LT((vec(line->at(s)) - vec(parts.front().at(s))).norm(), 1e-9);
  }
}

TEST(Straight, IsNotACurveThatLeavesTheLine) {
  const auto parts = parts_of({{{0, 0, 0}}, {{1, 2e-9, 0}}, {{2, 0, 0}}});
  EXPECT_FALSE(straight(parts.front()));
}

TEST(Straight, IsNotACurveThatTurns) {
  const auto parts = parts_of({{{0, 0, 0}}, {{1, 5, 0}}, {{2, 0, 0}}});
  EXPECT_FALSE(straight(parts.front()));
}

// On a line that it runs along and back: cut where it turns back, each part is straight.
TEST(Straight, AreThePartsOfACurveThatRunsBackOnALine) {
  const auto parts = parts_of({{{0, 0, 0}}, {{3, 0, 0}}, {{1, 0, 0}}});
  ASSERT_EQ(parts.size(), 2U);
  double sum = 0.0;
  for (const NurbsCurve& part : parts) {
    const auto line = straight(part);
    ASSERT_TRUE(line);
    sum += line->length_mm();
  }
  EXPECT_NEAR(sum, 1.8 + 0.8, 1e-9);  // x = 6 u - 5 u^2 turns at u = 0.6
}

}  // namespace
}  // namespace kerf::curves
