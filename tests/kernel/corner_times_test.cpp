// Corners in G64 at feedrates that a cruise between them reaches: where the braking for a corner
// begins on the line before it.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"
#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

// A cruise of the time optimum may be as much below the feedrate (ARCHITECTURE.md).
constexpr double kCruise = 5e-4;

// A star of five points in one stroke: turns of 144 degrees.
std::string star(double tolerance_mm, double feedrate_mm_min) {
  std::string text =
      "G64 P" + std::to_string(tolerance_mm) + " Q0 F" + std::to_string(feedrate_mm_min) + "\n";
  for (int i = 1; i <= 5; ++i) {
    const double angle = 0.8 * std::numbers::pi * i;
    text += "G1 X" + std::to_string(30.0 * std::sin(angle)) + " Y" +
            std::to_string(30.0 * std::cos(angle) - 30.0) + "\n";
  }
  return text + "M2\n";
}

double ticks_by(ProfileKind kind, const std::string& text) {
  return static_cast<double>(ticks_of(text, {.profile = Profile{kind}}).size());
}

TEST(CornerTimes, AreNoLongerByTheTimeOptimumThanByTheSCurve) {
  for (const double feedrate : {300.0, 600.0, 1200.0, 3000.0}) {
    for (const double tolerance : {0.01, 0.03, 0.1}) {
      const std::string text = star(tolerance, feedrate);
      EXPECT_LE(ticks_by(ProfileKind::time_optimal, text),
                ticks_by(ProfileKind::s_curve, text) * (1.0 + kCruise))
          << feedrate << ' ' << tolerance;
    }
  }
  const std::string corner = "G64 P0.01 Q0 F350\nG1 X40 Y0\nX40 Y40\nM2\n";
  EXPECT_LE(ticks_by(ProfileKind::time_optimal, corner),
            ticks_by(ProfileKind::s_curve, corner) * (1.0 + kCruise));
}

TEST(CornerTimes, AreNoLongerWithALargerTolerance) {
  for (const double feedrate : {300.0, 600.0, 3000.0}) {
    double before = ticks_by(ProfileKind::time_optimal, star(0.003, feedrate));
    for (const double tolerance : {0.01, 0.03, 0.1}) {
      const double ticks = ticks_by(ProfileKind::time_optimal, star(tolerance, feedrate));
      EXPECT_LE(ticks, before * (1.0 + kCruise)) << feedrate << ' ' << tolerance;
      before = ticks;
    }
  }
}

// Lines of 0.02 mm at 250 mm/s: twelve in a tick, and less way in a look-ahead of 1,000 than to
// rest.
TEST(CornerTimes, AreNoneOnExactLinesThatGoOnStraight) {
  std::string text = "G61 F15000\n";
  for (int i = 1; i <= 5000; ++i) {
    text += "G1 X" + std::to_string(0.02 * i) + " Y" + std::to_string(0.012 * i) + "\n";
  }
  EXPECT_LE(ticks_by(ProfileKind::time_optimal, text + "M2\n"),
            ticks_by(ProfileKind::time_optimal, "G61 F15000\nG1 X100 Y60\nM2\n") + 1.0);
}

}  // namespace
}  // namespace kerf::test
