// The planner's stream: order, contiguity, ticks, windows of any size, stops where the program asks
// for them and nowhere else.
#include "lookahead/planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/motion.hpp"

namespace kerf::lookahead::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

constexpr double kTs = 0.001;

PlanLimits mill() {
  return axis_limits({.velocity_mm_s = 200.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 5e4});
}

// Lines, arcs, a helix and a curve, joined.
std::vector<parser::Move> mixed_moves() {
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
std::vector<parser::Move> polyline(int segments, double radius_mm, double feedrate_mm_s) {
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
std::vector<parser::Move> straight(int blocks, double length_mm, double feedrate_mm_s) {
  std::vector<parser::Move> moves;
  for (int i = 0; i < blocks; ++i) {
    moves.push_back(line_move({{i * length_mm, 0, 0}, {(i + 1) * length_mm, 0, 0}}, feedrate_mm_s));
  }
  return moves;
}

double total_length(const std::vector<Block>& blocks) {
  double sum = 0.0;
  for (const Block& block : blocks) {
    sum += block.length_mm;
  }
  return sum;
}

// Each phase begins where and when the one before ends, with its feedrate.
void expect_contiguous(const std::vector<interp::Phase>& phases) {
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
      EXPECT_EQ(phase.begin.offset_s, 0.0) << "a phase behind a rest begins on a tick";
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

TEST(Planner, EmitsContiguousPhasesUnderEveryLaw) {
  for (const ProfileKind kind :
       {ProfileKind::trapezoid, ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic,
        ProfileKind::sine_series, ProfileKind::sigmoid}) {
    SCOPED_TRACE(profiles::name_of(kind));
    PlanLimits limits = mill();
    limits.chord_tolerance_mm = 5e-4;
    const auto blocks = blocks_of(mixed_moves(), limits);
    const Motion motion = plan(blocks, {.limits = limits, .profile = Profile{kind}});
    expect_contiguous(motion.phases());
    EXPECT_TRUE(motion.phases().back().ends_program);
    EXPECT_TRUE(motion.phases().back().ends_at_rest);
    EXPECT_NEAR(motion.at(motion.duration_s()).s_mm, total_length(blocks), 1e-9);
  }
}

TEST(Planner, EmitsThePiecesOfACurveBeforeThePhasesOnIt) {
  PlanLimits limits = mill();
  limits.chord_tolerance_mm = 5e-4;
  Planner planner({.limits = limits});
  for (Block& block : blocks_of(mixed_moves(), limits)) {
    planner.push(std::move(block));
  }
  planner.finish(9);
  Outbox outbox;
  while (planner.emit(outbox)) {
    for (const interp::Phase& phase : outbox.phases) {
      const bool there =
          std::any_of(outbox.pieces.begin(), outbox.pieces.end(),
                      [&](const interp::PathPiece& piece) { return piece.curve == phase.curve; });
      ASSERT_TRUE(there || phase.curve == 0) << "curve " << phase.curve;
    }
  }
  for (std::size_t i = 1; i < outbox.pieces.size(); ++i) {
    const auto& before = outbox.pieces[i - 1];
    const auto& piece = outbox.pieces[i];
    EXPECT_TRUE(piece.curve == before.curve + 1 ||
                (piece.curve == before.curve &&
                 curves::s_begin_mm(piece.geometry) == curves::s_end_mm(before.geometry)));
  }
}

TEST(Planner, PlansOneLineAsTheClosedFormSays) {
  const PlanLimits limits =
      path_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  const auto blocks = blocks_of({line_move({{0, 0, 0}, {100, 0, 0}})}, limits);
  Planner planner({.limits = limits});
  const Outbox outbox = run(planner, blocks);
  // Up and down take V/A + A/J each; what is left of the way goes at V.
  const double up = 100.0 / 1000.0 + 1000.0 / 1e4;
  const double time = 2.0 * up + (100.0 - 100.0 * up) / 100.0;
  EXPECT_EQ(planner.totals().ticks, static_cast<std::int64_t>(std::ceil(time / kTs - 1e-6)));
  EXPECT_EQ(planner.totals().blocks, 1U);
  EXPECT_EQ(planner.totals().spans, 1U);
  EXPECT_EQ(planner.totals().path_length_mm, 100.0);
}

TEST(Planner, PassesCollinearLinesAsOne) {
  const PlanLimits limits =
      path_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  Planner one({.limits = limits});
  run(one, blocks_of({line_move({{0, 0, 0}, {100, 0, 0}})}, limits));
  Planner three({.limits = limits});
  // Cut within the cruise, which is from 10 mm to 90 mm.
  run(three, blocks_of({line_move({{0, 0, 0}, {20, 0, 0}}), line_move({{20, 0, 0}, {50, 0, 0}}),
                        line_move({{50, 0, 0}, {100, 0, 0}})},
                       limits));
  EXPECT_EQ(one.totals().ticks, three.totals().ticks);
}

TEST(Planner, PassesTangentLineArcLineWithoutStopping) {
  const PlanLimits limits = mill();
  const auto blocks =
      blocks_of({line_move({{0, 0, 0}, {30, 0, 0}}, 60.0),
                 arc_move({.ends = {{30, 0, 0}, {30, 20, 0}}, .centre = {30, 10, 0}}, 60.0),
                 line_move({{30, 20, 0}, {0, 20, 0}}, 60.0)},
                limits);
  const Motion motion = plan(blocks, {.limits = limits});
  expect_contiguous(motion.phases());
  int rests = 0;
  for (const interp::Phase& phase : motion.phases()) {
    rests += phase.ends_at_rest ? 1 : 0;
    if (!phase.ends_at_rest && phase.law.ramp().v_end_mm_s > 0.0) {
      EXPECT_GT(phase.law.ramp().v_end_mm_s, 1.0);
    }
  }
  EXPECT_EQ(rests, 2);  // the last motion, and the end of the program
  // At the joints the jump of curvature binds: 3/4 F^2 / (R Ts) + F^3 / R^2 = J.
  const double f = corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits);
  EXPECT_NEAR(0.75 * f * f / (10.0 * kTs) + f * f * f / 100.0, 5e4, 1e-2);
  for (const double joint : {30.0, 30.0 + 10.0 * std::numbers::pi}) {
    double v_at_joint = 0.0;
    for (double t = 0.0; t < motion.duration_s(); t += 1e-4) {
      const auto point = motion.at(t);
      v_at_joint = point.s_mm < joint ? point.v_mm_s : v_at_joint;
    }
    EXPECT_NEAR(v_at_joint, f, 1e-3 * f);
  }
}

TEST(Planner, StopsBetweenBlocksOfExactStop) {
  const PlanLimits limits = mill();
  auto moves = straight(3, 10.0, 50.0);
  moves[0].mode = parser::PathMode::exact_stop;
  const Motion motion = plan(blocks_of(moves, limits), {.limits = limits});
  std::vector<double> rests_at;
  for (const interp::Phase& phase : motion.phases()) {
    if (phase.ends_at_rest) {
      rests_at.push_back(phase.path_begin_mm + phase.s_end_mm);
    }
  }
  EXPECT_EQ(rests_at, (std::vector<double>{10.0, 30.0, 30.0}));
}

TEST(Planner, EndsAtRestWhateverTheWindow) {
  const PlanLimits limits = mill();
  PlanLimits with_chord = limits;
  with_chord.chord_tolerance_mm = 5e-4;
  const auto blocks = blocks_of(mixed_moves(), with_chord);
  const auto short_blocks = blocks_of(polyline(400, 20.0, 80.0), limits);
  for (const auto& program : {blocks, short_blocks}) {
    double time_before = 0.0;
    for (const std::size_t window : {1000U, 7U, 3U, 2U}) {
      SCOPED_TRACE(window);
      const Motion motion = plan(program, {.limits = with_chord, .window_blocks = window});
      expect_contiguous(motion.phases());
      const auto end = motion.at(motion.duration_s());
      EXPECT_EQ(end.v_mm_s, 0.0);
      EXPECT_NEAR(end.s_mm, total_length(program), 1e-9);
      EXPECT_GE(motion.duration_s(), time_before - 2.0 * kTs) << "less look-ahead, more time";
      time_before = motion.duration_s();
    }
  }
}

TEST(Planner, KeepsPathLimitsBetweenTheTicksInSmallWindows) {
  const PlanLimits limits =
      path_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 5e4});
  const auto blocks = blocks_of(straight(60, 0.7, 90.0), limits);
  for (const std::size_t window : {2U, 3U, 7U, 1000U}) {
    SCOPED_TRACE(window);
    const Motion motion = plan(blocks, {.limits = limits, .window_blocks = window});
    for (double t = 0.0; t < motion.duration_s(); t += 1e-4) {
      const auto point = motion.at(t);
      ASSERT_LE(point.v_mm_s, 90.0 * (1.0 + 1e-12));
      ASSERT_LE(std::abs(point.a_mm_s2), 2000.0 * (1.0 + 1e-9));
      ASSERT_LE(std::abs(point.j_mm_s3), 5e4 * (1.0 + 1e-9));
    }
  }
}

