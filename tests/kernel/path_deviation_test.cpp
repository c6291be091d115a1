// How far the commanded path is from the programmed one, told by the kernel and found from ticks.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "smoothing/path_deviations.hpp"
#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

using curves::Position;
using smoothing::PathDeviation;

constexpr double kFinePeriod_s = 5e-5;

double apart_mm(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Of a point from the line between two.
double apart_mm(const Position& point, const Position& begin, const Position& end) {
  double along = 0.0;
  double square = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (point[k] - begin[k]) * (end[k] - begin[k]);
    square += (end[k] - begin[k]) * (end[k] - begin[k]);
  }
  const double share = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  Position foot{};
  for (std::size_t k = 0; k < 3; ++k) {
    foot[k] = begin[k] + share * (end[k] - begin[k]);
  }
  return apart_mm(point, foot);
}

double apart_mm(const Position& point, const std::vector<Position>& lines) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    nearest = std::min(nearest, apart_mm(point, lines[i - 1], lines[i]));
  }
  return nearest;
}

// Of the points of one from the lines of the other: the vertices, and places between them.
double largest_mm(const std::vector<Position>& from, const std::vector<Position>& to,
                  std::size_t steps) {
  double largest = 0.0;
  for (std::size_t i = 1; i < from.size(); ++i) {
    for (std::size_t step = 0; step <= steps; ++step) {
      const double share = static_cast<double>(step) / static_cast<double>(steps);
      Position place{};
      for (std::size_t k = 0; k < 3; ++k) {
        place[k] = from[i - 1][k] + share * (from[i][k] - from[i - 1][k]);
      }
      largest = std::max(largest, apart_mm(place, to));
    }
  }
  return largest;
}

struct Found {
  PathDeviation told;
  std::vector<Position> ticks_mm;
  double spacing_mm = 0.0;  // of ticks, at the most
};

Found run_of(const std::string& text, double period_s = kFinePeriod_s) {
  MachineSettings machine = mill();
  machine.limits.period_s = period_s;
  Kernel kernel(machine);
  kernel.feed(text);
  kernel.finish();
  Found run;
  for (const Setpoint& tick : rest_of(kernel)) {
    if (!run.ticks_mm.empty()) {
      run.spacing_mm = std::max(run.spacing_mm, apart_mm(tick.position_mm, run.ticks_mm.back()));
    }
    run.ticks_mm.push_back(tick.position_mm);
  }
  EXPECT_FALSE(kernel.has_errors());
  run.told = kernel.deviation();
  return run;
}

std::string square(const std::string& mode) {
  return "G21 G90 F3000\n" + mode + "\nG1 X20\nY20\nX0\nY0\nM2\n";
}

const std::vector<Position> kSquare{
    {0.0, 0.0, 0.0}, {20.0, 0.0, 0.0}, {20.0, 20.0, 0.0}, {0.0, 20.0, 0.0}, {0.0, 0.0, 0.0}};

TEST(PathDeviation, OfASquareWithBlendedCornersIsWhatTicksShow) {
  for (const double tolerance_mm : {0.05, 0.01}) {
    SCOPED_TRACE(tolerance_mm);
    const Found found = run_of(square("G64 P" + std::to_string(tolerance_mm)));
    const double sampled =
        std::max(largest_mm(kSquare, found.ticks_mm, 1), largest_mm(found.ticks_mm, kSquare, 1));
    // The lines between ticks leave the path by no more than that, since it turns within P.
    const double missed_mm = found.spacing_mm * found.spacing_mm / (8.0 * tolerance_mm);
    EXPECT_NEAR(found.told.distance_mm, sampled, missed_mm);
    EXPECT_LT(missed_mm, 0.01 * tolerance_mm);
    EXPECT_LE(found.told.distance_mm, tolerance_mm);
    EXPECT_EQ(found.told.tolerance_mm, tolerance_mm);
  }
}

