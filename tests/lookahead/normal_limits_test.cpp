// Limits across the path, against closed forms and finite differences of planned positions.
#include "lookahead/path/normal_limits.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lookahead/path/feed_scan.hpp"
#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/motion.hpp"

namespace kerf::lookahead::test {
namespace {

using curves::testing::shipped_curve;
using profiles::Profile;
using profiles::ProfileKind;

constexpr double kNormalAcceleration_mm_s2 = 800.0;
constexpr double kNormalJerk_mm_s3 = 40'000.0;

PlanLimits with_normal_limits(double acceleration_mm_s2, double jerk_mm_s3) {
  PlanLimits limits = butterfly_limits();
  limits.normal_acceleration_mm_s2 = acceleration_mm_s2;
  limits.normal_jerk_mm_s3 = jerk_mm_s3;
  return limits;
}

struct Across {
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;
};

// The largest of second differences of positions across the path, at four phases of the ticks. A
// circle with that acceleration at the feedrate has the jerk a^2 / v.
Across max_across(const Block& block, const PlanLimits& limits, ProfileKind kind) {
  const Motion motion = plan({block}, {.limits = limits, .profile = Profile(kind)});
  const double ts = limits.period_s;
  const auto at = [&](double t_s) {
    return Eigen::Vector3d(
        curves::vec(curves::derivatives_at(block.curve, motion.at(t_s).s_mm).position_mm));
  };
  Across most;
  for (double t = ts; t + ts < motion.duration_s(); t += 0.25 * ts) {
    const Eigen::Vector3d before = at(t - ts);
    const Eigen::Vector3d here = at(t);
    const Eigen::Vector3d after = at(t + ts);
    const Eigen::Vector3d along = (after - before).normalized();
    const Eigen::Vector3d second = (after - 2.0 * here + before) / (ts * ts);
    const double across = (second - second.dot(along) * along).norm();
    most.acceleration_mm_s2 = std::max(most.acceleration_mm_s2, across);
    const double v = motion.at(t).v_mm_s;
    if (v > 1.0) {
      most.jerk_mm_s3 = std::max(most.jerk_mm_s3, across * across / v);
    }
  }
  return most;
}

TEST(NormalLimits, OnACircleAreClosedForms) {
  const PlanLimits limits = with_normal_limits(500.0, 90'000.0);
  // The jerk binds where the radius is below A^3 / J^2.
  const double even_mm = std::pow(500.0, 3) / std::pow(90'000.0, 2);
  const Bound wide = normal_bound(1.0 / 5.0, limits);
  EXPECT_DOUBLE_EQ(wide.value, std::sqrt(500.0 * 5.0));
  EXPECT_EQ(wide.from, Constraint::path_acceleration);
  const Bound tight = normal_bound(1.0 / (0.5 * even_mm), limits);
  EXPECT_NEAR(tight.value, std::cbrt(90'000.0 * std::pow(0.5 * even_mm, 2)), 1e-12);
  EXPECT_EQ(tight.from, Constraint::path_jerk);
  EXPECT_EQ(normal_bound(0.0, limits).value, kUnbounded);
}

TEST(NormalLimits, BoundAnArcAsItsCurve) {
  const PlanLimits limits = with_normal_limits(kNormalAcceleration_mm_s2, kUnbounded);
  const auto blocks =
      blocks_of({arc_move({.ends = {{5, 0, 0}, {5, 0, 0}}, .centre = {0, 0, 0}}, 100.0)}, limits);
  const double v = std::sqrt(kNormalAcceleration_mm_s2 * 5.0);
  EXPECT_DOUBLE_EQ(blocks[0].limits.feedrate_mm_s, v);
  EXPECT_EQ(blocks[0].limits.from.feedrate, Constraint::path_acceleration);
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const Across most = max_across(blocks[0], limits, kind);
    EXPECT_LE(most.acceleration_mm_s2, kNormalAcceleration_mm_s2 * (1.0 + 1e-6));
    EXPECT_GE(most.acceleration_mm_s2, kNormalAcceleration_mm_s2 * 0.99);
  }
}

TEST(NormalLimits, OfAccelerationAreKeptByTheTicksOfCurvesAndReached) {
  const PlanLimits limits = with_normal_limits(kNormalAcceleration_mm_s2, kUnbounded);
  for (const char* name : {"butterfly", "trident7", "star", "scroll"}) {
    const Block block = blocks_of({nurbs_move(shipped_curve(name), 100.0)}, limits).front();
    for (const ProfileKind kind :
         {ProfileKind::s_curve, ProfileKind::sigmoid, ProfileKind::time_optimal}) {
      SCOPED_TRACE(std::string(name) + " " + std::string(profiles::name_of(kind)));
      const Across most = max_across(block, limits, kind);
      EXPECT_LE(most.acceleration_mm_s2, kNormalAcceleration_mm_s2 * (1.0 + 1e-3));
      EXPECT_GE(most.acceleration_mm_s2, kNormalAcceleration_mm_s2 * 0.97);
    }
  }
}

TEST(NormalLimits, OfJerkAreKeptByTheTicksOfCurvesAndReached) {
  const PlanLimits limits = with_normal_limits(kUnbounded, kNormalJerk_mm_s3);
  for (const char* name : {"butterfly", "trident7", "star"}) {
    const Block block = blocks_of({nurbs_move(shipped_curve(name), 100.0)}, limits).front();
    for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
      SCOPED_TRACE(std::string(name) + " " + std::string(profiles::name_of(kind)));
      const Across most = max_across(block, limits, kind);
      EXPECT_LE(most.jerk_mm_s3, kNormalJerk_mm_s3 * (1.0 + 3e-3));
      EXPECT_GE(most.jerk_mm_s3, kNormalJerk_mm_s3 * 0.95);
    }
  }
}

TEST(NormalLimits, LeaveTheLimitCurveToTheBitWhereTheyAreNotSet) {
  const curves::NurbsCurve curve = smooth_curve(shipped_curve("butterfly"));
  const VelocityLimitCurve scanned =
      scan_feedrate(curve, {.feedrate_mm_s = 100.0, .chord_tolerance_mm = 5e-4});
  VelocityLimitCurve lowered = scanned;
  lower_to_normal_limits(curve, butterfly_limits(), lowered);
  ASSERT_EQ(lowered.size(), scanned.size());
  for (std::size_t i = 0; i < scanned.size(); ++i) {
    ASSERT_EQ(lowered[i].v_mm_s, scanned[i].v_mm_s);
    ASSERT_EQ(lowered[i].s_mm, scanned[i].s_mm);
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
