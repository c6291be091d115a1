// Arcs of many turns as segments: the look-ahead holds a segment as a whole, so none may be too
// long.
#include <numbers>

#include <gtest/gtest.h>

#include "smoothing/segment_builder.hpp"

namespace kerf::smoothing {
namespace {

using parser::ArcMove;
using parser::Move;

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

// About the origin, from (5, 0, 0), and up by 2 mm.
Move turns(int count) {
  Move move;
  move.start_mm = {5.0, 0.0, 0.0};
  move.shape = ArcMove{.centre_mm = {0.0, 0.0, 0.0}, .end_mm = {5.0, 0.0, 2.0}, .turns = count};
  move.feedrate_mm_s = 10.0;
  move.source.line = 7;
  return move;
}

std::vector<PathSegment> parts_of(const Move& move) {
  std::vector<PathSegment> segments;
  EXPECT_TRUE(append_segments(move, segments));
  return segments;
}

TEST(ArcParts, OfOrdinaryArcsAreOne) {
  for (const int count : {1, 2, 100, 199}) {
    EXPECT_EQ(parts_of(turns(count)).size(), 1U) << count;
  }
}

TEST(ArcParts, OfManyTurnsAreShort) {
  const std::vector<PathSegment> segments = parts_of(turns(100'000));
  EXPECT_GE(segments.size(), 500U);
  EXPECT_LE(segments.size(), 1000U);
  for (const PathSegment& segment : segments) {
    EXPECT_LE(curves::length_mm(segment.curve), 200.0 * kTurn_rad * 5.0);
    EXPECT_EQ(segment.arc_normal, 2);
    EXPECT_EQ(segment.source.line, 7U);
  }
}

TEST(ArcParts, MakeTheSamePath) {
  const Move move = turns(450);
  const std::vector<PathSegment> segments = parts_of(move);
  ASSERT_EQ(segments.size(), 4U);
  const double length_mm = std::hypot(450.0 * kTurn_rad * 5.0, 2.0);
  double s_mm = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double part_mm = curves::length_mm(segments[i].curve);
    for (const double share : {0.0, 0.25, 0.7, 1.0}) {
      const double s = s_mm + share * part_mm;
      const auto at = curves::position_at(segments[i].curve, share * part_mm);
      const double angle = s / length_mm * 450.0 * kTurn_rad;
      EXPECT_NEAR(at[0], 5.0 * std::cos(angle), 1e-9);
      EXPECT_NEAR(at[1], 5.0 * std::sin(angle), 1e-9);
      EXPECT_NEAR(at[2], 2.0 * s / length_mm, 1e-9);
    }
    EXPECT_EQ(segments[i].continues, i > 0);
    s_mm += part_mm;
  }
  EXPECT_NEAR(s_mm, length_mm, 1e-9 * length_mm);
  EXPECT_EQ(curves::position_at(segments.back().curve, length_mm),
            (curves::Position{5.0, 0.0, 2.0}));
}

TEST(ArcParts, StopOnlyBehindTheLast) {
  Move move = turns(450);
  move.mode = parser::PathMode::exact_stop;
  const std::vector<PathSegment> segments = parts_of(move);
  for (const PathSegment& segment : segments) {
    EXPECT_EQ(segment.stop_after, &segment == &segments.back());
  }
}

TEST(ArcParts, ShareTheWayOfTheExtraAxes) {
  Move move = turns(400);
  move.auxiliary.begin_rad_mm[0] = 1.0;
  move.auxiliary.end_rad_mm[0] = 5.0;
  const std::vector<PathSegment> segments = parts_of(move);
  ASSERT_EQ(segments.size(), 4U);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    EXPECT_NEAR(segments[i].extra.begin_rad_mm[0], 1.0 + static_cast<double>(i), 1e-9);
    EXPECT_NEAR(segments[i].extra.end_rad_mm[0], 2.0 + static_cast<double>(i), 1e-9);
    EXPECT_EQ(segments[i].extra.length_mm, curves::length_mm(segments[i].curve));
  }
  EXPECT_EQ(segments.back().extra.end_rad_mm[0], 5.0);
}

}  // namespace
}  // namespace kerf::smoothing
