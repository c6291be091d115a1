#include "programs/kerf/page/planned_path.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

// Along X from one place to the next.
smoothing::PathSegment line(double from_mm, double to_mm, double deviation_mm) {
  return {.curve = curves::Line::between({from_mm, 0.0, 0.0}, {to_mm, 0.0, 0.0}).value(),
          .deviation_mm = deviation_mm};
}

constexpr curves::Extents kBox{.min_mm = {0.0, 0.0, 0.0}, .max_mm = {100.0, 0.0, 0.0}};

TEST(PlannedPath, TellsHowFarItIsFromTheProgrammedOneBySteps) {
  PlannedPath path(kBox);
  for (const auto& segment :
       {line(0, 10, 0.0), line(10, 20, 0.0), line(20, 25, 0.01), line(25, 40, 0.003)}) {
    path.add(segment);
  }
  std::vector<double> ends;
  std::vector<double> deviations;
  for (const PlannedPath::Step& step : path.deviations()) {
    ends.push_back(step.end_mm);
    deviations.push_back(step.deviation_mm);
  }
  EXPECT_EQ(ends, (std::vector{20.0, 25.0, 40.0}));
  EXPECT_EQ(deviations, (std::vector{0.0, 0.01, 0.003}));
}

TEST(PlannedPath, GivesATickTheLargestDeviationOfWhatItPassedOver) {
  PlannedPath path(kBox);
  for (const auto& segment : {line(0, 10, 0.0), line(10, 11, 0.01), line(11, 40, 0.003)}) {
    path.add(segment);
  }
  DeviationAlong along(&path);
  EXPECT_EQ(along.advance_to(0.0), 0.0);
  EXPECT_EQ(along.advance_to(9.0), 0.0);
  EXPECT_EQ(along.advance_to(13.0), 0.01);  // from 9 mm over all of the second
  EXPECT_EQ(along.advance_to(14.0), 0.003);
  EXPECT_EQ(along.advance_to(50.0), 0.003);
  EXPECT_EQ(DeviationAlong(nullptr).advance_to(3.0), 0.0);
}

TEST(PlannedPath, KeepsThePeakWhenItsStepsRunOut) {
  PlannedPath path(kBox);
  const std::size_t count = PlannedPath::kMaxSteps + 10;
  const double way_mm = 1e-3;
  for (std::size_t i = 0; i < count; ++i) {
    const double from_mm = way_mm * static_cast<double>(i);
    path.add(line(from_mm, from_mm + way_mm, i == 777 ? 0.5 : 1e-3 * static_cast<double>(i % 2)));
  }
  const auto& steps = path.deviations();
  EXPECT_LE(steps.size(), PlannedPath::kMaxSteps);
  const auto peak = std::ranges::max_element(steps, {}, &PlannedPath::Step::deviation_mm);
  EXPECT_EQ(peak->deviation_mm, 0.5);
  EXPECT_NEAR(peak->end_mm, 0.778, 0.0011);
  EXPECT_NEAR(steps.back().end_mm, way_mm * static_cast<double>(count), 1e-6);
  EXPECT_TRUE(std::ranges::is_sorted(steps, {}, &PlannedPath::Step::end_mm));
}

smoothing::PathSegment line_of(std::uint16_t file, std::uint32_t number, double from_mm) {
  smoothing::PathSegment segment = line(from_mm, from_mm + 10.0, 0.0);
  segment.source = {.line = number, .file = file};
  return segment;
}

TEST(PlannedPath, TellsWhichFileAPlaceComesFromAndWhereTwoMeetTheLineDecides) {
  PlannedPath path(kBox);
  path.add(line_of(0, 2, 0.0));
  path.add_pause({.line = 3, .file = 1});
  path.add(line_of(1, 4, 10.0));
  path.add(line_of(0, 9, 20.0));
  FileAlong along(&path);
  EXPECT_EQ(along.advance_to(0.0, 2), 0);
  EXPECT_EQ(along.advance_to(10.0, 2), 0);
  EXPECT_EQ(along.advance_to(10.0, 3), 1);  // the pause, before anything moves
  EXPECT_EQ(along.advance_to(15.0, 4), 1);
  EXPECT_EQ(along.advance_to(20.0, 4), 1);
  EXPECT_EQ(along.advance_to(20.0, 9), 0);
  EXPECT_EQ(along.advance_to(30.0, 9), 0);
  EXPECT_EQ(FileAlong(nullptr).advance_to(1.0, 1), 0);
}

TEST(PlannedPath, DrawsWhereItGoes) {
  PlannedPath path(kBox);
  path.add(line(0, 60, 0.0));
  path.add(line(60, 30, 0.0));
  const std::vector<TimedPoint> points = path.outline().points();
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1].position_mm[0], 60.0);
  EXPECT_EQ(points[1].tick, 60'000'000);
  EXPECT_EQ(points[2].position_mm[0], 30.0);
  EXPECT_EQ(points[2].tick, 90'000'000);
}

}  // namespace
}  // namespace kerf::program
