#include "programs/kerf/page/code_runs.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(CodeRuns, BeginWhereTheCodesChange) {
  CodeRuns codes;
  codes.add(0, "");
  codes.add(1, "G0 G21");
  codes.add(2, "G0 G21");
  codes.add(3, "G1 G21");
  codes.add(9, "G0 G21");
  ASSERT_EQ(codes.runs().size(), 3U);
  EXPECT_EQ(codes.texts(), (std::vector<std::string>{"G0 G21", "G1 G21"}));
  EXPECT_EQ(codes.runs()[0].tick, 1);
  EXPECT_EQ(codes.runs()[2].tick, 9);
  EXPECT_EQ(codes.runs()[2].codes, 0U);
}

TEST(CodeRuns, EndWithNothingKnownWhereThereAreTooMany) {
  CodeRuns codes;
  for (std::int64_t tick = 0; tick < 300'000; ++tick) {
    codes.add(tick, tick % 2 == 0 ? "G0" : "G1");
  }
  ASSERT_EQ(codes.runs().size(), CodeRuns::kMaxRuns + 1);
  EXPECT_EQ(codes.texts()[codes.runs().back().codes], "");
  EXPECT_EQ(codes.runs().back().tick, 200'000);
}

}  // namespace
}  // namespace kerf::program
