// [axes.a] to [axes.w] of a machine file.
#include <cmath>

#include <gtest/gtest.h>
#include <kerf/machine.hpp>

#include "parser/text/letters.hpp"
#include "tests/kernel/machine_file_helpers.hpp"

namespace kerf::test {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

const std::string kLimitsOfA =
    "max_velocity_deg_s = 180\nmax_acceleration_deg_s2 = 900\nmax_jerk_deg_s3 = 9000\n";
const std::string kLimitsOfU =
    "max_velocity_mm_s = 20\nmax_acceleration_mm_s2 = 200\nmax_jerk_mm_s3 = 2000\n";

TEST(MachineFileAxes, AreNoneWhereTheFileNamesNone) {
  EXPECT_EQ(parse_machine_file(kBounded)->program.extra_axes, 0U);
  EXPECT_EQ(default_machine().program.extra_axes, 0U);
}

TEST(MachineFileAxes, AreNamedByTheirTablesAndKeptInRadAndMm) {
  const auto settings = parse_machine_file(kBounded + "[axes.a]\nmin_deg = -90\nmax_deg = 360\n" +
                                           kLimitsOfA + "[axes.u]\nmin_mm = -5\n" + kLimitsOfU);
  ASSERT_TRUE(settings) << settings.error().front().message;
  EXPECT_EQ(settings->program.extra_axes, parser::letters('A', 'U'));
  EXPECT_DOUBLE_EQ(settings->table.extra[0].min_rad_mm, -90 * kDegree);
  EXPECT_DOUBLE_EQ(settings->table.extra[0].max_rad_mm, 360 * kDegree);
  EXPECT_DOUBLE_EQ(settings->limits.extra[0].velocity_mm_s, 180 * kDegree);
  EXPECT_DOUBLE_EQ(settings->limits.extra[0].acceleration_mm_s2, 900 * kDegree);
  EXPECT_DOUBLE_EQ(settings->limits.extra[0].jerk_mm_s3, 9000 * kDegree);
  EXPECT_EQ(settings->table.extra[3].min_rad_mm, -5);
  EXPECT_TRUE(std::isinf(settings->table.extra[3].max_rad_mm));
  EXPECT_EQ(settings->limits.extra[3].velocity_mm_s, 20);
  EXPECT_EQ(settings->limits.extra[3].jerk_mm_s3, 2000);
}

TEST(MachineFileAxes, MustHaveEachLimit) {
  EXPECT_EQ(errors_of(kBounded + "[axes.c]\nmax_velocity_deg_s = 1\nmax_jerk_deg_s3 = 1\n"),
            Lines{"m.toml:5:1: error: axes.c.max_acceleration_deg_s2: expected a limit, which this "
                  "axis must have"});
}

TEST(MachineFileAxes, HaveKeysInTheUnitOfTheirKind) {
  EXPECT_EQ(errors_of(kBounded + "[axes.b]\n" + kLimitsOfA + "max_mm = 5\n"),
            Lines{"m.toml:9:1: error: unknown key 'max_mm' in [axes.b]"});
  EXPECT_EQ(errors_of(kBounded + "[axes.w]\n" + kLimitsOfU + "screw_lead_mm = 5\n"),
            Lines{"m.toml:9:1: error: unknown key 'screw_lead_mm' in [axes.w]"});
}

TEST(MachineFileAxes, HaveTravelThatIsSome) {
  EXPECT_EQ(errors_of(kBounded + "[axes.a]\n" + kLimitsOfA + "min_deg = 10\nmax_deg = 10\n"),
            Lines{"m.toml:10:11: error: axes.a.max_deg: found 10, expected more than min_deg, 10"});
}

TEST(MachineFileAxes, HaveOffsetsAndHomes) {
  const auto settings =
      parse_machine_file(kBounded + "[axes.a]\n" + kLimitsOfA + "[axes.w]\n" + kLimitsOfU +
                         "[offsets.g55]\na_deg = 30\nx_mm = 1\n[offsets.g28]\nw_mm = 5\n" +
                         "[offsets.g30]\na_deg = -2\n");
  ASSERT_TRUE(settings) << settings.error().front().message;
  EXPECT_EQ(settings->program.work[1].extra_deg_mm[0], 30.0);
  EXPECT_EQ(settings->program.first_home_extra_deg_mm[5], 5.0);
  EXPECT_EQ(settings->program.second_home_extra_deg_mm[0], -2.0);
  EXPECT_EQ(errors_of(kBounded + "[offsets.g55]\nu_mm = 1\n"),
            Lines{"m.toml:6:8: error: offsets.g55.u_mm: the machine has no such axis: there is no "
                  "[axes.u]"});
}

TEST(MachineFileAxes, HaveLimitsInTheirRange) {
  EXPECT_EQ(
      errors_of(kBounded + "[axes.v]\n" + kLimitsOfU + "max_mm = 2e6\n"),
      Lines{"m.toml:9:10: error: axes.v.max_mm: found 2e+06, expected a number from -1e+06 to "
            "1e+06"});
}

}  // namespace
}  // namespace kerf::test
