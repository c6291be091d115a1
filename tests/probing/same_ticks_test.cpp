// A program that asks the machine has the same ticks whenever it is planned.
#include <string>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

HeightMap bumps() {
  HeightMap map{.origin_mm = {-10.0, -10.0}, .spacing_mm = {10.0, 10.0}, .columns = 6};
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 6; ++column) {
      map.heights_mm.push_back(-12.0 + 0.3 * ((row * 7 + column * 5) % 9));
    }
  }
  return map;
}

// Measures heights over a grid and cuts it, warped by them.
constexpr const char* kWarpedGrid = R"(G21 G61 G90 F900
#<row> = 0
o1 while [#<row> LT 3]
#<column> = 0
o2 while [#<column> LT 4]
G0 Z0
G0 X[#<column> * 10] Y[#<row> * 10]
G38.2 Z-20
#[100 + #<row> * 4 + #<column>] = #5063
G0 Z0
#<column> = [#<column> + 1]
o2 endwhile
#<row> = [#<row> + 1]
o1 endwhile
G64 P0.05
F3000
#<row> = 0
o3 while [#<row> LT 3]
G1 X0 Y[#<row> * 10] Z[#[100 + #<row> * 4] - 1]
#<column> = 1
o4 while [#<column> LT 4]
G1 X[#<column> * 10] Z[#[100 + #<row> * 4 + #<column>] - 1]
#<column> = [#<column> + 1]
o4 endwhile
G1 Z0
#<row> = [#<row> + 1]
o3 endwhile
M66 P3 L0
G1 Z[1 + #5399]
M2
)";

bool same(const Setpoint& a, const Setpoint& b) {
  return a.tick == b.tick && a.position_mm == b.position_mm && a.v_mm_s == b.v_mm_s &&
         a.a_mm_s2 == b.a_mm_s2 && a.s_mm == b.s_mm && a.line == b.line;
}

TEST(SameTicks, AMeasuredHeightMapWarpsAGridAlikeHoweverLateItIsPlanned) {
  MachineSettings settings = touching(bumps(), false);
  settings.simulation.digital = 1U << 3U;
  TableOrder order{.options = {.horizon_s = 0.25}};
  const TableRun dry = whole_run(settings, kWarpedGrid, order);
  EXPECT_EQ(dry.ticks.back().position_mm[2], 2.0);
  for (const std::int64_t every : {1, 7, 23, 40}) {
    SCOPED_TRACE(every);
    order.plans_every = every;
    const TableRun run = whole_run(settings, kWarpedGrid, order);
    ASSERT_EQ(run.ticks.size(), dry.ticks.size());
    for (std::size_t i = 0; i < dry.ticks.size(); ++i) {
      ASSERT_TRUE(same(run.ticks[i], dry.ticks[i])) << "tick " << i;
    }
  }
}

// The grid is where the surface is, which the program did not know.
TEST(SameTicks, TheWarpedGridLiesBelowTheSurfaceByWhatTheProgramSays) {
  const HeightMap map = bumps();
  const TableRun run = whole_run(touching(map, true), kWarpedGrid);
  std::size_t corners = 0;
  for (std::size_t i = 1; i < run.ticks.size(); ++i) {
    const auto& from = run.ticks[i - 1].position_mm;
    const auto& to = run.ticks[i].position_mm;
    for (const double column_mm : {10.0, 20.0}) {
      const double share = (column_mm - from[0]) / (to[0] - from[0]);
      if (run.ticks[i].line == 22 && share > 0.0 && share <= 1.0 && to[2] < -5.0) {
        const auto column = static_cast<std::size_t>(std::lround(column_mm / 10.0)) + 1;
        const auto row = static_cast<std::size_t>(std::lround(to[1] / 10.0)) + 1;
        const double z_mm = from[2] + share * (to[2] - from[2]);
        EXPECT_NEAR(z_mm, map.heights_mm[row * map.columns + column] - 1.0, 0.06);
        ++corners;
      }
    }
  }
  EXPECT_GE(corners, 6u);
}

}  // namespace
}  // namespace kerf::test
