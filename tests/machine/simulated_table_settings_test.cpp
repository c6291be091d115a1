#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "machine/simulated_table.hpp"

namespace {

using kerf::AxisDrive;
using kerf::TableSettings;
using kerf::machine::is_valid;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(TableSettings, AreValidAsTheyStand) {
  EXPECT_TRUE(is_valid(TableSettings{}));
  TableSettings fine{};
  fine.axes[1].counts_per_rev = kInfinity;
  EXPECT_TRUE(is_valid(fine));
}

TEST(TableSettings, AreNotValidWithOneImpossibleNumberOnAnyAxis) {
  struct Case {
    std::function<double&(AxisDrive&)> field;
    std::vector<double> bad;
  };
  const std::vector<double> not_positive{0.0, -1.0, kNotANumber, kInfinity};
  const std::vector<double> negative{-1.0, kNotANumber, kInfinity};
  const std::vector<Case> cases{
      {[](AxisDrive& a) -> double& { return a.travel.min_mm; }, {kNotANumber, kInfinity}},
      {[](AxisDrive& a) -> double& { return a.travel.max_mm; }, {kNotANumber, -kInfinity}},
      {[](AxisDrive& a) -> double& { return a.drive_velocity_mm_s; }, not_positive},
      {[](AxisDrive& a) -> double& { return a.drive_acceleration_mm_s2; }, not_positive},
      {[](AxisDrive& a) -> double& { return a.screw_lead_mm; }, not_positive},
      {[](AxisDrive& a) -> double& { return a.counts_per_rev; }, {0.0, -1.0, kNotANumber}},
      {[](AxisDrive& a) -> double& { return a.position_gain_per_s; }, not_positive},
      {[](AxisDrive& a) -> double& { return a.velocity_gain_per_s; }, not_positive},
      {[](AxisDrive& a) -> double& { return a.velocity_integral_per_s2; }, negative},
      {[](AxisDrive& a) -> double& { return a.feed_forward; }, {-0.1, 1.1, kNotANumber}},
      {[](AxisDrive& a) -> double& { return a.coulomb_friction_mm_s2; }, negative},
      {[](AxisDrive& a) -> double& { return a.viscous_friction_per_s; }, negative},
      {[](AxisDrive& a) -> double& { return a.max_following_error_mm; }, not_positive},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const double bad : cases[i].bad) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        TableSettings settings{};
        cases[i].field(settings.axes[axis]) = bad;
        EXPECT_FALSE(is_valid(settings)) << "field " << i << " = " << bad << ", axis " << axis;
      }
    }
  }
}

TEST(TableSettings, AreNotValidWithAPeriodOutOfRange) {
  for (const double period_s : {0.0, -0.001, 0.9e-5, 0.11, kNotANumber, kInfinity}) {
    EXPECT_FALSE(is_valid(TableSettings{.period_s = period_s})) << period_s;
  }
}

}  // namespace
