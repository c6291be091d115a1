// Statistics of a run, gathered tick by tick from the setpoints and the machine's state.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "curves/position.hpp"
#include "interp/setpoint.hpp"
#include "machine/machine.hpp"

namespace kerf {

// How long and how far; the largest figures are TickJudge's.
class RunStatistics {
 public:
  // A, B, C, U, V and W count if the machine has one of them.
  explicit RunStatistics(double period_s, bool has_extra_axes = false)
      : period_s_(period_s), has_extra_axes_(has_extra_axes) {}

  void add(const interp::Setpoint& setpoint, const machine::MachineState& state);

  [[nodiscard]] std::int64_t ticks() const noexcept { return count_ > 0 ? count_ - 1 : 0; }
  [[nodiscard]] double cycle_time_s() const noexcept {
    return static_cast<double>(ticks()) * period_s_;
  }
  [[nodiscard]] double path_length_mm() const noexcept { return s_mm_; }
  // Of A, B, C in rad.
  [[nodiscard]] const curves::AuxiliaryExtents& extra_extents() const noexcept {
    return extra_extents_;
  }
  [[nodiscard]] const curves::Extents& extents() const noexcept { return extents_; }
  [[nodiscard]] double max_contour_error_mm() const noexcept { return max_contour_error_mm_; }
  [[nodiscard]] double mean_contour_error_mm() const noexcept {
    return count_ > 0 ? sum_contour_error_mm_ / static_cast<double>(count_) : 0.0;
  }
  [[nodiscard]] const std::array<double, 3>& max_following_error_mm() const noexcept {
    return max_following_error_mm_;
  }

 private:
  void add_extra(const curves::AuxiliaryPosition& position_rad_mm);

  double period_s_;
  bool has_extra_axes_;
  std::int64_t count_ = 0;
  double s_mm_ = 0.0;
  double max_contour_error_mm_ = 0.0;
  double sum_contour_error_mm_ = 0.0;
  std::array<double, 3> max_following_error_mm_{};
  curves::Extents extents_{};
  curves::AuxiliaryExtents extra_extents_{};
};

}  // namespace kerf
