// The time that is left after a probe, which ends earlier than its block.
#include <vector>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

// 30 mm at 2 mm/s are programmed, of which 3 are run, and 100 mm at 10 mm/s.
TEST(TimeLeft, IsThatOfWhatFollowsBehindAContact) {
  std::vector<double> said_s;
  TableOrder order;
  order.options.nominal = NominalTime{.motion_s = 15.0 + 10.0};
  order.before = [&](Kernel& kernel, const TableRun& run, ProgramInputs& inputs) {
    inputs.probe = !run.ticks.empty() && run.ticks.back().position_mm[2] <= -3.0;
    said_s.push_back(kernel.left_s().value_or(-1.0));
  };
  MachineSettings settings = default_machine();
  settings.program.path_control = {};
  const TableRun run = whole_run(settings, "G21 G90\nG38.2 Z-30 F120\nG1 X100 F600\nM2\n", order);
  for (std::size_t tick = 2000; tick < run.ticks.size(); tick += 1500) {
    const double left_s = static_cast<double>(run.ticks.size() - tick) * 1e-3;
    EXPECT_NEAR(said_s.at(tick), left_s, 0.05 * left_s + 0.1) << "tick " << tick;
  }
  EXPECT_NEAR(said_s.at(500), 24.5, 0.1) << "nobody knows of the contact";
}

}  // namespace
}  // namespace kerf::test
