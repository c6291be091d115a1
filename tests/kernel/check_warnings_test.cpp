// What the check warns of, though the program can run.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/machine.hpp>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/errors/pages.hpp"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

// X and Y reach 100 mm/s, 6000 mm/min, and Z 20 mm/s, 1200 mm/min.
std::vector<diagnostics::Diagnostic> feed_warnings(const std::string& text) {
  MachineSettings settings = default_machine();
  settings.limits.path.velocity_mm_s = kUnbounded;
  settings.limits.axes[0].velocity_mm_s = 100.0;
  settings.limits.axes[1].velocity_mm_s = 100.0;
  settings.limits.axes[2].velocity_mm_s = 20.0;
  bool first = true;
  const CheckReport report = check_program(
      [&]() -> std::string_view {
        return std::exchange(first, false) ? std::string_view(text) : std::string_view{};
      },
      settings);
  EXPECT_FALSE(report.has_errors());
  std::vector<diagnostics::Diagnostic> found;
  for (const diagnostics::Diagnostic& diagnostic : report.diagnostics) {
    if (diagnostic.page == &errors::kFeedBeyondReach) {
      found.push_back(diagnostic);
    }
  }
  return found;
}

TEST(CheckWarnings, NameTheFeedThatALineCannotReachInItsDirection) {
  const auto found = feed_warnings("G21 G90 G1 X10 F6000\nZ-10\nM2\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().source.line, 2U);
  EXPECT_THAT(found.front().message, HasSubstr("6000"));
  EXPECT_THAT(found.front().message, HasSubstr(" 1200 mm/min"));
}

// Z takes three fifths of the feedrate: 1200 / 0.6 = 2000 mm/min.
TEST(CheckWarnings, CountWhatEachAxisTakesOfTheFeed) {
  EXPECT_TRUE(feed_warnings("G21 G90 G1 X40 Z-30 F2000\nM2\n").empty());
  const auto found = feed_warnings("G21 G90 G1 X40 Z-30 F2001\nM2\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found.front().message, HasSubstr(" 2000 mm/min"));
}

// The axes reach 142.8 mm/s together, 8569.7 mm/min.
TEST(CheckWarnings, OfACurveCountTheFastestDirection) {
  EXPECT_TRUE(feed_warnings("G21 G90 G17 G1 X1 F100\nG2 X11 I5 F8569\nM2\n").empty());
  EXPECT_EQ(feed_warnings("G21 G90 G17 G1 X1 F100\nG2 X11 I5 F8570\nM2\n").size(), 1U);
}

TEST(CheckWarnings, NameTheFirstOfSuchBlocksAlone) {
  EXPECT_EQ(feed_warnings("G21 G90 G1 Z-10 F6000\nZ0\nZ-5\nX200 F60000\nM2\n").size(), 1U);
}

TEST(CheckWarnings, LeaveRapidsAndReachableFeedsAlone) {
  EXPECT_TRUE(
      feed_warnings("G21 G90 G0 Z-10\nG1 Z0 F1200\nX10 F6000\nX20 Y10 F8400\nM2\n").empty());
}

}  // namespace
}  // namespace kerf::test
