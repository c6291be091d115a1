#include "lookahead/optimum/solver/limit_check.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace kerf::lookahead {
namespace {

// X moves little, to and fro, while the path runs at 100 mm/s: its share of the direction is
// 0.01 (1 - 100 (s - 0.1)^2), the most of it, 1 mm/s, between two places at which the check looks.
TEST(LimitCheck, SeesAnAxisVelocityThatPeaksBetweenTwoOfItsPlaces) {
  const auto path = [](const Cell&, double s_mm) {
    PathSample end;
    end.first = {0.01 * (1.0 - 100.0 * (s_mm - 0.1) * (s_mm - 0.1)), 1.0, 0.0};
    end.second_per_mm = {-2.0 * (s_mm - 0.1), 0.0, 0.0};
    end.third_per_mm2 = {-2.0, 0.0, 0.0};
    end.feedrate_mm_s = 1000.0;
    return end;
  };
  Cell cell{.length_mm = 0.2};
  cell.begin = path(cell, 0.0);
  cell.end = path(cell, 0.2);
  PlanLimits limits;
  limits.axes[0] = {.velocity_mm_s = 0.9, .acceleration_mm_s2 = 1e9, .jerk_mm_s3 = 1e12};
  const SquaredFeed cruise{.value = 1e4, .slope = 0.0, .bend = 0.0};
  EXPECT_GE(excess_of(cell, cruise, path, limits).feedrate, 1.0 / 0.9 - 1e-3);
}

// At constant feedrate X sees jerk of the third derivative alone, which rises to a knot of the
// curve and falls behind it, by 4 % of the most over a cell.
TEST(LimitCheck, SeesTheJerkAtAKnotWhereverInACellItLies) {
  Cell cell{.length_mm = 0.2};
  const SquaredFeed cruise{.value = 1e4, .slope = 0.0, .bend = 0.0};
  PlanLimits limits;
  limits.axes[0].jerk_mm_s3 = 1e6;
  for (int i = 1; i < 100; ++i) {
    const double knot_mm = 0.2 * i / 100.0;
    const auto path = [knot_mm](const Cell&, double s_mm) {
      PathSample end;
      end.first = {0.0, 1.0, 0.0};
      end.third_per_mm2 = {1.0 - 0.04 * std::abs(s_mm - knot_mm) / 0.2, 0.0, 0.0};
      end.feedrate_mm_s = 1000.0;
      return end;
    };
    cell.begin = path(cell, 0.0);
    cell.end = path(cell, cell.length_mm);
    EXPECT_NEAR(excess_of(cell, cruise, path, limits).jerk, 1.0, 1e-9) << i;
  }
}

// What a line's cell exceeds, it exceeds at an end, or where its feedrate is highest.
TEST(LimitCheck, OfALineIsThatOfItsPlaces) {
  std::mt19937_64 random(5);
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  PlanLimits limits;
  limits.axes.fill({.velocity_mm_s = 60.0, .acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e4});
  int peaks = 0;
  for (int i = 0; i < 2000; ++i) {
    PathSample end;
    end.first = {uniform(-0.7, 0.7), uniform(-0.7, 0.7), uniform(-0.7, 0.7)};
    end.feedrate_mm_s = 50.0;
    const auto path = [&end](const Cell&, double) { return end; };
    Cell cell{.length_mm = uniform(0.01, 0.5),
              .begin = end,
              .end = end,
              .along = {.acceleration_mm_s2 = 900.0, .jerk_mm_s3 = 2e4},
              .jumps_per_mm_s = {uniform(0.0, 2.0), 0.0, uniform(0.0, 2.0)}};
    const double h = cell.length_mm;
    const double from = uniform(100.0, 2500.0);
    const SquaredFeed feed{.value = from,
                           .slope = uniform(-0.5, 0.5) * from / h,
                           .bend = uniform(-0.9, 0.9) * from / (h * h)};
    const Excess looked = excess_of(cell, feed, path, limits);
    cell.straight = true;
    const Excess found = excess_of(cell, feed, path, limits);
    EXPECT_NEAR(found.feedrate, looked.feedrate, 1e-12 * looked.feedrate) << i;
    EXPECT_NEAR(found.acceleration, looked.acceleration, 1e-12 * looked.acceleration) << i;
    EXPECT_NEAR(found.jerk, looked.jerk, 1e-12 * looked.jerk) << i;
    const double peak = -feed.slope / feed.bend;
    peaks += feed.bend < 0.0 && peak > 0.0 && peak < h ? 1 : 0;
  }
  EXPECT_GT(peaks, 200);
}

}  // namespace
}  // namespace kerf::lookahead
