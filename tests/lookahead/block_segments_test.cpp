#include "lookahead/classical/block_segments.hpp"

#include <cmath>
#include <numeric>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "lookahead/classical/split.hpp"
#include "lookahead/classical/velocity_pass.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

// Degree 3 with simple knots through a way that bends now less, now more.
curves::NurbsData wave(int points, double width_mm) {
  curves::NurbsData data{.degree = 3, .points = {}, .knots = {0, 0, 0, 0}};
  for (int i = 0; i < points; ++i) {
    data.points.push_back({.position_mm = {0.8 * i, width_mm * std::sin(0.9 * i),
                                           0.3 * width_mm * std::cos(1.7 * i)}});
  }
  for (int knot = 1; knot <= points - 4; ++knot) {
    data.knots.push_back(knot);
  }
  data.knots.insert(data.knots.end(), 4, points - 3);
  return data;
}

struct Cut {
  std::size_t segments = 0;
  double duration_s = 0.0;
};

Cut planned(const std::vector<VelocitySegment>& segments, const profiles::Profile& profile) {
  const std::vector<double> durations_s = BlockRuns(profile).rest_to_rest_s(segments);
  return {segments.size(), std::accumulate(durations_s.begin(), durations_s.end(), 0.0)};
}

struct Cuts {
  Cut chosen{};
  Cut at_every_valley{};
};

Cuts cuts_of(const curves::NurbsData& data, profiles::ProfileKind kind) {
  const PlanLimits limits = mill();
  const profiles::Profile profile(kind);
  const Block block = blocks_of({nurbs_move(data, 200.0)}, limits).front();
  const auto axis_limits = scan_axis_limits(std::get<curves::NurbsCurve>(block.curve),
                                            block.limits.feedrate_mm_s, limits);
  return {.chosen = planned(segments_of(block, {limits, profile}, false), profile),
          .at_every_valley = planned(split(block, {axis_limits, limits}, 0.05), profile)};
}

// Almost a line: 20 valleys, and one ramp over all of them.
TEST(BlockSegments, PassOverValleysThatHardlyBind) {
  const Cuts cuts = cuts_of(wave(40, 0.05), profiles::ProfileKind::s_curve);
  EXPECT_GT(cuts.at_every_valley.segments, 10U);
  EXPECT_EQ(cuts.chosen.segments, 1U);
  EXPECT_LT(cuts.chosen.duration_s, cuts.at_every_valley.duration_s);
}

// Shallow valleys beside deep ones: only some are worth it.
TEST(BlockSegments, TakeLessTimeThanWithAllValleys) {
  for (const auto kind : {profiles::ProfileKind::s_curve, profiles::ProfileKind::quintic}) {
    const Cuts cuts = cuts_of(wave(40, 5.0), kind);
    EXPECT_GT(cuts.chosen.segments, 10U);
    EXPECT_LT(cuts.chosen.segments, cuts.at_every_valley.segments);
    EXPECT_LT(cuts.chosen.duration_s, 0.95 * cuts.at_every_valley.duration_s);
  }
}

// From rest over those valleys to the feedrate at the end, one ramp is as gentle as the lowest of
// them asks for.
TEST(BlockSegments, AreNotOneRampWhereTheBlockBeginsAtRestAndEndsInMotion) {
  const PlanLimits limits = mill();
  const profiles::Profile profile(profiles::ProfileKind::s_curve);
  const Block block = blocks_of({nurbs_move(wave(40, 0.05), 200.0)}, limits).front();
  const auto axis_limits = scan_axis_limits(std::get<curves::NurbsCurve>(block.curve),
                                            block.limits.feedrate_mm_s, limits);
  const auto duration_s = [&](const std::vector<VelocitySegment>& segments) {
    const std::vector<double> durations_s = BlockRuns(profile).in_motion_s(segments, true);
    return std::accumulate(durations_s.begin(), durations_s.end(), 0.0);
  };
  const auto one_ramp = split(block, {axis_limits, limits}, 0.6);
  ASSERT_EQ(one_ramp.size(), 1U);
  EXPECT_LT(duration_s(segments_of(block, {limits, profile}, true)), 0.7 * duration_s(one_ramp));
}

TEST(BlockSegments, EndInDeepValleys) {
  const Cuts cuts =
      cuts_of(curves::testing::shipped_curve("trident7"), profiles::ProfileKind::s_curve);
  EXPECT_GT(cuts.at_every_valley.segments, 4U);
  EXPECT_EQ(cuts.chosen.segments, cuts.at_every_valley.segments);
}

}  // namespace
}  // namespace kerf::lookahead::test
