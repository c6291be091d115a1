// One cell of the time optimum as a time law: feedrate squared is a quadratic in arc length.
#pragma once

#include <cstdint>

#include "profiles/shape_value.hpp"

namespace kerf::profiles {

// Four kinds, each in closed form. Trivially copyable: it crosses to the tick side.
//
//   between  v^2 = v0^2 + 2 a0 s + k s^2, so s'' = a0 + k s: sinh and cosh, or sin and cos. Jerk is
//            k v. Feedrate and acceleration go on into the next cell; only k jumps.
//   launch   constant jerk from rest: s = j t^3 / 6
//   landing  the same to rest, backwards in time
//   ramp     constant jerk from any feedrate and acceleration
class CellLaw {
 public:
  // At the beginning of the cell; k = bend_per_s2 is half the second derivative of v^2 by s.
  struct Begin {
    double v_mm_s = 0.0;
    double a_mm_s2 = 0.0;
    double bend_per_s2 = 0.0;
  };

  CellLaw() = default;
  // Precondition: length_mm > 0, v > 0, v^2 > 0 throughout.
  static CellLaw between(const Begin& begin, double length_mm) noexcept;
  // Precondition: both > 0.
  static CellLaw launch(double v_end_mm_s, double length_mm) noexcept;
  static CellLaw landing(double v_begin_mm_s, double length_mm) noexcept;
  struct RampStart {
    double v_mm_s = 0.0;
    double a_mm_s2 = 0.0;
    double j_mm_s3 = 0.0;
  };
  // Precondition: the duration is above 0, and v >= 0 throughout.
  static CellLaw ramp(const RampStart& begin, double duration_s) noexcept;

  [[nodiscard]] double v_begin_mm_s() const noexcept { return begin_.v_mm_s; }
  [[nodiscard]] double v_end_mm_s() const noexcept { return v_end_mm_s_; }
  [[nodiscard]] double duration_s() const noexcept { return duration_s_; }
  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }
  // Motion t_s after the start; s counts from 0 there. t_s outside [0, duration] is clamped.
  [[nodiscard]] PathMotion at(double t_s) const noexcept;
  // When the motion has come that far. Outside [0, length] it is clamped.
  [[nodiscard]] double time_at_s(double s_mm) const noexcept;
  // What the law does between two times: 0 <= begin < end <= duration.
  struct Times {
    double begin_s = 0.0;
    double end_s = 0.0;
  };
  [[nodiscard]] CellLaw part(const Times& times) const noexcept;

 private:
  enum class Kind : std::uint8_t { between, launch, landing, ramp };

  [[nodiscard]] PathMotion ramp_at(double t_s) const noexcept;

  Begin begin_{};  // of a ramp: its jerk in place of the bend
  double v_end_mm_s_ = 0.0;
  double duration_s_ = 0.0;
  double length_mm_ = 0.0;
  Kind kind_ = Kind::between;
};

}  // namespace kerf::profiles
