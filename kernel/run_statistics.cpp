#include "kernel/run_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

// Differences of the last four values, newest first; those that would need a tick before the first
// one take it as at rest, as it is.
void raise(Peaks& peaks, const std::array<double, 4>& x, double period_s) {
  const double v = (x[0] - x[1]) / period_s;
  const double a = (x[0] - 2.0 * x[1] + x[2]) / (period_s * period_s);
  const double j = (x[0] - 3.0 * (x[1] - x[2]) - x[3]) / (period_s * period_s * period_s);
  peaks.v_mm_s = std::max(peaks.v_mm_s, std::abs(v));
  peaks.a_mm_s2 = std::max(peaks.a_mm_s2, std::abs(a));
  peaks.j_mm_s3 = std::max(peaks.j_mm_s3, std::abs(j));
}

template <typename T>
void shift_in(std::array<T, 4>& values, const T& newest) {
  std::copy_backward(values.begin(), values.end() - 1, values.end());
  values[0] = newest;
}

}  // namespace

void RunStatistics::add_extra(const curves::ExtraPosition& position_rad_mm) {
  if (count_ == 0) {
    extra_extents_ = {.min_rad_mm = position_rad_mm, .max_rad_mm = position_rad_mm};
  }
  for (std::size_t k = 0; k < curves::kExtraAxes; ++k) {
    const double x = position_rad_mm[k];
    if (count_ == 0) {
      extra_rad_mm_[k].fill(x);
    }
    shift_in(extra_rad_mm_[k], x);
    raise(extra_[k], extra_rad_mm_[k], period_s_);
    extra_extents_.min_rad_mm[k] = std::min(extra_extents_.min_rad_mm[k], x);
    extra_extents_.max_rad_mm[k] = std::max(extra_extents_.max_rad_mm[k], x);
  }
}

void RunStatistics::add(const interp::Setpoint& setpoint, double chord_error_mm,
                        const machine::MachineState& state) {
  if (count_ == 0) {
    s_mm_.fill(setpoint.s_mm);
    position_mm_.fill(setpoint.position_mm);
    extents_ = {.min_mm = setpoint.position_mm, .max_mm = setpoint.position_mm};
  }
  if (has_extra_axes_) {
    add_extra(setpoint.extra_rad_mm);
  }
  ++count_;
  shift_in(s_mm_, setpoint.s_mm);
  shift_in(position_mm_, setpoint.position_mm);
  raise(path_, s_mm_, period_s_);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<double, 4> axis{position_mm_[0][k], position_mm_[1][k], position_mm_[2][k],
                                     position_mm_[3][k]};
    raise(axes_[k], axis, period_s_);
    extents_.min_mm[k] = std::min(extents_.min_mm[k], setpoint.position_mm[k]);
    extents_.max_mm[k] = std::max(extents_.max_mm[k], setpoint.position_mm[k]);
    max_following_error_mm_[k] =
        std::max(max_following_error_mm_[k], std::abs(state.following_error_mm[k]));
  }
  chord_error_mm_ = std::max(chord_error_mm_, chord_error_mm);
  max_contour_error_mm_ = std::max(max_contour_error_mm_, state.contour_error_mm);
  sum_contour_error_mm_ += state.contour_error_mm;
}

}  // namespace kerf
