// Rows 47 to 51 and 64 of the faults: short segments, reversals, tolerances, limits far apart, the
// travel. Limits are judged from positions alone (tests/kernel/tick_checker).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kerf.hpp>

#include "tests/faults/checked.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::faults {
namespace {

constexpr std::array kProfiles{ProfileKind::time_optimal, ProfileKind::s_curve,
                               ProfileKind::sine_series};

using Place = std::array<double, 3>;

struct Outcome {
  std::string complaint;  // of the checker and of the kernel itself; empty: none
  Setpoint last{};
  std::vector<Place> places_mm;  // of all ticks
};

double distance_mm(const Place& point, const Place& from, const Place& to) {
  double along = 0.0;
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (point[k] - from[k]) * (to[k] - from[k]);
    length += (to[k] - from[k]) * (to[k] - from[k]);
  }
  const double share = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double off = point[k] - from[k] - share * (to[k] - from[k]);
    squared += off * off;
  }
  return std::sqrt(squared);
}

// The largest distance of a tick from the programmed lines.
double farthest_mm(const Outcome& outcome, const std::vector<Place>& corners) {
  double farthest = 0.0;
  for (const Place& place : outcome.places_mm) {
    double nearest = HUGE_VAL;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      nearest = std::min(nearest, distance_mm(place, corners[i - 1], corners[i]));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

Outcome run(const std::string& text, ProfileKind kind,
            const MachineSettings& machine = default_machine()) {
  Kernel kernel(machine, {.profile = {.kind = kind}});
  kernel.feed(text);
  kernel.finish();
  test::TickChecker checker(machine.limits, true);
  Outcome result;
  TickStatus status = TickStatus::running;
  while (status == TickStatus::running && result.complaint.empty()) {
    status = kernel.next(result.last);
    checker.add({.setpoint = result.last, .feedrate_mm_s = 1e12});
    result.complaint = checker.complaint();
    result.places_mm.push_back(result.last.position_mm);
  }
  if (result.complaint.empty() && status != TickStatus::finished) {
    result.complaint = "does not end";
  }
  if (const auto fault = kernel.fault()) {
    result.complaint += fault->what;
  }
  return result;
}

void expect_end(const Outcome& outcome, const std::array<double, 3>& end_mm) {
  EXPECT_EQ(outcome.complaint, "");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(outcome.last.position_mm[axis], end_mm[axis], 1e-9);
  }
}

TEST(PathFaults, Row47EqualPointsAndNanometresByTheThousandAreRun) {
  for (const std::string mode : {"G61", "G61.1", "G64 P0.01 Q0.005"}) {
    SCOPED_TRACE(mode);
    const std::string head = mode + " F6000\nG1 X1\n";
    expect_end(
        run(head + "o1 repeat [100000]\nX1\no1 endrepeat\nX2\nM2\n", ProfileKind::time_optimal),
        {2, 0, 0});
    expect_end(run(head + "G91\no1 repeat [3000]\nX[1/10**6]\no1 endrepeat\nG90 X2\nM2\n",
                   ProfileKind::time_optimal),
               {2, 0, 0});
    expect_end(run(head + "G91\no1 repeat [3000]\nX[1/10**9] Y[1/10**9]\no1 endrepeat\nM2\n",
                   ProfileKind::s_curve),
               {1 + 3e-6, 3e-6, 0});
  }
}

TEST(PathFaults, Row48ReversalsAndZigzagsOfAllAnglesKeepEveryLimit) {
  for (const ProfileKind kind : kProfiles) {
    for (const std::string mode : {"G61", "G64 P0.01", "G64 P0.05 Q0.02"}) {
      SCOPED_TRACE(mode + " " + std::string(name_of(kind)));
      const std::string head = mode + " F6000\nG1 X5\n";
      expect_end(run(head + "X0\nX5\nM2\n", kind), {5, 0, 0});
      // 179.99 degrees: the way back is 0.01 degrees beside the way there.
      expect_end(run(head + "X0 Y[5*TAN[0.01]]\nX5 Y0\nM2\n", kind), {5, 0, 0});
      // A zigzag of 0.01 degrees to either side.
      expect_end(run(head + "#1=0\no1 repeat [40]\n#1=[1-#1]\nX[#5420+1] Y[#1*TAN[0.01]]\n"
                            "o1 endrepeat\nX50 Y0\nM2\n",
                     kind),
                 {50, 0, 0});
    }
  }
}

TEST(PathFaults, Row49AToleranceOfNothingOrOfAMetreKeepsEveryLimitAndItself) {
  const std::vector<Place> corners{{0, 0, 0},   {2, 0, 0}, {2, 0.5, 0}, {2.2, 0.5, 0},
                                   {2.2, 2, 0}, {0, 0, 0}, {3, 0, 1}};
  for (const ProfileKind kind : kProfiles) {
    for (const char* tolerance : {"0", "0.000000001", "0.00001", "0.1", "1", "1000"}) {
      SCOPED_TRACE(std::string(tolerance) + " " + std::string(name_of(kind)));
      const Outcome found = run(
          "G64 P" + std::string(tolerance) + " F6000\nG1 X2\nY0.5\nX2.2\nY2\nX0 Y0\nX3 Z1\nM2\n",
          kind);
      expect_end(found, {3, 0, 1});
      EXPECT_LE(farthest_mm(found, corners), std::stod(tolerance) + 1e-9);
    }
  }
}

// Corners of 0 to 90 degrees between legs of 0.5 to 5 mm.
TEST(PathFaults, Row50ALargerToleranceIsNoRougher) {
  std::vector<Place> corners{{0, 0, 0}};
  std::string lines;
  for (int i = 0; i < 10; ++i) {
    const double angle = 0.01745329251994 * i * i * 10;
    Place next = corners.back();
    next[0] = std::round((next[0] + 0.5 * (i + 1) * std::cos(angle)) * 1e4) / 1e4;
    next[1] = std::round((next[1] + 0.5 * (i + 1) * std::sin(angle)) * 1e4) / 1e4;
    corners.push_back(next);
    lines += "X" + std::to_string(next[0]) + " Y" + std::to_string(next[1]) + "\n";
  }
  for (const ProfileKind kind : kProfiles) {
    for (const char* tolerance : {"0.001", "0.003", "0.01", "0.03", "0.1", "0.3"}) {
      SCOPED_TRACE(std::string(tolerance) + " " + std::string(name_of(kind)));
      const Outcome found =
          run("G64 P" + std::string(tolerance) + " Q0 F12000\nG1\n" + lines + "M2\n", kind);
      expect_end(found, corners.back());
      EXPECT_LE(farthest_mm(found, corners), std::stod(tolerance) + 1e-9);
      EXPECT_GT(farthest_mm(found, corners), 0.0);  // the corners are blended indeed
    }
  }
}

TEST(PathFaults, Row51JerksFourDecadesApartAreKeptOnEachAxis) {
  MachineSettings machine = default_machine();
  machine.limits.axes[0].jerk_mm_s3 = 1e6;
  machine.limits.axes[2].jerk_mm_s3 = 1e2;
  for (const ProfileKind kind : kProfiles) {
    for (const std::string mode : {"G61", "G64 P0.05"}) {
      SCOPED_TRACE(mode + " " + std::string(name_of(kind)));
      expect_end(
          run(mode + " F3000\nG1 X20\nX30 Z1\nY10\nG2 X20 Y0 Z0 I-10\nG18 G3 X30 Z0 I5\nM2\n", kind,
              machine),
          {30, 0, 0});
    }
  }
}

TEST(PathFaults, Row64AMoveBeyondTheTravelIsRefusedBeforeTheStart) {
  const std::string text = "G1 F6000 X10\nX9999\nX0\nM2\n";
  const CheckReport report = check(text, {}, default_machine());
  ASSERT_FALSE(report.limit_faults.empty());
  EXPECT_EQ(report.limit_faults.front().source.line, 2U);
  // Text that runs as it comes: at rest before that block.
  Kernel kernel(default_machine(), {.checks_travel = true});
  kernel.feed(text);
  kernel.finish();
  Setpoint setpoint;
  while (kernel.next(setpoint) == TickStatus::running) {
  }
  EXPECT_TRUE(kernel.left_travel());
  EXPECT_EQ(setpoint.position_mm, (std::array<double, 3>{10, 0, 0}));
}

}  // namespace
}  // namespace kerf::faults
