// Ticks of motion made by hand: places, times, the last tick, starvation.
#include "interp/interpolator.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "tests/curves/reference_nurbs.hpp"
#include "tests/curves/shipped_curves.hpp"
#include "tests/interp/script.hpp"

namespace kerf::interp::test {
namespace {

using curves::testing::Wide;

TEST(Interpolator, IsAtTheLawsLengthAtEveryTick) {
  Script script;
  script.curve(line({0, 0, 0}, {30, 40, 0}));
  const Profile profile{ProfileKind::s_curve};
  script.hill(50.0, profile);
  script.rest(0.0, true);
  const profiles::TimeLaw& up = script.phases()[0].law;
  const profiles::TimeLaw& down = script.phases()[1].law;
  Setpoint setpoint;
  std::int64_t n = 0;
  for (auto status = TickStatus::running; status == TickStatus::running; ++n) {
    status = script.interpolator().next(setpoint);
    ASSERT_EQ(setpoint.tick, n);
    const double t = static_cast<double>(n) * kTs;
    const double s =
        t < up.duration_s() ? up.at(t).s_mm : up.length_mm() + down.at(t - up.duration_s()).s_mm;
    ASSERT_NEAR(setpoint.s_mm, s, 1e-10);
    ASSERT_NEAR(setpoint.position_mm[0], 0.6 * s, 1e-10);
    ASSERT_NEAR(setpoint.position_mm[1], 0.8 * s, 1e-10);
    ASSERT_NEAR(setpoint.velocity_mm_s[0], 0.6 * setpoint.v_mm_s, 1e-10);
    ASSERT_NEAR(setpoint.acceleration_mm_s2[1], 0.8 * setpoint.a_mm_s2, 1e-8);
  }
  EXPECT_EQ(setpoint.position_mm, (Position{30, 40, 0}));
  EXPECT_EQ(setpoint.v_mm_s, 0.0);
  EXPECT_EQ(setpoint.a_mm_s2, 0.0);
  EXPECT_EQ(setpoint.j_mm_s3, 0.0);
  // The first tick at or after the end.
  const double duration = up.duration_s() + down.duration_s();
  EXPECT_EQ(setpoint.tick, static_cast<std::int64_t>(std::ceil(duration / kTs - 1e-9)));
}

TEST(Interpolator, RepeatsTheLastSetpointOnceFinished) {
  Script script;
  script.curve(line({0, 0, 0}, {1, 0, 0}));
  script.hill(1.0, Profile{ProfileKind::quintic});
  script.rest(0.0, true);
  Setpoint setpoint;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
  }
  const std::int64_t last = setpoint.tick;
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(script.interpolator().next(setpoint), TickStatus::finished);
    EXPECT_EQ(setpoint.tick, last + i);
    EXPECT_EQ(setpoint.position_mm[0], 1.0);
  }
}

TEST(Interpolator, StarvesAtItsStartBeforeAnyMotion) {
  Script script({4, 5, 6});
  Setpoint setpoint;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(script.interpolator().next(setpoint), TickStatus::starved);
    EXPECT_EQ(setpoint.position_mm, (Position{4, 5, 6}));
    EXPECT_EQ(script.interpolator().plan_tick(), 0);
  }
}

TEST(Interpolator, ResumesFromRestAsThoughItHadNotStarved) {
  const Profile profile{ProfileKind::s_curve};
  Script starved;
  starved.curve(line({0, 0, 0}, {2, 0, 0}));
  starved.hill(2.0, profile);
  Setpoint setpoint;
  while (starved.interpolator().next(setpoint) == TickStatus::running) {
  }
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(starved.interpolator().next(setpoint), TickStatus::starved);
    EXPECT_EQ(setpoint.position_mm[0], 2.0);
    EXPECT_EQ(setpoint.v_mm_s, 0.0);
  }
  starved.curve(line({2, 0, 0}, {5, 0, 0}));
  starved.hill(3.0, profile);
  starved.rest(0.0, true);
  const profiles::TimeLaw& up = starved.phases()[2].law;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(starved.interpolator().next(setpoint), TickStatus::running);
    EXPECT_NEAR(setpoint.position_mm[0], 2.0 + up.at(i * kTs).s_mm, 1e-12);
  }
}

