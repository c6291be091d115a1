// After M3, M4 and a new S the tool rests until the spindle is at its speed.
#include <cstddef>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

constexpr double kRadPerTurn = 6.283185307179586;
constexpr double kPerMin_s = 1500.0;  // revolutions per minute that the spindle gains in a second
constexpr std::size_t kPauseAtSpeed = 50;  // after an answer
constexpr std::size_t kBesideRest = 6;     // where the tool comes and goes

MachineSettings table(bool waits) {
  MachineSettings settings = default_machine();
  settings.simulation.spindle_rad_s2 = kRadPerTurn * kPerMin_s / 60.0;
  settings.program.waits_for_spindle = waits;
  return settings;
}

// At X1, where the words stand between two ways.
std::size_t ticks_at_rest(const MachineSettings& settings, const std::string& words,
                          const std::string& before = "") {
  const TableRun run =
      whole_run(settings, "G21 G61 F600\n" + before + "G1 X1\n" + words + "\nG1 Y1\nM2\n");
  std::size_t ticks = 0;
  for (const Setpoint& tick : run.ticks) {
    ticks += tick.position_mm[0] == 1.0 && tick.position_mm[1] == 0.0 ? 1U : 0U;
  }
  return ticks;
}

void expect_rest(std::size_t ticks, double time_s) {
  EXPECT_NEAR(static_cast<double>(ticks), 1000.0 * time_s + kPauseAtSpeed, kBesideRest);
}

TEST(SpindleWait, LastsUntilTheSpindleIsAtItsSpeed) {
  expect_rest(ticks_at_rest(table(true), "M3 S3000"), 3000.0 / kPerMin_s);
  expect_rest(ticks_at_rest(table(true), "M4 S600"), 600.0 / kPerMin_s);
}

TEST(SpindleWait, OfANewSpeedLastsForTheDifference) {
  expect_rest(ticks_at_rest(table(true), "S2400", "M3 S3000\n"), 600.0 / kPerMin_s);
  expect_rest(ticks_at_rest(table(true), "M4", "M3 S900\n"), 1800.0 / kPerMin_s);
}

TEST(SpindleWait, IsNoneWhereItIsNotAskedFor) {
  EXPECT_LE(ticks_at_rest(table(false), "M3 S3000"), kBesideRest);
  EXPECT_LE(ticks_at_rest(table(true), "M5", "M3 S3000\n"), kBesideRest);
}

TEST(SpindleWait, IsAssumedWhereThereAreNoTicksToAskAt) {
  Kernel kernel(table(true), {});
  kernel.feed("G21 G61 F600\nG1 X1\nM3 S3000\nG1 Y1\nM4 S1500\nM2\n");
  kernel.finish();
  std::int64_t rests = 0;
  Setpoint before;
  Setpoint setpoint;
  while (kernel.next(setpoint) == TickStatus::running) {
    rests += setpoint.position_mm == before.position_mm ? 1 : 0;
    before = setpoint;
  }
  // After each answer what follows is planned in 50 ms, as where the machine is asked.
  EXPECT_NEAR(static_cast<double>(rests), 1000.0 * (3000.0 + 4500.0) / kPerMin_s + 2.0 * 50.0,
              2.0 * kBesideRest);
}

}  // namespace
}  // namespace kerf::test
