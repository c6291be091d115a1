#include "lookahead/optimum/solver/limit_check.hpp"

#include <cmath>

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

}  // namespace
}  // namespace kerf::lookahead
