// The planner's stream: order, contiguity, ticks, windows of any size, stops where the program asks
// for them and nowhere else.
#include "lookahead/planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "lookahead/path/junction.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(Planner, EmitsContiguousPhasesUnderEveryLaw) {
  for (const ProfileKind kind :
       {ProfileKind::trapezoid, ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic,
        ProfileKind::sine_series, ProfileKind::sigmoid, ProfileKind::time_optimal}) {
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
                      [&](const interp::CurvePiece& piece) { return piece.curve == phase.curve; });
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
  EXPECT_EQ(planner.totals().segments, 1U);
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
  // At the junctions the jump of curvature binds: 3/4 F^2 / (R Ts) + F^3 / R^2 = J.
  const double f = corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits);
  EXPECT_NEAR(0.75 * f * f / (10.0 * kTs) + f * f * f / 100.0, 5e4, 1e-2);
  for (const double junction : {30.0, 30.0 + 10.0 * std::numbers::pi}) {
    double v_at_junction = 0.0;
    for (double t = 0.0; t < motion.duration_s(); t += 1e-4) {
      const auto point = motion.at(t);
      v_at_junction = point.s_mm < junction ? point.v_mm_s : v_at_junction;
    }
    EXPECT_NEAR(v_at_junction, f, 1e-3 * f);
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

// Under a jerk the most from which a line can be braked falls where its end need not be a rest any
// more, so what a small window promised may be more than the next one would. It has left by then.
TEST(Planner, KeepsInEachWindowWhatTheWindowBeforePromised) {
  const PlanLimits limits =
      path_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1100.0, .jerk_mm_s3 = 2e5});
  const unsigned seed = 20'261'122;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> size(-3.5, -1.0);
  for (int program = 0; program < 300; ++program) {
    std::vector<parser::Move> moves;
    for (double x = 0.0; moves.size() < 30;) {
      const double length = std::pow(10.0, size(random));
      moves.push_back(line_move({{x, 0, 0}, {x + length, 0, 0}}, 90.0));
      x += length;
    }
    const auto blocks = blocks_of(moves, limits);
    for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic,
                                   ProfileKind::sine_series, ProfileKind::sigmoid}) {
      for (const std::size_t window : {2U, 3U, 4U, 7U}) {
        SCOPED_TRACE(profiles::name_of(kind));
        SCOPED_TRACE(window);
        expect_contiguous(
            plan(blocks, {.limits = limits, .profile = Profile{kind}, .window_blocks = window})
                .phases());
        ASSERT_FALSE(testing::Test::HasFailure()) << "program " << program;
      }
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

}  // namespace
}  // namespace kerf::lookahead::test
