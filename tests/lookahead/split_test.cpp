// Where limit curves made by hand are cut into segments.
#include "lookahead/classical/split.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/lookahead/velocity_segments.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kTick_s = 0.001;

Block under(const VelocityLimitCurve& limit_curve) {
  Block block{.curve = curves::Line::between({0, 0, 0}, {limit_curve.back().s_mm, 0, 0}).value()};
  block.length_mm = limit_curve.back().s_mm;
  block.limits = {.feedrate_mm_s = 100.0, .ramp = {.acceleration_mm_s2 = kA, .jerk_mm_s3 = kJ}};
  block.along = block.limits;
  block.limit_curve = limit_curve;
  return block;
}

// At the feedrate in mm/s of each place in mm.
VelocityLimitCurve through(const std::vector<std::array<double, 2>>& places) {
  VelocityLimitCurve limit_curve;
  for (const auto& [s, v] : places) {
    limit_curve.push_back({.u = static_cast<double>(limit_curve.size()), .s_mm = s, .v_mm_s = v});
  }
  return limit_curve;
}

double sum_mm(const std::vector<VelocitySegment>& segments) {
  double sum = 0.0;
  for (const VelocitySegment& segment : segments) {
    sum += segment.length_mm;
  }
  return sum;
}

// A tick at 1 mm/s covers a micrometre, here with a thousand valleys: rounding near a corner.
TEST(Split, TakesValleysWithinATicksWayForOne) {
  VelocityLimitCurve limit_curve = through({{0.0, 100.0}});
  for (int i = 0; i < 2000; ++i) {
    limit_curve.push_back(
        {.u = 1.0 + i, .s_mm = 5.0 + 5e-10 * i, .v_mm_s = i % 2 == 0 ? 1.0 : 60.0});
  }
  limit_curve.push_back({.u = 3000.0, .s_mm = 10.0, .v_mm_s = 100.0});
  const std::vector<VelocitySegment> segments = split(under(limit_curve), kTick_s);
  EXPECT_LE(segments.size(), 4U);
  EXPECT_NEAR(sum_mm(segments), 10.0, 1e-9);
  for (const VelocitySegment& segment : segments) {
    EXPECT_LE(segment.end.feedrate_mm_s, 1.0);
  }
}

// Cut at, each would be a segment of its own of 10 fm, in which no feedrate is reached from rest.
TEST(Split, DoesNotCutAtAValleyWithinATicksWayOfAnEnd) {
  const Block block = under(through({{0.0, 2e-3},
                                     {1e-11, 1e-3},
                                     {1e-10, 2e-3},
                                     {1.0, 50.0},
                                     {9.0, 50.0},
                                     {10.0 - 1e-10, 2e-3},
                                     {10.0 - 1e-11, 1e-3},
                                     {10.0, 2e-3}}));
  const std::vector<VelocitySegment> segments = split(block, kTick_s);
  EXPECT_GT(segments.front().length_mm, 1e-6);
  EXPECT_EQ(segments.front().rise.bottom_mm_s(), 1e-3);
  EXPECT_GT(segments.back().length_mm, 1e-6);
  EXPECT_EQ(segments.back().fall.bottom_mm_s(), 1e-3);
}

TEST(Split, KeepsValleysFartherApartThanATick) {
  const Block block =
      under(through({{0.0, 100.0}, {5.0, 50.0}, {5.06, 100.0}, {5.12, 60.0}, {10.0, 100.0}}));
  const std::vector<VelocitySegment> segments = split(block, kTick_s);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[0].end.feedrate_mm_s, 50.0);
  EXPECT_EQ(segments[1].end.feedrate_mm_s, 60.0);
}

// From rest over 4 nm at 8 nm/s and then freely: one ramp would take all of the 75 mm.
TEST(Split, CutsARampBehindATinyFeature) {
  const Block block = under(through({{0.0, 3e-9}, {4e-6, 8e-6}, {0.4, 90.0}, {75.0, 90.0}}));
  const profiles::Profile profile{ProfileKind::trapezoid};
  double time_s = 0.0;
  double v = 0.0;
  for (const VelocitySegment& segment : split(block, kTick_s)) {
    SegmentEnds ends{.v_begin_mm_s = v, .v_end_mm_s = segment.end.feedrate_mm_s};
    ends.v_end_mm_s = end_feedrate_mm_s(segment, ends, 0.0, profile);
    time_s += plan_segment(segment, ends, profile).duration_s();
    v = ends.v_end_mm_s;
  }
  // On lines v = v0 + c s the limit curve itself takes log(v1 / v0) / c.
  const double limit_curve_s = std::log(8e-6 / 3e-9) * 4e-6 / (8e-6 - 3e-9) +
                               std::log(90.0 / 8e-6) * 0.4 / 90.0 + 74.6 / 90.0;
  EXPECT_LT(time_s, 2.0 * limit_curve_s);
}

}  // namespace
}  // namespace kerf::lookahead::test
