// What a run did, gathered tick by tick from the setpoints and the machine's answers.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "curves/position.hpp"
#include "interp/setpoint.hpp"
#include "machine/machine.hpp"

namespace kerf {

// Largest figures of velocity, acceleration and jerk.
struct Peaks {
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;
};

// Figures along the path come from the arc length between ticks, those of the axes from positions,
// both by finite differences: what a drive sees, not what the plan says of itself.
class RunStatistics {
 public:
  // A, B, C, U, V and W are looked at where the machine has one of them.
  explicit RunStatistics(double period_s, bool has_extra_axes = false)
      : period_s_(period_s), has_extra_axes_(has_extra_axes) {}

  void add(const interp::Setpoint& setpoint, double chord_error_mm,
           const machine::MachineState& state);

  [[nodiscard]] std::int64_t ticks() const noexcept { return count_ > 0 ? count_ - 1 : 0; }
  [[nodiscard]] double cycle_time_s() const noexcept {
    return static_cast<double>(ticks()) * period_s_;
  }
  [[nodiscard]] double path_length_mm() const noexcept { return s_mm_[0]; }
  [[nodiscard]] const Peaks& path() const noexcept { return path_; }
  [[nodiscard]] const std::array<Peaks, 3>& axes() const noexcept { return axes_; }
  // Of A, B, C in rad.
  [[nodiscard]] const std::array<Peaks, curves::kExtraAxes>& extra_axes() const noexcept {
    return extra_;
  }
  [[nodiscard]] const curves::ExtraExtents& extra_extents() const noexcept {
    return extra_extents_;
  }
  [[nodiscard]] double chord_error_mm() const noexcept { return chord_error_mm_; }
  [[nodiscard]] const curves::Extents& extents() const noexcept { return extents_; }
  [[nodiscard]] double max_contour_error_mm() const noexcept { return max_contour_error_mm_; }
  [[nodiscard]] double mean_contour_error_mm() const noexcept {
    return count_ > 0 ? sum_contour_error_mm_ / static_cast<double>(count_) : 0.0;
  }
  [[nodiscard]] const std::array<double, 3>& max_following_error_mm() const noexcept {
    return max_following_error_mm_;
  }

 private:
  void add_extra(const curves::ExtraPosition& position_rad_mm);

  double period_s_;
  bool has_extra_axes_;
  std::int64_t count_ = 0;
  // The last four values, newest first.
  std::array<double, 4> s_mm_{};
  std::array<curves::Position, 4> position_mm_{};
  Peaks path_{};
  std::array<Peaks, 3> axes_{};
  double chord_error_mm_ = 0.0;
  double max_contour_error_mm_ = 0.0;
  double sum_contour_error_mm_ = 0.0;
  std::array<double, 3> max_following_error_mm_{};
  curves::Extents extents_{};
  std::array<std::array<double, 4>, curves::kExtraAxes> extra_rad_mm_{};  // newest first
  std::array<Peaks, curves::kExtraAxes> extra_{};
  curves::ExtraExtents extra_extents_{};
};

}  // namespace kerf
