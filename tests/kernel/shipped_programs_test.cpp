// The shipped programs of lines and arcs keep every limit of the default table at every tick.
// (Those of NURBS are judged against their curves from outside, see tests/tools.)
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

std::string shipped(const std::string& name) {
  std::ifstream file(std::string(KERF_SOURCE_DIR) + "/programs/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class ShippedProgram : public testing::TestWithParam<const char*> {};

TEST_P(ShippedProgram, KeepsTheTablesLimitsWithEveryProfileAndWindow) {
  const std::string text = shipped(GetParam());
  ASSERT_FALSE(text.empty());
  const MachineSettings settings = default_machine();
  for (int kind = 1; kind <= static_cast<int>(profiles::ProfileKind::sigmoid); ++kind) {
    const profiles::Profile profile(static_cast<profiles::ProfileKind>(kind));
    for (const std::size_t window : {std::size_t{10}, std::size_t{1000}}) {
      Kernel kernel(settings, {.profile = profile, .window_blocks = window});
      kernel.feed(text);
      kernel.finish();
      TickChecker checker(settings.limits, true);
      interp::Setpoint setpoint;
      while (kernel.next(setpoint) == interp::TickStatus::running && checker.complaint().empty()) {
        checker.add(
            {.setpoint = setpoint, .feedrate_mm_s = std::numeric_limits<double>::infinity()});
      }
      EXPECT_EQ(checker.complaint(), "") << profiles::name_of(profile.kind()) << " " << window;
      EXPECT_FALSE(kernel.has_errors());
      EXPECT_GT(checker.ticks(), 10'000);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProgram,
                         testing::Values("raster.ngc", "pocket.ngc", "polygon.ngc"));

}  // namespace
}  // namespace kerf::test
