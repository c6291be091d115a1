// Lines of G61 that go on straight, which the compressor makes one.
#include <algorithm>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "smoothing/compressor.hpp"
#include "tests/smoothing/polylines.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::test {
namespace {

using curves::Position;
using curves::vec;
using smoothing::PathSegment;

std::vector<parser::Move> exact_lines_through(const std::vector<Position>& points) {
  std::vector<parser::Move> moves = lines_through(points, {});
  for (parser::Move& move : moves) {
    move.mode = parser::PathMode::exact_path;
    move.feedrate_mm_s = 250.0;
  }
  return moves;
}

// Coordinates of a few decimals on a line: none is farther from it than their rounding.
TEST(ExactLines, AreOneWhereTheyGoOnStraight) {
  std::vector<Position> points;
  for (int i = 0; i <= 100; ++i) {
    points.push_back({100.0 + 0.03 * i, 7.0 - 0.01 * i, 0.02 * i});
  }
  const Smoothed smoothed = smooth(exact_lines_through(points));
  ASSERT_EQ(smoothed.segments.size(), 1U);
  const PathSegment& segment = smoothed.segments[0];
  EXPECT_EQ(segment.mode, parser::PathMode::exact_path);
  EXPECT_EQ(curves::position_at(segment.curve, 1e9), points.back());
  EXPECT_EQ(smoothed.deviation.distance_mm, 0.0);
  ASSERT_EQ(segment.marks.size(), 100U);
  for (std::size_t i = 0; i < segment.marks.size(); ++i) {
    EXPECT_EQ(segment.marks[i].line, i + 1);
    const Position at = curves::position_at(segment.curve, segment.marks[i].s_mm);
    EXPECT_LE((vec(at) - vec(points[i])).norm(), 1e-12) << i;
  }
}

std::vector<Position> ends_of_exact(const std::vector<Position>& points) {
  std::vector<Position> ends;
  for (const PathSegment& segment : smooth(exact_lines_through(points)).segments) {
    ends.push_back(curves::position_at(segment.curve, 1e9));
  }
  return ends;
}

TEST(ExactLines, StayWhereTheyTurnByMoreThanRoundingOrLeadBack) {
  EXPECT_EQ(ends_of_exact({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 4e-9, 0}, {4, 0, 0}, {5, 0, 0}}),
            (std::vector<Position>{{2, 0, 0}, {3, 4e-9, 0}, {4, 0, 0}, {5, 0, 0}}));
  EXPECT_EQ(ends_of_exact({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.5, 0, 0}, {3.5, 0, 0}, {5, 0, 0}}),
            (std::vector<Position>{{2, 0, 0}, {1.5, 0, 0}, {5, 0, 0}}));
}

// A bow of 4 um over 20 mm, in lines that turn by 8e-7 rad each.
TEST(ExactLines, FollowABowWithinANanometre) {
  std::vector<Position> points;
  for (int i = 0; i <= 1000; ++i) {
    const double x = 0.02 * i;
    points.push_back({x, 4e-8 * x * (20.0 - x), 0.0});
  }
  const auto moves = exact_lines_through(points);
  const Smoothed smoothed = smooth(moves);
  EXPECT_GT(smoothed.segments.size(), 20U);
  std::size_t next = 0;
  for (const PathSegment& segment : smoothed.segments) {
    const double length = curves::length_mm(segment.curve);
    const Position begin = curves::position_at(segment.curve, 0.0);
    const Eigen::Vector3d along =
        (vec(curves::position_at(segment.curve, length)) - vec(begin)) / length;
    for (const std::size_t last = next + std::max<std::size_t>(segment.marks.size(), 1);
         next < last; ++next) {
      const Eigen::Vector3d seen = vec(points[next]) - vec(begin);
      EXPECT_LE((seen - seen.dot(along) * along).norm(), 1e-9) << next;
    }
  }
  EXPECT_EQ(next, moves.size());
}

TEST(ExactLines, StayWithAFeedrateOrAStopOfTheirOwn) {
  const std::vector<Position> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  std::vector<parser::Move> moves = exact_lines_through(points);
  moves[1].feedrate_mm_s *= 0.5;
  EXPECT_EQ(smooth(moves).segments.size(), 3U);
  moves = exact_lines_through(points);
  for (parser::Move& move : moves) {
    move.mode = parser::PathMode::exact_stop;
  }
  EXPECT_EQ(smooth(moves).segments.size(), 3U);
}

// Each takes 10 ms at the most, and all of them 100: who switches single block on waits no longer.
TEST(ExactLines, StayWhereTheyTakeLong) {
  EXPECT_EQ(ends_of_exact({{0, 0, 0}, {2.6, 0, 0}, {5.2, 0, 0}}).size(), 2U);
  std::vector<Position> points;
  for (int i = 0; i <= 100; ++i) {
    points.push_back({1.0 * i, 0.0, 0.0});
  }
  EXPECT_EQ(ends_of_exact(points),
            (std::vector<Position>{{25, 0, 0}, {50, 0, 0}, {75, 0, 0}, {100, 0, 0}}));
}

}  // namespace
}  // namespace kerf::test
