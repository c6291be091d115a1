// Ticks of motion made by hand: places, times, the last tick, starvation, the chord.
#include "interp/interpolator.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"
#include "tests/curves/reference_nurbs.hpp"
#include "tests/curves/shipped_curves.hpp"

namespace kerf::interp::test {
namespace {

using curves::Arc;
using curves::Line;
using curves::NurbsCurve;
using curves::testing::Wide;
using profiles::Profile;
using profiles::ProfileKind;
using profiles::Transition;

constexpr double kTs = 0.001;
constexpr profiles::RampLimits kRamp{.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4};

// Pushes laws one behind the other along curves, as the planner does.
class Script {
 public:
  explicit Script(const Position& start_mm = {})
      : queue_(std::make_unique<MotionQueue>()),
        interpolator_(std::make_unique<Interpolator>(*queue_, kTs, start_mm)) {}

  void curve(const curves::Curve& curve) {
    path_begin_mm_ += s_mm_;
    s_mm_ = 0.0;
    ++curve_;
    curves::for_each_piece(curve, [this](const curves::Piece& piece) {
      ASSERT_TRUE(queue_->push(PathPiece{.curve = curve_, .geometry = piece}));
    });
  }

  void law(const Transition& law) { push(law, s_mm_ + law.length_mm(), {}); }
  // The last of a motion: the next one begins on a tick.
  void law_to_rest(const Transition& law, double s_end_mm) {
    EXPECT_NEAR(s_mm_ + law.length_mm(), s_end_mm, 1e-9);
    push(law, s_end_mm, {.at_rest = true});
    to_next_tick();
  }
  void rest(double duration_s, bool ends_program) {
    push(Transition::rest(duration_s), s_mm_, {.at_rest = true, .program = ends_program});
    to_next_tick();
  }

  Interpolator& interpolator() { return *interpolator_; }
  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }

  // From rest to rest over length_mm, by one profile, without a cruise.
  void hill(double length_mm, const Profile& profile) {
    const double v = profile.peak_mm_s({}, {.length_mm = length_mm, .v_cap_mm_s = 1e9}, kRamp);
    law(profile.fastest({0.0, v}, kRamp));
    law_to_rest(profile.fastest({v, 0.0}, kRamp), length_mm);
  }

 private:
  struct Ends {
    bool at_rest = false;
    bool program = false;
  };
  void push(const Transition& law, double s_end_mm, const Ends& ends) {
    const double tick = std::floor(time_s_ / kTs + 1e-9);
    Phase phase{.curve = curve_,
                .begin = {.tick = static_cast<std::int64_t>(tick),
                          .offset_s = std::max(time_s_ - tick * kTs, 0.0)},
                .s_begin_mm = s_mm_,
                .s_end_mm = s_end_mm,
                .path_begin_mm = path_begin_mm_,
                .law = law,
                .line = 3,
                .ends_at_rest = ends.at_rest,
                .ends_program = ends.program};
    ASSERT_TRUE(queue_->push(phase));
    phases_.push_back(phase);
    s_mm_ = phase.s_end_mm;
    time_s_ += law.duration_s();
  }
  void to_next_tick() { time_s_ = std::ceil(time_s_ / kTs - 1e-9) * kTs; }

  std::unique_ptr<MotionQueue> queue_;
  std::unique_ptr<Interpolator> interpolator_;
  std::vector<Phase> phases_;
  std::uint64_t curve_ = 0;
  double s_mm_ = 0.0;
  double path_begin_mm_ = 0.0;
  double time_s_ = 0.0;
};

Line line(const Position& from, const Position& to) {
  return Line::between(from, to).value();
}

TEST(Interpolator, IsAtTheLawsLengthAtEveryTick) {
  Script script;
  script.curve(line({0, 0, 0}, {30, 40, 0}));
  const Profile profile{ProfileKind::s_curve};
  script.hill(50.0, profile);
  script.rest(0.0, true);
  const Transition& up = script.phases()[0].law;
  const Transition& down = script.phases()[1].law;
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
  // The first tick at or behind the end.
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
  const Transition& up = starved.phases()[2].law;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(starved.interpolator().next(setpoint), TickStatus::running);
    EXPECT_NEAR(setpoint.position_mm[0], 2.0 + up.at(i * kTs).s_mm, 1e-12);
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

TEST(ChordError, OfAnArcIsTheSagittaOfOneTick) {
  const double radius = 10.0;
  const auto arc =
      Arc::make({.start_mm = {radius, 0, 0}, .end_mm = {0, radius, 0}, .centre_mm = {0, 0, 0}})
          .value();
  Script script({radius, 0, 0});
  script.curve(arc);
  script.hill(arc.length_mm(), Profile{ProfileKind::s_curve});
  script.rest(0.0, true);
  Setpoint setpoint;
  double s_before = 0.0;
  double largest = 0.0;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    const double half_angle = 0.5 * (setpoint.s_mm - s_before) / radius;
    const double sagitta = radius * (1.0 - std::cos(half_angle));
    ASSERT_NEAR(script.interpolator().chord_error_mm(), sagitta, 1e-9);
    largest = std::max(largest, sagitta);
    s_before = setpoint.s_mm;
  }
  EXPECT_GT(largest, 1e-6);
}

TEST(ChordError, OfALineIsNothing) {
  Script script;
  script.curve(line({0, 0, 0}, {3, 4, 5}));
  script.hill(std::sqrt(50.0), Profile{ProfileKind::s_curve});
  script.rest(0.0, true);
  Setpoint setpoint;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    ASSERT_NEAR(script.interpolator().chord_error_mm(), 0.0, 1e-12);
  }
}

