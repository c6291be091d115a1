#include "machine/path_history.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using kerf::curves::Position;
using kerf::machine::PathHistory;

TEST(PathHistory, OfOnePointIsThatPoint) {
  PathHistory path;
  path.restart({1.0, 2.0, 3.0});
  EXPECT_NEAR(path.distance_mm({1.0, 2.0, 3.5}), 0.5, 1e-15);
}

TEST(PathHistory, LagAlongThePathIsNoDistance) {
  PathHistory path;
  path.restart({0.0, 0.0, 0.0});
  for (int tick = 1; tick <= 500; ++tick) {
    path.append({0.1 * tick, 0.0, 0.0});
  }
  EXPECT_NEAR(path.distance_mm({47.77, 0.003, 0.004}), 0.005, 1e-12);
  EXPECT_NEAR(path.distance_mm({50.0, 0.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(path.distance_mm({50.2, 0.0, 0.0}), 0.2, 1e-12);  // ahead of it is off it
}

TEST(PathHistory, MeasuresToTheCornerThatIsCut) {
  PathHistory path;
  path.restart({0.0, 0.0, 0.0});
  for (int tick = 1; tick <= 10; ++tick) {
    path.append({0.1 * tick, 0.0, 0.0});
  }
  for (int tick = 1; tick <= 10; ++tick) {
    path.append({1.0, 0.1 * tick, 0.0});
  }
  EXPECT_NEAR(path.distance_mm({0.97, 0.05, 0.0}), 0.03, 1e-12);
  EXPECT_NEAR(path.distance_mm({0.9, 0.02, 0.0}), 0.02, 1e-12);
}

TEST(PathHistory, DoesNotTakeAnOldPassForTheOneThatIsFollowed) {
  PathHistory path;
  path.restart({0.0, 0.0, 0.0});
  for (int tick = 1; tick <= 100; ++tick) {
    path.append({0.1 * tick, 0.0, 0.0});
  }
  for (int tick = 0; tick <= 50; ++tick) {
    path.append({10.0 - 0.1 * tick, 0.1, 0.0});
  }
  // Nearer to the first pass at y = 0, but following the second at y = 0.1.
  EXPECT_NEAR(path.distance_mm({5.02, 0.02, 0.0}), 0.08, 1e-12);
}

TEST(PathHistory, IsNotUsedUpByDwellsAndSlowMotion) {
  PathHistory path;
  path.restart({0.0, 0.0, 0.0});
  for (int tick = 1; tick <= 20; ++tick) {
    path.append({0.1 * tick, 0.0, 0.0});
  }
  for (int tick = 1; tick <= 100'000; ++tick) {
    path.append({2.0 + 1e-8 * tick, 0.0, 0.0});
  }
  EXPECT_NEAR(path.distance_mm({1.23, 0.01, 0.0}), 0.01, 1e-12);
}

TEST(PathHistory, StrayBySlowMotionLessThanTheVertexSpacing) {
  PathHistory path;
  path.restart({1.0, 0.0, 0.0});
  constexpr double kStep = 1e-6;
  for (int tick = 1; tick <= 1'000'000; ++tick) {
    path.append({std::cos(kStep * tick), std::sin(kStep * tick), 0.0});
  }
  const double lag = 0.95;
  EXPECT_NEAR(path.distance_mm({1.01 * std::cos(lag), 1.01 * std::sin(lag), 0.0}), 0.01,
              PathHistory::kVertexSpacingMm);
}

TEST(PathHistory, IsNeverTooSmallWhenItIsTooShort) {
  PathHistory path;
  path.restart({0.0, 0.0, 0.0});
  for (int tick = 1; tick <= 5000; ++tick) {
    path.append({0.1 * tick, 0.0, 0.0});
  }
  EXPECT_GE(path.distance_mm({0.0, 0.0, 0.0}), 0.0);
  EXPECT_GT(path.distance_mm({0.0, 0.01, 0.0}), 0.01);
}

TEST(PathHistory, ForgetsEverythingOnRestart) {
  PathHistory path;
  path.restart({0.0, 0.0, 0.0});
  path.append({10.0, 0.0, 0.0});
  path.restart({0.0, 5.0, 0.0});
  EXPECT_NEAR(path.distance_mm({5.0, 0.0, 0.0}), std::sqrt(50.0), 1e-12);
}

}  // namespace
