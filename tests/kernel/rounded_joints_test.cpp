// Joints whose turn is what rounding of the coordinates leaves, and rows of very short lines.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"
#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

constexpr double kRadius_mm = 5.0;

std::string point(double angle_rad, int decimals) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "X%.*f Y%.*f", decimals, kRadius_mm * std::cos(angle_rad),
                decimals, kRadius_mm * std::sin(angle_rad));
  return text.data();
}

// A circle in so many arcs, from the tool's place.
std::string circle(int arcs, int decimals, const std::string& mode) {
  std::string text = mode + " G90 G17 F24000\n";
  for (int i = 1; i <= arcs; ++i) {
    text += "G3 " + point(2.0 * std::numbers::pi * i / arcs, decimals) + " R5\n";
  }
  return text + "M2\n";
}

std::size_t ticks_on(const std::string& text) {
  return ticks_of(text, {.start_mm = {kRadius_mm, 0.0, 0.0}}).size();
}

TEST(RoundedJoints, OfArcsInG64CostNoTimeWhateverTheirDecimals) {
  const auto whole = static_cast<double>(ticks_on("G61 G90 G17 F24000\nG3 X5 Y0 I-5\nM2\n"));
  for (const int arcs : {3, 4, 8, 12}) {
    for (const int decimals : {3, 4, 5, 6, 8, 10}) {
      const auto ticks = static_cast<double>(ticks_on(circle(arcs, decimals, "G64 P0.01 Q0.01")));
      EXPECT_LE(ticks, 1.02 * whole) << arcs << " arcs, " << decimals << " decimals";
    }
  }
}

// A rounded square, with a line across the way before each of its arcs, as posts leave them.
std::string rounded_square(double stub_mm) {
  constexpr std::array<std::array<double, 2>, 4> kSides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::string text = "G64 P0.01 Q0.01 G91 G17 F4000\n";
  for (const auto& [x, y] : kSides) {
    text += "G1 X" + std::to_string(30.0 * x) + " Y" + std::to_string(30.0 * y) + "\n";
    if (stub_mm > 0.0) {
      text += "G1 X" + std::to_string(-stub_mm * y) + " Y" + std::to_string(stub_mm * x) + "\n";
    }
    text += "G3 X" + std::to_string(3.0 * (x - y)) + " Y" + std::to_string(3.0 * (y + x)) + " R3\n";
  }
  return text + "M2\n";
}

TEST(Stubs, BesideArcsCostHardlyAnyTimeInG64WhereTheyAreFarShorterThanQ) {
  const auto without = static_cast<double>(ticks_of(rounded_square(0.0)).size());
  for (const double stub_mm : {1e-4, 1e-3, 2e-3}) {
    EXPECT_LE(static_cast<double>(ticks_of(rounded_square(stub_mm)).size()), 1.02 * without)
        << stub_mm;
  }
}

// 300 lines of 0.02 mm on a circle of 10 mm under 400,000 mm/s3: each takes six ticks, by the rule
// for a corner that is passed, and 11.7 ms from rest to rest.
TEST(ShortLines, AreRunWithoutARestWhereARestInEachTakesLonger) {
  constexpr int kLines = 300;
  MachineSettings settings = mill();
  settings.limits.path = {.velocity_mm_s = 800.0};
  settings.limits.axes.fill(
      {.velocity_mm_s = 2000.0, .acceleration_mm_s2 = 8000.0, .jerk_mm_s3 = 4e5});
  std::string text = "G61 G90 F6000\n";
  for (int i = 1; i <= kLines; ++i) {
    const double angle = 0.002 * i;
    text += "G1 X" + std::to_string(10.0 * std::sin(angle)) + " Y" +
            std::to_string(10.0 - 10.0 * std::cos(angle)) + "\n";
  }
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    Kernel kernel(settings, {.profile = Profile{kind}});
    kernel.feed(text + "M2\n");
    kernel.finish();
    EXPECT_LE(rest_of(kernel).size(), 6U * kLines + 30U) << name_of(kind);
  }
}

}  // namespace
}  // namespace kerf::test
