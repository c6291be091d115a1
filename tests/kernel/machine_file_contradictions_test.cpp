// Values of a machine file of which each could be, and not all of them together.
#include <string>

#include <gtest/gtest.h>
#include <kerf/machine.hpp>

#include "kernel/machine_file_schema.hpp"
#include "tests/kernel/machine_file_helpers.hpp"

namespace {

using kerf::kUnbounded;
using kerf::parse_machine_file;
using kerf::test::errors_of;
using kerf::test::kBounded;
using kerf::test::Lines;

TEST(MachineFileContradictions, WantsTheTravelToHaveALength) {
  for (const char* max_mm : {"3", "2.5"}) {
    EXPECT_EQ(errors_of(kBounded + "[axes.z]\nmin_mm = 3\nmax_mm = " + max_mm + "\n"),
              Lines{"m.toml:7:10: error: axes.z.max_mm: found " + std::string(max_mm) +
                    ", expected more than min_mm, 3"});
  }
}

TEST(MachineFileContradictions, WantsADriveThatCanDoWhatIsPlanned) {
  EXPECT_EQ(
      errors_of(kBounded + "[axes.x]\nmax_velocity_mm_s = 200\ndrive_velocity_mm_s = 100\n"
                           "max_acceleration_mm_s2 = 9\ndrive_acceleration_mm_s2 = 8\n"),
      (Lines{"m.toml:7:23: error: axes.x.drive_velocity_mm_s: found 100, expected at least "
             "max_velocity_mm_s, 200",
             "m.toml:9:28: error: axes.x.drive_acceleration_mm_s2: found 8, expected at least "
             "max_acceleration_mm_s2, 9"}));
}

TEST(MachineFileContradictions, WantsTheInnerLoopToBeTheFasterOne) {
  EXPECT_EQ(errors_of(kBounded + "[axes.x]\nposition_gain_per_s = 2000\n"),
            Lines{"m.toml:6:23: error: axes.x.position_gain_per_s: found 2000, expected at most "
                  "velocity_gain_per_s, 1000"});
  EXPECT_EQ(errors_of(kBounded + "[axes.x]\nvelocity_gain_per_s = 50\n"),
            Lines{"m.toml:6:23: error: axes.x.velocity_gain_per_s: found 50, expected at least "
                  "position_gain_per_s, 120"});
}

TEST(MachineFileContradictions, WantsEveryQuantityBoundedAlongThePathOrOnAllAxes) {
  for (const kerf::BoundRule& rule : kerf::bound_rules()) {
    const std::string key(rule.key);
    std::string others = "[path]\n";
    for (const kerf::BoundRule& other : kerf::bound_rules()) {
      others += other.key != rule.key ? std::string(other.key) + " = 100\n" : "";
    }
    const auto axis = [&](const char* name) {
      return "[axes." + std::string(name) + "]\n" + key + " = 100\n";
    };
    const std::string expected = "m.toml:1:2: error: nothing bounds the " +
                                 std::string(rule.quantity) + ": expected " + key +
                                 " in [path] or in every axis (missing in ";
    EXPECT_EQ(errors_of(others), Lines{expected + "axes.x, axes.y, axes.z)"});
    EXPECT_EQ(errors_of(others + axis("x") + axis("z")), Lines{expected + "axes.y)"});
    EXPECT_EQ(errors_of(others + axis("x") + axis("y") + axis("z")), Lines{});
    // A value that is wrong has its own error, and no second one.
    EXPECT_EQ(errors_of(others + key + " = 0\n").size(), 1U);
  }
}

TEST(MachineFileContradictions, AnEmptyFileLacksAllBoundsAndNoPlaceIsToBlame) {
  const Lines errors = errors_of("");
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(
      errors[0],
      "m.toml: error: nothing bounds the velocity: expected max_velocity_mm_s in [path] or in "
      "every axis (missing in axes.x, axes.y, axes.z)");
}

TEST(MachineFileContradictions, WantsAHomeWithinTheTravel) {
  const std::string x = kBounded + "[axes.x]\nmin_mm = 0\nmax_mm = 500\n";
  EXPECT_EQ(errors_of(x + "home_switch_mm = -5\nhome_mm = 600\n"),
            Lines{"m.toml:9:11: error: axes.x.home_mm: found 600, expected a place within the "
                  "travel"});
  EXPECT_EQ(errors_of(x + "home_switch_mm = -5\n"),
            Lines{"m.toml:8:18: error: axes.x.home_switch_mm: found -5, expected a place within "
                  "the travel, or home_mm, where the axis goes from there"});
  EXPECT_EQ(errors_of(x + "home_switch_mm = -5\nhome_mm = 0\n"), Lines{});
}

TEST(MachineFileContradictions, WantsAHomeSwitchToCloseSomewhere) {
  EXPECT_EQ(errors_of(kBounded + "[simulation.x]\nhome_min_mm = 10\nhome_max_mm = -10\n"),
            Lines{"m.toml:7:15: error: simulation.x.home_max_mm: must not be below "
                  "simulation.x.home_min_mm"});
  const auto read = parse_machine_file(kBounded + "[simulation.x]\nhome_max_mm = -10\n");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->simulation.switches[0].home_min_mm, -kUnbounded);
}

}  // namespace