TEST(ChordError, OfACornerPassedBetweenTicksIsTheCornersDistance) {
  Script script;
  const double v = 40.0;
  script.curve(line({0, 0, 0}, {1.02, 0, 0}));
  script.law(Transition::cruise(v, 1.02));
  script.curve(line({1.02, 0, 0}, {1.02, 1, 0}));
  script.law(Transition::cruise(v, 1.0));
  Setpoint setpoint;
  double largest = 0.0;
  for (int i = 0; i < 50; ++i) {
    script.interpolator().next(setpoint);
    largest = std::max(largest, script.interpolator().chord_error_mm());
  }
  // Ticks 0.02 mm before and behind a right angle: its height over the hypotenuse.
  EXPECT_NEAR(largest, 0.02 / std::sqrt(2.0), 1e-9);
}

// The largest distance of 64 points of the curve between two arc lengths from their chord.
double many_points_mm(const NurbsCurve& curve, double s_from_mm, double s_to_mm) {
  const Position from = curve.at(s_from_mm);
  const Position to = curve.at(s_to_mm);
  const Eigen::Vector3d chord = curves::vec(to) - curves::vec(from);
  double largest = 0.0;
  for (int i = 1; i < 64 && chord.norm() > 0.0; ++i) {
    const Position point = curve.at(s_from_mm + (s_to_mm - s_from_mm) * i / 64.0);
    const Eigen::Vector3d offset = curves::vec(point) - curves::vec(from);
    const double share = std::clamp(offset.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    largest = std::max(largest, (offset - share * chord).norm());
  }
  return largest;
}

TEST(ChordError, OfACurveIsWhatManyPointsGive) {
  const auto parts = NurbsCurve::make(curves::testing::shipped_curve("rational4")).value();
  const NurbsCurve& curve = parts.front();
  Script script(curve.at(0.0));
  script.curve(curve);
  script.hill(curve.length_mm(), Profile{ProfileKind::s_curve});
  script.rest(0.0, true);
  Setpoint setpoint;
  double s_before = 0.0;
  double largest = 0.0;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    const double brute = many_points_mm(curve, s_before, setpoint.s_mm);
    ASSERT_NEAR(script.interpolator().chord_error_mm(), brute, 1e-10 + 0.01 * brute);
    largest = std::max(largest, brute);
    s_before = setpoint.s_mm;
  }
  EXPECT_GT(largest, 1e-6);
}

// The pieces of a curve are short where it is sharp: a tick may pass several of them.
TEST(ChordError, LooksAtPiecesThatATickPassesOver) {
  const auto parts = NurbsCurve::make(curves::testing::shipped_curve("butterfly")).value();
  const NurbsCurve& curve = parts.front();
  const double tick_mm = curve.length_mm() / 150.3;
  Script script(curve.at(0.0));
  script.curve(curve);
  script.law(Transition::cruise(tick_mm / kTs, curve.length_mm()));
  Setpoint setpoint;
  ASSERT_EQ(script.interpolator().next(setpoint), TickStatus::running);
  std::size_t most_passed = 0;
  for (double s = 0.0; s + tick_mm < curve.length_mm(); s += tick_mm) {
    ASSERT_EQ(script.interpolator().next(setpoint), TickStatus::running);
    most_passed = std::max(most_passed, curve.piece_index(s + tick_mm) - curve.piece_index(s));
    const double brute = many_points_mm(curve, s, s + tick_mm);
    ASSERT_NEAR(script.interpolator().chord_error_mm(), brute, 0.1 * brute) << setpoint.tick;
  }
  EXPECT_GE(most_passed, 5U);
}

TEST(ChordError, LooksAtBlocksThatATickPassesOver) {
  Script script;
  const std::vector<Position> corners{
      {0, 0, 0}, {1.005, 0, 0}, {1.02, 0, 0}, {1.02, 0.01, 0}, {1.0, 0.01, 0}};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Line leg = line(corners[i - 1], corners[i]);
    script.curve(leg);
    script.law(Transition::cruise(40.0, leg.length_mm()));
  }
  Setpoint setpoint;
  double largest = 0.0;
  for (int i = 0; i < 27; ++i) {
    script.interpolator().next(setpoint);
    largest = std::max(largest, script.interpolator().chord_error_mm());
  }
  // Ticks at (1, 0) and (1.01, 0.01): the joint of the two blocks between lies at (1.02, 0).
  EXPECT_NEAR(largest, 0.02 / std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace kerf::interp::test
