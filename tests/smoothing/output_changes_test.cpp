// Where on a smoothed path outputs change that change with motion (M62, M63, M67).
#include "smoothing/output_changes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "smoothing/smoother.hpp"
#include "tests/smoothing/polylines.hpp"

namespace kerf::test {
namespace {

using curves::Position;
using parser::Move;
using smoothing::PathSegment;

// With an analog output that takes the move's number, before each of these moves.
std::vector<Move> with_changes(const std::vector<Move>& moves, const std::set<std::uint64_t>& at) {
  std::vector<Move> all;
  for (const Move& move : moves) {
    if (at.contains(move.block)) {
      Move& event = all.emplace_back();
      event.shape = parser::EventMove{.kind = parser::EventKind::analog_at_motion,
                                      .value = static_cast<double>(move.block)};
    }
    all.push_back(move);
  }
  return all;
}

std::vector<PathSegment> smoothed(const std::vector<Move>& moves) {
  smoothing::Smoother smoother({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 50000.0});
  std::vector<PathSegment> segments;
  const auto take = [&] {
    for (smoothing::Smoother::Output output; smoother.next(output);) {
      segments.push_back(std::get<PathSegment>(std::move(output)));
    }
  };
  for (const Move& move : moves) {
    EXPECT_TRUE(smoother.push(move).has_value());
    take();
  }
  smoother.flush();
  take();
  return segments;
}

double length_of(const std::vector<PathSegment>& segments) {
  double length_mm = 0.0;
  for (const PathSegment& segment : segments) {
    length_mm += curves::length_mm(segment.curve);
  }
  return length_mm;
}

Position at(const std::vector<PathSegment>& segments, double s_mm) {
  for (const PathSegment& segment : segments) {
    const double length_mm = curves::length_mm(segment.curve);
    if (s_mm <= length_mm) {
      return curves::position_at(segment.curve, s_mm);
    }
    s_mm -= length_mm;
  }
  return curves::position_at(segments.back().curve, curves::length_mm(segments.back().curve));
}

// A circle of short lines, which is merged, between two long lines, whose corners are blended.
std::vector<Move> circle_between_lines() {
  std::vector<Position> points{{0.0, -30.0, 0.0}};
  for (int i = 0; i <= 90; ++i) {
    const double angle = 2.0 * std::numbers::pi / 120.0 * i;
    points.push_back({10.0 * std::cos(angle) - 10.0, 10.0 * std::sin(angle), 0.0});
  }
  points.push_back({-40.0, -10.0, 0.0});
  points.push_back({-40.0, 20.0, 0.0});
  return lines_through(points, {});
}

std::set<std::uint64_t> every(std::uint64_t step, std::size_t moves) {
  std::set<std::uint64_t> blocks;
  for (std::uint64_t block = 1; block <= moves; block += step) {
    blocks.insert(block);
  }
  return blocks;
}

TEST(OutputChangesOnThePath, LeaveThePathAsItIs) {
  const std::vector<Move> moves = circle_between_lines();
  const std::vector<PathSegment> plain = smoothed(moves);
  for (const std::uint64_t step : {1U, 2U, 5U, 91U}) {
    const std::vector<PathSegment> cut = smoothed(with_changes(moves, every(step, moves.size())));
    const double length_mm = length_of(plain);
    ASSERT_NEAR(length_of(cut), length_mm, 1e-9) << step;
    for (int i = 0; i <= 5000; ++i) {
      const double s = length_mm * i / 5000.0;
      ASSERT_LT((curves::vec(at(plain, s)) - curves::vec(at(cut, s))).norm(), 1e-9) << step;
    }
  }
}

TEST(OutputChangesOnThePath, ComeWhereTheirMovesBegin) {
  const std::vector<Move> moves = circle_between_lines();
  for (const std::uint64_t step : {1U, 2U, 5U, 91U}) {
    const std::set<std::uint64_t> wanted = every(step, moves.size());
    std::set<std::uint64_t> found;
    for (const PathSegment& segment : smoothed(with_changes(moves, wanted))) {
      for (const parser::EventMove& change : segment.changes) {
        const auto block = static_cast<std::uint64_t>(change.value);
        found.insert(block);
        EXPECT_EQ(segment.mark_at(0.0).run_block, block);
        EXPECT_EQ(segment.run_block, block);
        const Position& begin = moves[block - 1].start_mm;
        EXPECT_LT(
            (curves::vec(curves::position_at(segment.curve, 0.0)) - curves::vec(begin)).norm(),
            0.05)
            << "P and Q, and the way from the corner to the blend's middle";
      }
    }
    EXPECT_EQ(found, wanted);
  }
}

// Found by a review: a blend takes the last lines of a row, and the row still had their marks. And
// a vertex within a nanometre of where the blend begins.
TEST(OutputChangesOnThePath, ComeWhereTheirMovesBeginInABlendThatTakesSeveralLines) {
  for (int i = -30; i <= 30; ++i) {
    std::vector<Position> points;
    for (int x = 0; x <= 48; ++x) {
      points.push_back({static_cast<double>(x), 0.0, 0.0});
    }
    points.push_back({49.434880 + 1e-7 * i, 0.0, 0.0});
    points.push_back({50.0, 0.0, 0.0});
    points.push_back({50.0, 0.6, 0.0});
    for (int y = 1; y <= 49; ++y) {
      points.push_back({50.0, static_cast<double>(y), 0.0});
    }
    const std::vector<Move> moves = lines_through(points, {.corner_mm = 0.1, .merge_mm = 0.02});
    const std::set<std::uint64_t> wanted = every(1, moves.size());
    std::set<std::uint64_t> found;
    for (const PathSegment& segment : smoothed(with_changes(moves, wanted))) {
      const Position place = curves::position_at(segment.curve, 0.0);
      for (const parser::EventMove& change : segment.changes) {
        const auto block = static_cast<std::uint64_t>(change.value);
        found.insert(block);
        const Position& begin = moves[block - 1].start_mm;
        EXPECT_LT((curves::vec(place) - curves::vec(begin)).norm(), 0.12) << i << ", " << block;
      }
    }
    EXPECT_EQ(found, wanted) << i;
  }
}

TEST(OutputChangesOnThePath, LeaveAPartTheMarksOfItsOwnLines) {
  std::vector<Position> points;
  for (int x = 0; x <= 1000; ++x) {
    points.push_back({0.1 * x, 0.0, 0.0});
  }
  const std::vector<Move> moves = lines_through(points, {});
  const std::vector<PathSegment> parts = smoothed(with_changes(moves, every(2, moves.size())));
  ASSERT_EQ(parts.size(), 500U);
  for (const PathSegment& part : parts) {
    EXPECT_EQ(part.marks.size(), 2U);
    EXPECT_LE(part.marks.capacity(), 4U)
        << "many thousand parts of a row had those of all its lines";
  }
}

// Between two long lines a line of micrometres is none of the path's, but what changes there does.
TEST(OutputChangesOnThePath, ComeWithALineThatIsAsGoodAsNone) {
  const std::vector<Move> moves =
      lines_through({{0, 0, 0}, {10, 0, 0}, {10, 1e-6, 0}, {10, 10, 0}}, {});
  std::map<double, Position> found;
  for (const PathSegment& segment : smoothed(with_changes(moves, {2, 3}))) {
    for (const parser::EventMove& change : segment.changes) {
      found[change.value] = curves::position_at(segment.curve, 0.0);
    }
  }
  ASSERT_EQ(found.size(), 2U);
  for (const auto& [block, place] : found) {
    EXPECT_LT((curves::vec(place) - Eigen::Vector3d(10, 0, 0)).norm(), 0.05) << block;
  }
}

}  // namespace
}  // namespace kerf::test