// Braking from 100 mm/s takes more than 5 mm: the last of blocks of 0.05 mm bends a hundred before
// it. Without jerk the ends of the blocks lie on v^2 = 2 A s exactly.
TEST(Planner, BrakesOverManyShortBlocks) {
  const PlanLimits limits = path_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0});
  const double length = 0.05;
  const int count = 400;
  const Motion motion = plan(blocks_of(straight(count, length, 100.0), limits),
                             {.limits = limits, .profile = Profile{ProfileKind::trapezoid}});
  for (const interp::Phase& phase : motion.phases()) {
    const double s = phase.path_begin_mm + phase.s_end_mm;
    const double allowed = std::min({100.0, std::sqrt(2.0 * 1000.0 * s),
                                     std::sqrt(2.0 * 1000.0 * std::max(count * length - s, 0.0))});
    EXPECT_NEAR(phase.law.ramp().v_end_mm_s, allowed, 1e-5);
  }
  const double time = 2.0 * 0.1 + (count * length - 2.0 * 5.0) / 100.0;
  EXPECT_NEAR(motion.duration_s(), std::ceil(time / kTs) * kTs, 1.5 * kTs);
}

TEST(Planner, CommitsLongCruisesInSlices) {
  const PlanLimits limits = mill();
  const Motion motion = plan(blocks_of({line_move({{0, 0, 0}, {500, 0, 0}}, 50.0)}, limits),
                             {.limits = limits, .longest_cruise_s = 0.1});
  expect_contiguous(motion.phases());
  EXPECT_GT(motion.phases().size(), 90U);
  for (const interp::Phase& phase : motion.phases()) {
    EXPECT_LE(phase.law.duration_s(), 0.2 + 1e-12);
  }
  const Motion whole = plan(blocks_of({line_move({{0, 0, 0}, {500, 0, 0}}, 50.0)}, limits),
                            {.limits = limits, .longest_cruise_s = 1e9});
  EXPECT_NEAR(motion.duration_s(), whole.duration_s(), 1e-9);
}

