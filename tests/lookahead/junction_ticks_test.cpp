// The bound of a junction, against ticks laid over the junction at every phase.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lookahead/path/junction.hpp"
#include "tests/lookahead/blocks.hpp"

namespace kerf::lookahead::test {
namespace {

struct Differences {
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;
};

// The largest differences on any axis of ticks that pass the junction of two blocks at constant
// feedrate, for many phases of the ticks to the junction.
Differences largest_differences(const Block& before, const Block& after, double feedrate_mm_s) {
  const auto at = [&](double t) {
    const double s = feedrate_mm_s * t;
    return s < 0.0 ? curves::position_at(before.curve, before.length_mm + s)
                   : curves::position_at(after.curve, s);
  };
  Differences largest;
  for (int phase = 0; phase <= 100; ++phase) {
    for (int first = -4; first <= 1; ++first) {
      std::array<Position, 4> x{};
      for (int i = 0; i < 4; ++i) {
        x[static_cast<std::size_t>(i)] = at((first + i + phase / 100.0) * kTs);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = (x[2][k] - 2.0 * x[1][k] + x[0][k]) / (kTs * kTs);
        const double j = (x[3][k] - 3.0 * (x[2][k] - x[1][k]) - x[0][k]) / (kTs * kTs * kTs);
        largest.acceleration_mm_s2 = std::max(largest.acceleration_mm_s2, std::abs(a));
        largest.jerk_mm_s3 = std::max(largest.jerk_mm_s3, std::abs(j));
      }
    }
  }
  return largest;
}

// How far the path leaves the chord of any tick that sees the junction, passed at constant
// feedrate.
double largest_chord_error_mm(const Block& before, const Block& after, double feedrate_mm_s) {
  const auto at = [&](double s) {
    const Position point = s < 0.0 ? curves::position_at(before.curve, before.length_mm + s)
                                   : curves::position_at(after.curve, s);
    return Eigen::Vector3d(curves::vec(point));
  };
  const double tick_mm = feedrate_mm_s * kTs;
  double largest = 0.0;
  for (int phase = 0; phase <= 100; ++phase) {
    const double s_from = -tick_mm * phase / 100.0;
    const Eigen::Vector3d from = at(s_from);
    const Eigen::Vector3d chord = at(s_from + tick_mm) - from;
    for (int i = 1; i < 100; ++i) {
      const Eigen::Vector3d offset = at(s_from + tick_mm * i / 100.0) - from;
      const double share = std::clamp(offset.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      largest = std::max(largest, (offset - share * chord).norm());
    }
  }
  return largest;
}

struct JunctionCase {
  const char* name;
  parser::Move before;
  parser::Move after;
  MotionLimits axis;
  bool jerk_binds;
};

std::vector<JunctionCase> junction_cases() {
  const parser::Move quarter =
      arc_move({.ends = {{10, 0, 0}, {0, 10, 0}}, .centre = {0, 0, 0}});  // ends towards -x
  const parser::Move half_circle_on =
      arc_move({.ends = {{0, 10, 0}, {0, 30, 0}}, .centre = {0, 20, 0}, .clockwise = true});
  return {
      {"corner, acceleration",
       line_move({{0, 0, 0}, {10, 0, 0}}),
       line_move({{10, 0, 0}, {13, 4, 0}}),
       {.acceleration_mm_s2 = 5000.0},
       false},
      {"corner, jerk",
       line_move({{0, 0, 0}, {10, 0, 0}}),
       line_move({{10, 0, 0}, {20, 1, 0}}),
       {.acceleration_mm_s2 = 1e6, .jerk_mm_s3 = 5e6},
       true},
      {"tangent arc into line, jerk",
       quarter,
       line_move({{0, 10, 0}, {-20, 10, 0}}),
       {.jerk_mm_s3 = 2e5},
       true},
      {"tangent S of two arcs, jerk", quarter, half_circle_on, {.jerk_mm_s3 = 2e5}, true},
      {"arc into line with a corner",
       quarter,
       line_move({{0, 10, 0}, {-20, 11, 0}}),
       {.jerk_mm_s3 = 5e6},
       true},
  };
}

TEST(Junction, KeepsItsBoundInTicksAtEveryPhaseAndNearlyReachesIt) {
  for (const JunctionCase& junction : junction_cases()) {
    SCOPED_TRACE(junction.name);
    PlanLimits limits = axis_limits(junction.axis);
    const auto blocks = blocks_of({junction.before, junction.after}, limits);
    const double f = corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits);
    ASSERT_TRUE(std::isfinite(f));
    const Differences found = largest_differences(blocks[0], blocks[1], f);
    EXPECT_LE(found.acceleration_mm_s2, junction.axis.acceleration_mm_s2 * (1.0 + 1e-6));
    EXPECT_LE(found.jerk_mm_s3, junction.axis.jerk_mm_s3 * (1.0 + 1e-6));
    if (junction.jerk_binds) {
      EXPECT_GE(found.jerk_mm_s3, 0.75 * junction.axis.jerk_mm_s3);
    } else {
      EXPECT_GE(found.acceleration_mm_s2, 0.999 * junction.axis.acceleration_mm_s2);
    }
  }
}

TEST(Junction, KeepsTheChordToleranceInTicksAtEveryPhaseAndNearlyReachesIt) {
  for (const JunctionCase& junction : junction_cases()) {
    SCOPED_TRACE(junction.name);
    PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1e7, .jerk_mm_s3 = 1e10});
    limits.chord_tolerance_mm = 1e-3;
    const auto blocks = blocks_of({junction.before, junction.after}, limits);
    const double f = corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits);
    ASSERT_TRUE(std::isfinite(f));
    const double found_mm = largest_chord_error_mm(blocks[0], blocks[1], f);
    EXPECT_LE(found_mm, limits.chord_tolerance_mm * (1.0 + 1e-6));
    EXPECT_GE(found_mm, 0.85 * limits.chord_tolerance_mm);
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
