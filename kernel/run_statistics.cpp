#include "kernel/run_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

void RunStatistics::add_extra(const curves::AuxiliaryPosition& position_rad_mm) {
  if (count_ == 0) {
    extra_extents_ = {.min_rad_mm = position_rad_mm, .max_rad_mm = position_rad_mm};
  }
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes; ++k) {
    const double x = position_rad_mm[k];
    extra_extents_.min_rad_mm[k] = std::min(extra_extents_.min_rad_mm[k], x);
    extra_extents_.max_rad_mm[k] = std::max(extra_extents_.max_rad_mm[k], x);
  }
}

void RunStatistics::add(const interp::Setpoint& setpoint, const machine::MachineState& state) {
  if (count_ == 0) {
    extents_ = {.min_mm = setpoint.position_mm, .max_mm = setpoint.position_mm};
  }
  if (has_extra_axes_) {
    add_extra(setpoint.extra_rad_mm);
  }
  ++count_;
  s_mm_ = setpoint.s_mm;
  for (std::size_t k = 0; k < 3; ++k) {
    extents_.min_mm[k] = std::min(extents_.min_mm[k], setpoint.position_mm[k]);
    extents_.max_mm[k] = std::max(extents_.max_mm[k], setpoint.position_mm[k]);
    max_following_error_mm_[k] =
        std::max(max_following_error_mm_[k], std::abs(state.following_error_mm[k]));
  }
  max_contour_error_mm_ = std::max(max_contour_error_mm_, state.contour_error_mm);
  sum_contour_error_mm_ += state.contour_error_mm;
}

}  // namespace kerf
