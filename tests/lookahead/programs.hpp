// Programs and what holds for every plan of one, for the tests of the planner.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/motion.hpp"

namespace kerf::lookahead::test {

using profiles::Profile;
using profiles::ProfileKind;

inline auto all_profiles() {
  return testing::Values(ProfileKind::trapezoid, ProfileKind::s_curve, ProfileKind::sine,
                         ProfileKind::quintic, ProfileKind::sine_series, ProfileKind::sigmoid,
                         ProfileKind::time_optimal);
}

inline PlanLimits mill() {
  return axis_limits({.velocity_mm_s = 200.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 5e4});
}

// Lines, arcs, a helix and a curve, joined.
inline std::vector<parser::Move> mixed_moves() {
  std::vector<parser::Move> moves{
      line_move({{0, 0, 0}, {30, 0, 0}}, 60.0),
      arc_move({.ends = {{30, 0, 0}, {30, 20, 0}}, .centre = {30, 10, 0}}, 60.0),
      line_move({{30, 20, 0}, {0, 20, 0}}, 80.0), line_move({{0, 20, 0}, {0, 19, 0}}, 80.0),
      arc_move({.ends = {{0, 19, 0}, {0, 19, 3}}, .centre = {0, 25, 0}, .clockwise = true}, 40.0)};
  curves::NurbsData curve = curves::testing::shipped_curve("rational4");
  moves.push_back(line_move({{0, 19, 3}, curve.points.front().position_mm}, 100.0));
  moves.push_back(nurbs_move(curve, 70.0));
  return moves;
}

// Short segments of a circle, as a CAM system writes it.
inline std::vector<parser::Move> polyline(int segments, double radius_mm, double feedrate_mm_s) {
  std::vector<parser::Move> moves;
  const auto at = [&](int i) {
    const double angle = 2.0 * std::numbers::pi * i / segments;
    return Position{radius_mm * std::cos(angle), radius_mm * std::sin(angle), 0.0};
  };
  for (int i = 0; i < segments; ++i) {
    moves.push_back(line_move({at(i), at(i + 1)}, feedrate_mm_s));
  }
  return moves;
}

// A straight line in many blocks of one length.
inline std::vector<parser::Move> straight(int blocks, double length_mm, double feedrate_mm_s) {
  std::vector<parser::Move> moves;
  for (int i = 0; i < blocks; ++i) {
    moves.push_back(line_move({{i * length_mm, 0, 0}, {(i + 1) * length_mm, 0, 0}}, feedrate_mm_s));
  }
  return moves;
}

inline double total_length(const std::vector<Block>& blocks) {
  double sum = 0.0;
  for (const Block& block : blocks) {
    sum += block.length_mm;
  }
  return sum;
}

// Each phase begins where and when the one before ends, with its feedrate.
inline void expect_contiguous(const std::vector<interp::Phase>& phases) {
  ASSERT_FALSE(phases.empty());
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const interp::Phase& phase = phases[i];
    ASSERT_GE(phase.begin.offset_s, 0.0);
    ASSERT_LT(phase.begin.offset_s, kTs);
    EXPECT_NEAR(phase.s_begin_mm + phase.law.length_mm(), phase.s_end_mm,
                1e-9 * (1.0 + phase.s_end_mm));
    if (i == 0) {
      continue;
    }
    const interp::Phase& before = phases[i - 1];
    const double gap_s = static_cast<double>(phase.begin.tick - before.begin.tick) * kTs +
                         phase.begin.offset_s - before.begin.offset_s - before.law.duration_s();
    if (before.ends_at_rest) {
      EXPECT_EQ(phase.begin.offset_s, 0.0) << "a phase after a rest begins on a tick";
      EXPECT_GE(gap_s, -1e-11);
      EXPECT_LT(gap_s, kTs);
      EXPECT_NEAR(before.law.ramp().v_end_mm_s, 0.0, 0.0);
    } else {
      EXPECT_NEAR(gap_s, 0.0, 1e-11);
    }
    EXPECT_NEAR(phase.law.ramp().v_begin_mm_s, before.law.ramp().v_end_mm_s, 1e-8);
    EXPECT_NEAR(phase.path_begin_mm + phase.s_begin_mm, before.path_begin_mm + before.s_end_mm,
                1e-9 * (1.0 + phase.path_begin_mm));
    if (testing::Test::HasFailure()) {
      FAIL() << "phase " << i;
    }
  }
}

}  // namespace kerf::lookahead::test
