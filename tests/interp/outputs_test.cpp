#include "interp/outputs.hpp"

#include <gtest/gtest.h>

namespace kerf::interp {
namespace {

TEST(Outputs, IgnoreAnIndexThatNoOutputHas) {
  Outputs outputs;
  for (const std::int32_t index : {-1, 64, 1'000'000}) {
    apply({.kind = SwitchKind::digital, .index = index, .value = 1.0}, outputs);
    apply({.kind = SwitchKind::analog, .index = index, .value = 1.0}, outputs);
  }
  EXPECT_EQ(outputs, Outputs{});
}

TEST(Outputs, OfOneKindLeaveTheOthersAlone) {
  Outputs outputs;
  apply({.kind = SwitchKind::spindle, .value = 3.0}, outputs);
  apply({.kind = SwitchKind::mist_on}, outputs);
  apply({.kind = SwitchKind::digital, .index = 63, .value = 1.0}, outputs);
  apply({.kind = SwitchKind::flood_on}, outputs);
  apply({.kind = SwitchKind::tool_number, .value = 4.0}, outputs);
  EXPECT_EQ(outputs, (Outputs{.spindle_rad_s = 3.0,
                              .tool = 4,
                              .mist = true,
                              .flood = true,
                              .digital = std::uint64_t{1} << 63U}));
  apply({.kind = SwitchKind::all_off}, outputs);
  EXPECT_EQ(outputs, (Outputs{.tool = 4, .digital = std::uint64_t{1} << 63U}));
}

}  // namespace
}  // namespace kerf::interp
