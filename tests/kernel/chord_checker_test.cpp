// The judge of chord errors, judged.
#include "tests/kernel/chord_checker.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

interp::Setpoint tick_at(double x_mm) {
  interp::Setpoint setpoint;
  setpoint.position_mm = {x_mm, 0.0, 0.0};
  setpoint.line = 1;
  return setpoint;
}

// An arc tangent, on which whole steps of Newton's method lead to and fro between the ends.
TEST(ChordChecker, FindsTicksHoweverThePathsSpeedOverItsParameterChanges) {
  const auto x_at = [](double u) { return std::atan(40.0 * (u - 0.5)); };
  const std::vector<Stretch> path{{.at_mm =
                                       [&](double u) {
                                         return Vec{x_at(u), 0.0, 0.0};
                                       },
                                   .line = 1}};
  for (const double u : {0.3, 0.45, 0.5, 0.55, 0.9}) {
    ChordChecker checker(path, 1e-3);
    checker.add(tick_at(x_at(0.01)), 0.0);
    checker.add(tick_at(x_at(u)), 0.0);
    checker.add(tick_at(x_at(0.99)), 0.0);
    EXPECT_EQ(checker.complaint(), "") << u;
  }
}

TEST(ChordChecker, ComplainsAboutATickBesideThePath) {
  const std::vector<Stretch> path{{.at_mm = [](double u) { return Vec{u, 1e-8, 0.0}; }, .line = 1}};
  ChordChecker checker(path, 1e-3);
  checker.add(tick_at(0.5), 0.0);
  EXPECT_NE(checker.complaint(), "");
}

}  // namespace
}  // namespace kerf::test
