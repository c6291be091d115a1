#include "machine/table_settings.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::machine {
namespace {

bool positive(double value) {
  return value > 0.0 && std::isfinite(value);
}
bool not_negative(double value) {
  return value >= 0.0 && std::isfinite(value);
}

bool is_valid_axis(const AxisDrive& axis) {
  return axis.travel.min_mm < axis.travel.max_mm && positive(axis.drive_velocity_mm_s) &&
         positive(axis.drive_acceleration_mm_s2) && positive(axis.screw_lead_mm) &&
         axis.counts_per_rev > 0.0 && positive(axis.position_gain_per_s) &&
         positive(axis.velocity_gain_per_s) && not_negative(axis.velocity_integral_per_s2) &&
         axis.feed_forward >= 0.0 && axis.feed_forward <= 1.0 &&
         not_negative(axis.coulomb_friction_mm_s2) && not_negative(axis.viscous_friction_per_s) &&
         positive(axis.max_following_error_mm);
}

}  // namespace

bool is_valid(const TableSettings& settings) noexcept {
  return settings.period_s >= 1e-5 && settings.period_s <= 0.1 &&
         std::all_of(settings.axes.begin(), settings.axes.end(), is_valid_axis) &&
         std::all_of(settings.extra.begin(), settings.extra.end(),
                     [](const AuxiliaryTravel& t) { return t.min_rad_mm < t.max_rad_mm; });
}

}  // namespace kerf::machine
