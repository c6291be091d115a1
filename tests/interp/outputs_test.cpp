#include "interp/outputs.hpp"

#include <gtest/gtest.h>

namespace kerf::interp {
namespace {

TEST(Outputs, IgnoreAnIndexThatNoOutputHas) {
  Outputs outputs;
  for (const std::int32_t index : {-1, 64, 1'000'000}) {
    apply({.kind = OutputChangeKind::digital, .index = index, .value = 1.0}, outputs);
    apply({.kind = OutputChangeKind::analog, .index = index, .value = 1.0}, outputs);
  }
  EXPECT_EQ(outputs, Outputs{});
}

TEST(Outputs, OfOneKindLeaveTheOthersAlone) {
  Outputs outputs;
  apply({.kind = OutputChangeKind::spindle, .value = 3.0}, outputs);
  apply({.kind = OutputChangeKind::mist_on}, outputs);
  apply({.kind = OutputChangeKind::digital, .index = 63, .value = 1.0}, outputs);
  apply({.kind = OutputChangeKind::flood_on}, outputs);
  apply({.kind = OutputChangeKind::tool_number, .value = 4.0}, outputs);
  EXPECT_EQ(outputs, (Outputs{.spindle_rad_s = 3.0,
                              .tool = 4,
                              .mist = true,
                              .flood = true,
                              .digital = std::uint64_t{1} << 63U}));
  apply({.kind = OutputChangeKind::all_off}, outputs);
  EXPECT_EQ(outputs, (Outputs{.tool = 4, .digital = std::uint64_t{1} << 63U}));
}

}  // namespace
}  // namespace kerf::interp
