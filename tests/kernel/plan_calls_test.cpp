// How much one call of Kernel::plan() does.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

std::ptrdiff_t count_of(std::string_view words, const std::vector<std::string>& lines) {
  return std::ranges::count_if(
      lines, [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

// Each of its lines is a block, and each corner one.
std::string zigzag() {
  std::string text = "G21 G90 G64 P0.01 Q0 G1 F6000\n";
  for (int i = 1; i <= 4000; ++i) {
    text += "X" + std::to_string(0.1 * i) + (i % 2 == 0 ? " Y0\n" : " Y0.03\n");
  }
  return text + "M2\n";
}

TEST(PlanCalls, TakeManyBlocksOrSearchOverThemInMotion) {
  std::vector<std::string> told;
  KernelOptions options{.profile = {.kind = ProfileKind::time_optimal}};
  options.plan_log = [&told](std::string_view line) { told.emplace_back(line); };
  Kernel kernel(mill(), options);
  kernel.feed(zigzag());
  kernel.finish();
  constexpr int kFirstInMotion = 1000;
  std::ptrdiff_t searches = 0;
  std::ptrdiff_t most_taken = 0;
  Setpoint setpoint;
  for (int tick = 0; tick < 10 * kFirstInMotion; ++tick) {
    told.clear();
    kernel.plan();
    if (tick >= kFirstInMotion) {
      const std::ptrdiff_t searched = count_of("search over", told);
      const std::ptrdiff_t taken = count_of("scan of", told);
      EXPECT_FALSE(searched > 0 && taken > 20) << "tick " << tick << ": " << taken << " scans";
      searches += searched;
      most_taken = std::max(most_taken, taken);
    }
    ASSERT_EQ(kernel.tick(setpoint), TickStatus::running) << tick;
  }
  EXPECT_GT(searches, 5);
  EXPECT_GT(most_taken, 20);
}

}  // namespace
}  // namespace kerf::test