// Sums of durations round: what ends on a tick may be followed by what begins an instant after it.
TEST(Interpolator, GoesOnWhereThePhasesOfAMotionMeetOnATickButForRounding) {
  const auto queue = std::make_unique<MotionQueue>();
  Interpolator interpolator(*queue, kTs, {});
  curves::for_each_piece(curves::Curve(line({0, 0, 0}, {1, 0, 0})),
                         [&](const curves::Piece& piece) {
                           ASSERT_TRUE(queue->push(CurvePiece{.curve = 1, .geometry = piece}));
                         });
  const Phase first{.curve = 1, .s_end_mm = 0.5, .law = Transition::cruise(50.0, 0.5)};
  const Phase second{.curve = 1,
                     .begin = {.tick = 10, .offset_s = 1e-18},
                     .s_begin_mm = 0.5,
                     .s_end_mm = 1.0,
                     .law = Transition::cruise(50.0, 0.5)};
  ASSERT_EQ(first.law.duration_s(), 10 * kTs);
  ASSERT_TRUE(queue->push(first));
  ASSERT_TRUE(queue->push(second));
  queue->commit();
  Setpoint setpoint;
  for (int n = 0; n < 20; ++n) {
    ASSERT_EQ(interpolator.next(setpoint), TickStatus::running) << "tick " << n;
    EXPECT_EQ(interpolator.plan_tick(), n + 1);
    EXPECT_NEAR(setpoint.position_mm[0], 0.05 * n, 1e-12);
    EXPECT_EQ(setpoint.v_mm_s, 50.0);
  }
}

TEST(Interpolator, DwellsForWholeTicks) {
  Script script;
  script.curve(line({0, 0, 0}, {1, 0, 0}));
  script.hill(1.0, Profile{ProfileKind::s_curve});
  const double at_s = script.time_s();
  script.rest(0.0104, false);
  EXPECT_NEAR(script.time_s() - at_s, 0.011, 1e-12);
  script.curve(line({1, 0, 0}, {2, 0, 0}));
  script.hill(1.0, Profile{ProfileKind::s_curve});
  script.rest(0.0, true);
  Setpoint setpoint;
  int at_one = 0;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    at_one += setpoint.position_mm[0] == 1.0 ? 1 : 0;
  }
  EXPECT_EQ(at_one, 12);  // both ends of 11 periods
  EXPECT_EQ(setpoint.position_mm[0], 2.0);
}

// Arc length between ticks by quadrature of a second evaluator, against the plan's s(t).
TEST(Interpolator, FollowsEveryCurveWithoutFluctuation) {
  for (const auto& named : curves::testing::shipped_curves()) {
    SCOPED_TRACE(named.name);
    const auto parts = NurbsCurve::make(named.data).value();
    const NurbsCurve& curve = parts.front();
    Script script(curve.at(0.0));
    script.curve(curve);
    const double v = curve.length_mm() / 0.5;  // half a second from end to end
    const Transition up({0.0, v}, 0.1, profiles::Quintic{});
    script.law(up);
    script.law(Transition::cruise(v, curve.length_mm() - 2.0 * up.length_mm()));
    script.law_to_rest(up.reversed(), curve.length_mm());
    script.rest(0.0, true);
    Setpoint setpoint;
    double s_before = 0.0;
    Wide u_before = static_cast<Wide>(curve.pieces().front().u_begin);
    while (script.interpolator().next(setpoint) == TickStatus::running) {
      const double s = setpoint.s_mm;
      const std::size_t index = curve.piece_index(s);
      const auto u = static_cast<Wide>(curve.pieces()[index].u_at(s));
      // On the curve: the point of the second evaluator at the same parameter.
      const auto point = curves::testing::reference_point_mm(named.data, u);
      for (int k = 0; k < 3; ++k) {
        ASSERT_NEAR(setpoint.position_mm[static_cast<std::size_t>(k)],
                    static_cast<double>(point[k]), 1e-9);
      }
      if (s - s_before > 1e-3) {
        const auto length =
            static_cast<double>(curves::testing::reference_length_mm(named.data, u_before, u));
        ASSERT_NEAR(length / (s - s_before), 1.0, 1e-6) << "tick " << setpoint.tick;
      }
      s_before = s;
      u_before = u;
    }
    EXPECT_EQ(setpoint.position_mm, curve.pieces().back().end_mm);
  }
}

TEST(Interpolator, GivesVelocityAndAccelerationOfTheAxesOnAnArc) {
  const auto arc =
      Arc::make({.start_mm = {10, 0, 0}, .end_mm = {0, 10, 4}, .centre_mm = {0, 0, 0}}).value();
  Script script({10, 0, 0});
  script.curve(arc);
  script.hill(arc.length_mm(), Profile{ProfileKind::quintic});
  script.rest(0.0, true);
  std::vector<Setpoint> ticks(1);
  while (script.interpolator().next(ticks.back()) == TickStatus::running) {
    ticks.emplace_back();
  }
  for (std::size_t i = 1; i + 1 < ticks.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double before = ticks[i - 1].position_mm[k];
      const double now = ticks[i].position_mm[k];
      const double after = ticks[i + 1].position_mm[k];
      // Central differences; what they leave out is Ts^2 / 6 and Ts^2 / 12 of derivatives that are
      // below 2e4 mm/s3 and 2e6 mm/s4.
      ASSERT_NEAR(ticks[i].velocity_mm_s[k], (after - before) / (2.0 * kTs), 0.01);
      ASSERT_NEAR(ticks[i].acceleration_mm_s2[k], (after - 2.0 * now + before) / (kTs * kTs), 1.0);
    }
  }
}

}  // namespace
}  // namespace kerf::interp::test