TEST(PathDeviation, HasTheCornersPlaceAndLine) {
  const PathDeviation told = run_of(square("G64 P0.05")).told;
  ASSERT_GE(told.line, 4U);
  ASSERT_LE(told.line, 6U);
  const Position& corner = kSquare[told.line - 3];
  EXPECT_NEAR(apart_mm(told.at_mm, corner), told.distance_mm, 1e-9);
}

TEST(PathDeviation, IsThatOfTheWorstCorner) {
  const Found found =
      run_of("G21 G90 F3000\nG64 P0.01\nG1 X20\nY20\nG64 P0.03\nX0\nG64 P0.02\nY0\nM2\n");
  EXPECT_EQ(found.told.line, 8U);  // of the two P beside a corner the lesser counts
  EXPECT_EQ(found.told.tolerance_mm, 0.02);
}

TEST(PathDeviation, OfATickFromItsOwnLineIsSmallWhereABlendSpansManyLines) {
  std::string text = "G21 G90 F3000\nG64 P0.05 Q0.001\n";
  std::vector<Position> lines{{0.0, 0.0, 0.0}};
  for (int i = 1; i <= 160; ++i) {  // two arcs of short lines that meet at 15 degrees
    const double angle = 0.005 * (i - 1) + (i > 80 ? 0.26 : 0.0);
    lines.push_back(
        {lines.back()[0] + 0.05 * std::cos(angle), lines.back()[1] + 0.05 * std::sin(angle), 0.0});
    text +=
        "G1 X" + std::to_string(lines.back()[0]) + " Y" + std::to_string(lines.back()[1]) + "\n";
  }
  MachineSettings machine = mill();
  machine.limits.period_s = 2e-4;
  Kernel kernel(machine);
  kernel.feed(text + "M2\n");
  kernel.finish();
  std::vector<Setpoint> ticks = rest_of(kernel);
  ticks.pop_back();  // at rest after the program
  for (const Setpoint& tick : ticks) {
    const std::size_t i = tick.line - 2;
    // P, and the length of a line: at a blend's middle two neighbours are as good.
    ASSERT_LE(apart_mm(tick.position_mm, lines[i - 1], lines[i]), 0.05 + 0.05) << tick.line;
  }
}

TEST(PathDeviation, IsZeroWhereThePathIsExact) {
  for (const char* mode : {"", "G61", "G61.1", "G64 P0"}) {
    SCOPED_TRACE(mode);
    const Found found = run_of(square(mode), 1e-3);
    EXPECT_EQ(found.told.distance_mm, 0.0);
    EXPECT_EQ(found.told.line, 0U);
    EXPECT_LT(largest_mm(found.ticks_mm, kSquare, 1), 1e-9);
  }
}

TEST(PathDeviation, OfMergedLinesIsNoLessThanTicksShowAndWithinQ) {
  std::string text = "G21 G90 G64 P0.02 Q0.01\nG1 F3000\n";
  std::vector<Position> lines{{0.0, 0.0, 0.0}};
  for (int i = 1; i <= 120; ++i) {
    const double angle = 0.05 * i;
    const auto in_microns = [](double mm) { return std::round(1e3 * mm) / 1e3; };
    lines.push_back({in_microns(10.0 * std::sin(angle)), in_microns(10.0 - 10.0 * std::cos(angle)),
                     in_microns(0.3 * angle)});
    text += "X" + std::to_string(lines.back()[0]) + " Y" + std::to_string(lines.back()[1]) + " Z" +
            std::to_string(lines.back()[2]) + "\n";
  }
  const Found found = run_of(text + "M2\n", 5e-4);
  const double sampled =
      std::max(largest_mm(lines, found.ticks_mm, 8), largest_mm(found.ticks_mm, lines, 1));
  const double missed_mm = found.spacing_mm * found.spacing_mm / (8.0 * 5.0);
  EXPECT_GE(found.told.distance_mm, sampled - missed_mm);
  EXPECT_LE(found.told.distance_mm, 0.01);
  EXPECT_GT(sampled, 1e-4);
}

}  // namespace
}  // namespace kerf::test
