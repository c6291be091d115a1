#include "programs/kerf/report/fit.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

using Words = std::vector<std::string>;

// A table of -100 to 300 mm, and a path along X that follows G54 at 20 mm.
MachineSettings table() {
  MachineSettings settings;
  for (auto& axis : settings.table.axes) {
    axis.travel = {.min_mm = -100.0, .max_mm = 300.0};
  }
  settings.program.work[0].origin_mm = {20.0, 0.0, 0.0};
  return settings;
}

CheckReport path_along_x(double min_mm, double max_mm) {
  CheckReport check;
  check.moves = true;
  check.extents = {.min_mm = {min_mm, 0.0, 0.0}, .max_mm = {max_mm, 0.0, 0.0}};
  check.offset_extents.following[0][0] = {.min_mm = min_mm, .max_mm = max_mm};
  return check;
}

TEST(Fit, SaysBetweenWhichOffsetsThePathFits) {
  const FitReport fit = *fit_of(path_along_x(10.0, 320.0), table());
  EXPECT_FALSE(fit.fits());
  EXPECT_EQ(fit.axes[0].over_mm, 20.0);
  EXPECT_EQ(fit.axes[1].over_mm, 0.0);
  ASSERT_EQ(fit.offsets.size(), 1U);
  EXPECT_EQ(fit.offsets[0].name, "G54");
  // 110 mm to the left, where its left end meets the table's, and 20 mm at the least.
  EXPECT_EQ(fit.offsets[0].ranges[0]->min_mm, -90.0);
  EXPECT_EQ(fit.offsets[0].ranges[0]->max_mm, 0.0);
  EXPECT_FALSE(fit.offsets[0].ranges[1].has_value());
  EXPECT_EQ(describe(fit), Words{"G54 X between -90.000 and 0.000"});
}

TEST(Fit, SaysNothingOfWhatFits) {
  const FitReport fit = *fit_of(path_along_x(10.0, 50.0), table());
  EXPECT_TRUE(fit.fits());
  EXPECT_EQ(describe(fit), Words{});
  EXPECT_FALSE(fit_of({}, table())) << "without motion";
}

// Coordinates are sums that are rounded, and the machine is as generous.
TEST(Fit, IsNotMissedByRounding) {
  EXPECT_TRUE(fit_of(path_along_x(10.0, 300.0 + 1e-12), table())->fits());
  EXPECT_FALSE(fit_of(path_along_x(10.0, 300.001), table())->fits());
}

TEST(Fit, SaysSoWhereNoOffsetWouldDo) {
  const FitReport longer = *fit_of(path_along_x(0.0, 450.5), table());
  EXPECT_EQ(describe(longer), Words{"no G54 X: the path is 50.500 mm longer than the travel"});
  CheckReport fixed = path_along_x(0.0, 0.0);
  fixed.extents.max_mm[2] = 340.0;
  fixed.offset_extents.fixed[2] = {.min_mm = 0.0, .max_mm = 340.0};
  EXPECT_EQ(describe(*fit_of(fixed, table())),
            Words{"no work offset: Z leaves the travel by 40.000 mm wherever it lies"});
}

TEST(Fit, SaysWhereItFitsBetweenTwoThousandths) {
  EXPECT_EQ(describe(*fit_of(path_along_x(0.0003, 400.0002), table())),
            Words{"G54 X at -80.000250"});
}

TEST(Fit, MovesOnlyTheOffsetsThatAreToBlame) {
  CheckReport check = path_along_x(10.0, 50.0);
  check.extents.max_mm[0] = 310.0;
  check.offset_extents.following[1][0] = {.min_mm = 250.0, .max_mm = 310.0};
  EXPECT_EQ(describe(*fit_of(check, table())), Words{"G55 X between -350.000 and -10.000"});
}

TEST(Fit, RoundsInwardsAndLeavesOutWhatHasNoBound) {
  MachineSettings settings = table();
  settings.table.axes[0].travel.min_mm = -kUnbounded;
  EXPECT_EQ(describe(*fit_of(path_along_x(10.0, 320.00049), settings)),
            Words{"G54 X at most -0.001"});
}

TEST(Fit, NamesEachFurtherAxisThatLeavesItsTravel) {
  MachineSettings settings = table();
  settings.table.extra[0] = {.min_rad_mm = -1.0, .max_rad_mm = 1.0};
  settings.table.extra[3] = {.min_rad_mm = -10.0, .max_rad_mm = 10.0};
  CheckReport check = path_along_x(10.0, 50.0);
  check.extra_extents.min_rad_mm = {-2.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  check.extra_extents.max_rad_mm = {0.0, 0.0, 0.0, 20.0, 0.0, 0.0};
  const FitReport fit = *fit_of(check, settings);
  ASSERT_TRUE(fit.extra_excess.has_value());
  EXPECT_NE(fit.extra_excess->find("a goes"), std::string::npos);
  EXPECT_NE(fit.extra_excess->find("u goes 10 mm"), std::string::npos);
}

TEST(Fit, NamesWorkSystemsAsProgramsDo) {
  EXPECT_EQ(work_system_name(0), "G54");
  EXPECT_EQ(work_system_name(5), "G59");
  EXPECT_EQ(work_system_name(6), "G59.1");
  EXPECT_EQ(work_system_name(8), "G59.3");
  EXPECT_EQ(work_system_name(9), "G54.1 P1");
}

}  // namespace
}  // namespace kerf::program
