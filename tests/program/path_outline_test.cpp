#include "programs/kerf/plot/path_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "programs/kerf/plot/feed_colours.hpp"

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

constexpr double kWidth = 100.0;  // of a raster, and its height
constexpr double kFast = 100.0;

// Rows forth and back, the next at another feedrate: 100 and 20 mm/s below, 100 and 50 above.
double v_of_row(int row, int rows) {
  return row % 2 == 0 ? kFast : row < rows / 2 ? 20.0 : 50.0;
}

std::vector<OutlinePoint> raster(int rows) {
  std::vector<OutlinePoint> points;
  for (int row = 0; row < rows; ++row) {
    const double v = kWidth * row / rows;
    const double begin = row % 2 == 0 ? 0.0 : kWidth;
    points.push_back({.at = {.u_mm = begin, .v_mm = v}, .v_mm_s = v_of_row(row, rows)});
    points.push_back({.at = {.u_mm = kWidth - begin, .v_mm = v}, .v_mm_s = v_of_row(row, rows)});
  }
  return points;
}

// Millimetre by millimetre what is on top of the picture; 99: paper.
using Picture = std::vector<std::size_t>;

Picture picture_of(const std::vector<OutlinePoint>& outline) {
  Picture picture(static_cast<std::size_t>(kWidth * kWidth), 99);
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const double way = std::abs(outline[i].at.u_mm - outline[i - 1].at.u_mm);
    if (outline[i].hidden || way < 2.0) {  // the edge, where rows are joined
      continue;
    }
    const double left = std::min(outline[i].at.u_mm, outline[i - 1].at.u_mm);
    for (double u = left + 0.5; u < left + way; u += 1.0) {
      std::size_t& level =
          picture[static_cast<std::size_t>(outline[i].at.v_mm) * 100 + static_cast<std::size_t>(u)];
      level = std::min(level, level_to(i, outline, kFast));
    }
  }
  return picture;
}

TEST(PathOutline, ShowsTheColoursOfAMillionRowsAsIfItKeptThemAll) {
  constexpr int kRows = 1'000'000;
  const std::vector<OutlinePoint> all = raster(kRows);
  PathOutline outline({.distance_mm = kWidth / 2800.0});
  for (const OutlinePoint& point : all) {
    outline.add(point);
  }
  const auto points = outline.points();
  EXPECT_LE(points.size(), 100'001U);
  EXPECT_EQ(picture_of(points), picture_of(all));
  EXPECT_EQ(picture_of(points).front(), colour_level(20.0, kFast));
  EXPECT_EQ(picture_of(points).back(), colour_level(50.0, kFast));
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!points[i].hidden && std::abs(points[i].at.u_mm - points[i - 1].at.u_mm) > 1.0) {
      const std::size_t level = level_to(i, points, kFast);
      EXPECT_TRUE(level == colour_level(20.0, kFast) || level == colour_level(50.0, kFast) ||
                  level == colour_level(kFast, kFast))
          << level;
    }
  }
}

// Slow at the ends of each row, where the tool turns round, as every real raster is.
double v_along_row(double u) {
  return std::min({kFast, 10.0 + 20.0 * u, 10.0 + 20.0 * (kWidth - u)});
}

TEST(PathOutline, NeverDrawsAnotherFeedrateThanThatOfThePlace) {
  PathOutline outline({.distance_mm = kWidth / 2800.0});
  for (int row = 0; row < 20'000; ++row) {
    for (int i = 0; i <= 200; ++i) {
      const double u = row % 2 == 0 ? 0.5 * i : kWidth - 0.5 * i;
      outline.add({.at = {.u_mm = u, .v_mm = kWidth * row / 20'000.0}, .v_mm_s = v_along_row(u)});
    }
  }
  const auto points = outline.points();
  EXPECT_LE(points.size(), 100'001U);
  std::size_t drawn = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].hidden) {
      continue;
    }
    ++drawn;
    for (const double share : {0.01, 0.5, 0.99}) {
      const double u = points[i - 1].at.u_mm + share * (points[i].at.u_mm - points[i - 1].at.u_mm);
      const auto of_place = static_cast<double>(colour_level(v_along_row(u), kFast));
      // The colour of a stretch is that of its middle, and it may be a colour long.
      ASSERT_NEAR(static_cast<double>(level_to(i, points, kFast)), of_place, 2.0)
          << points[i - 1].at.u_mm << " to " << points[i].at.u_mm;
    }
  }
  EXPECT_GT(drawn, 1000U);
}

TEST(PathOutline, FramesWhatIsCut) {
  const std::vector<OutlinePoint> points{{.at = {.u_mm = -900.0}, .rapid = true},
                                         {.at = {.u_mm = 10.0, .v_mm = 5.0}, .rapid = true},
                                         {.at = {.u_mm = 20.0, .v_mm = 8.0}},
                                         {.at = {.v_mm = 900.0}, .rapid = true}};
  const PaperBox box = box_around(points);
  EXPECT_EQ(box.min.u_mm, 10.0);
  EXPECT_EQ(box.max.u_mm, 20.0);
  EXPECT_EQ(box.max.v_mm, 8.0);
  EXPECT_EQ(box_around({points[0], points[1]}).min.u_mm, -900.0) << "nothing is cut";
}

TEST(PathOutline, ThinsItselfWithinItsMemory) {
  constexpr std::size_t kMax = 2000;
  constexpr int kPoints = 20'000;
  PathOutline outline({.distance_mm = 1e-6, .v_share = 1e-6}, kMax);
  for (int i = 0; i < kPoints; ++i) {
    outline.add({.at = on_spiral(i), .v_mm_s = 10.0 + std::sin(0.1 * i)});
  }
  const auto points = outline.points();
  EXPECT_LE(points.size(), kMax + 1);
  EXPECT_GE(points.size(), kMax / 8);
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
