#include "programs/path_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

constexpr OutlineTolerance kTolerance{.distance_mm = 0.01, .v_share = 0.1};

double distance_to_segment(const PaperPoint& p, const PaperPoint& a, const PaperPoint& b) {
  const double du = b.u_mm - a.u_mm;
  const double dv = b.v_mm - a.v_mm;
  const double squared = du * du + dv * dv;
  const double along =
      squared > 0.0 ? ((p.u_mm - a.u_mm) * du + (p.v_mm - a.v_mm) * dv) / squared : 0.0;
  const double share = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.u_mm - a.u_mm - share * du, p.v_mm - a.v_mm - share * dv);
}

double distance_to(const std::vector<OutlinePoint>& outline, const PaperPoint& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < outline.size(); ++i) {
    nearest = std::min(nearest, distance_to_segment(p, outline[i - 1].at, outline[i].at));
  }
  return nearest;
}

PaperPoint on_spiral(int i) {
  const double angle = 0.01 * i;
  const double radius = 1.0 + 0.005 * i;
  return {.u_mm = radius * std::cos(angle), .v_mm = radius * std::sin(angle)};
}

TEST(PathOutline, KeepsTheEndsOfAStraightLineAlone) {
  PathOutline outline(kTolerance);
  for (int i = 0; i <= 1000; ++i) {
    outline.add({.at = {.u_mm = 0.1 * i, .v_mm = 0.05 * i}, .v_mm_s = 10.0});
  }
  const auto points = outline.points();
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].at.u_mm, 0.0);
  EXPECT_DOUBLE_EQ(points[1].at.u_mm, 100.0);
}

TEST(PathOutline, StaysWithinItsToleranceOfACurve) {
  PathOutline outline(kTolerance);
  for (int i = 0; i < 3000; ++i) {
    outline.add({.at = on_spiral(i), .v_mm_s = 10.0});
  }
  const auto points = outline.points();
  EXPECT_LT(points.size(), 1000U);
  for (int i = 0; i < 3000; ++i) {
    EXPECT_LE(distance_to(points, on_spiral(i)), kTolerance.distance_mm * 1.001) << "point " << i;
  }
}

TEST(PathOutline, KeepsHowFarAStrokeForthAndBackWent) {
  PathOutline outline(kTolerance);
  for (int i = -100; i <= 100; ++i) {
    outline.add({.at = {.u_mm = 10.0 - 0.1 * std::abs(i)}, .v_mm_s = 10.0});
  }
  const auto points = outline.points();
  const auto farthest = std::max_element(
      points.begin(), points.end(),
      [](const OutlinePoint& a, const OutlinePoint& b) { return a.at.u_mm < b.at.u_mm; });
  EXPECT_NEAR(farthest->at.u_mm, 10.0, 2.0 * kTolerance.distance_mm);
  EXPECT_EQ(points.back().at.u_mm, 0.0);
}

TEST(PathOutline, KeepsAChangeOfFeedrateOnAStraightLine) {
  PathOutline outline(kTolerance);
  for (int i = 0; i <= 100; ++i) {
    outline.add({.at = {.u_mm = 0.1 * i}, .v_mm_s = i < 50 ? 100.0 : 20.0});
  }
  const auto points = outline.points();
  ASSERT_GE(points.size(), 4U);
  const auto slow = std::find_if(points.begin(), points.end(),
                                 [](const OutlinePoint& p) { return p.v_mm_s < 50.0; });
  EXPECT_DOUBLE_EQ(slow->at.u_mm, 5.0);
}

TEST(PathOutline, KeepsWhereARapidBeginsAndEnds) {
  PathOutline outline(kTolerance);
  for (int i = 0; i <= 100; ++i) {
    outline.add({.at = {.u_mm = 0.1 * i}, .v_mm_s = 10.0, .rapid = i >= 30 && i < 60});
  }
  const auto points = outline.points();
  const auto is_rapid = [](const OutlinePoint& p) { return p.rapid; };
  const auto first = std::find_if(points.begin(), points.end(), is_rapid);
  const auto after = std::find_if_not(first, points.end(), is_rapid);
  ASSERT_NE(after, points.end());
  EXPECT_DOUBLE_EQ(first->at.u_mm, 3.0);
  EXPECT_DOUBLE_EQ(after->at.u_mm, 6.0);
}

TEST(PathOutline, ThinsItselfWithinItsMemory) {
  constexpr std::size_t kMost = 2000;
  constexpr int kPoints = 20'000;
  PathOutline outline({.distance_mm = 1e-6, .v_share = 1e-6}, kMost);
  for (int i = 0; i < kPoints; ++i) {
    outline.add({.at = on_spiral(i), .v_mm_s = 10.0 + std::sin(0.1 * i)});
  }
  const auto points = outline.points();
  EXPECT_LE(points.size(), kMost + 1);
  EXPECT_GE(points.size(), kMost / 8);
  EXPECT_EQ(points.back().at.u_mm, on_spiral(kPoints - 1).u_mm);
}

TEST(PathOutline, EndsThoughEveryToleranceIsZero) {
  PathOutline outline({.distance_mm = 0.0, .v_share = 0.0}, 10);
  for (int i = 0; i < 1000; ++i) {
    outline.add({.at = on_spiral(i), .v_mm_s = 1.0});
  }
  EXPECT_LE(outline.points().size(), 11U);
}

}  // namespace
}  // namespace kerf::program