TEST(Planner, RestsForItsDurationOnTicks) {
  const PlanLimits limits = mill();
  Planner planner({.limits = limits});
  Outbox outbox;
  const auto blocks = blocks_of(straight(2, 10.0, 50.0), limits);
  planner.push(Block(blocks[0]));
  planner.push_rest(0.2505, 7);
  while (planner.emit(outbox)) {
  }
  planner.push(Block(blocks[1]));
  planner.finish(8);
  while (planner.emit(outbox)) {
  }
  expect_contiguous(outbox.phases);
  const auto rest = std::find_if(outbox.phases.begin(), outbox.phases.end(),
                                 [](const interp::Phase& phase) { return phase.line == 7; });
  ASSERT_NE(rest, outbox.phases.end());
  EXPECT_EQ(rest->begin.offset_s, 0.0);
  EXPECT_EQ(rest->law.duration_s(), 0.2505);
  EXPECT_EQ(std::next(rest)->begin.tick - rest->begin.tick, 251);
  EXPECT_EQ(rest->path_begin_mm + rest->s_end_mm, 10.0);
}

TEST(Planner, StopsOnRequestBelowThePlan) {
  const PlanLimits limits = mill();
  Planner planner({.limits = limits});
  for (Block& block : blocks_of(straight(40, 3.0, 100.0), limits)) {
    planner.push(std::move(block));
  }
  planner.finish(9);
  Outbox outbox;
  for (int i = 0; i < 15; ++i) {
    ASSERT_TRUE(planner.emit(outbox));
  }
  const interp::Phase& last = outbox.phases.back();
  const double v = last.law.ramp().v_end_mm_s;
  const double s = last.path_begin_mm + last.s_end_mm;
  ASSERT_GT(v, 50.0);
  planner.stop();
  while (planner.emit(outbox)) {
  }
  expect_contiguous(outbox.phases);
  const Motion motion(outbox.phases, kTs);
  const auto end = motion.at(motion.duration_s());
  EXPECT_EQ(end.v_mm_s, 0.0);
  // Over several short blocks, each ending with no acceleration, takes longer than one ramp, but
  // not much longer.
  const double ramp = v * (v / 2000.0 + 2000.0 / 5e4) / 2.0;
  EXPECT_GT(end.s_mm - s, 0.999 * ramp);
  EXPECT_LT(end.s_mm - s, 2.0 * ramp + 3.0);
}

// What the planner holds is bounded by its window, so the work for a block is, too: between two
// blocks that go in, only so many spans come out.
TEST(Planner, EmitsNoMoreAtOnceThanItsWindowHolds) {
  const PlanLimits limits = mill();
  const std::size_t window = 50;
  Planner planner({.limits = limits, .window_blocks = window});
  Outbox outbox;
  std::size_t held = 0;
  for (Block& block : blocks_of(polyline(3000, 100.0, 50.0), limits)) {
    while (!planner.wants_block()) {
      ASSERT_TRUE(planner.emit(outbox));
    }
    planner.push(std::move(block));
    ++held;
    const std::size_t begun = outbox.pieces.size();
    ASSERT_LE(held - begun, window);
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
