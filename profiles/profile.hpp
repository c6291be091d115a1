// A feedrate law by name: the fastest transition it allows, and how far it reaches.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "profiles/transition.hpp"

namespace kerf::profiles {

enum class ProfileKind : std::uint8_t { trapezoid, s_curve, sine, quintic, sine_series, sigmoid };

// "trapezoid", "s-curve", "sine", "quintic", "sine-series", "sigmoid".
std::string_view name_of(ProfileKind kind);
std::optional<ProfileKind> profile_kind(std::string_view name);

class Profile {
 public:
  // sigmoid_shape fixes s of the sigmoid (> 0); without it s is chosen for each transition.
  explicit Profile(ProfileKind kind, std::optional<double> sigmoid_shape = std::nullopt);

  [[nodiscard]] ProfileKind kind() const noexcept { return kind_; }

  // The shortest duration of a change of feedrate by change_mm_s (either sign): MATH section 1,
  // T = max(a* |dv| / A, sqrt(j* |dv| / J)). The trapezoid does not know jerk.
  [[nodiscard]] double duration_s(double change_mm_s, const RampLimits& limits) const;
  // The transition of that duration.
  [[nodiscard]] Transition fastest(const Ramp& ramp, const RampLimits& limits) const;
  // The largest feedrate >= v_mm_s that a transition from v_mm_s attains within length_mm.
  // By symmetry also the largest from which v_mm_s is attained. Never too large: the transition to
  // the answer fits into length_mm. Infinite where no limit binds.
  [[nodiscard]] double reach_mm_s(double v_mm_s, double length_mm, const RampLimits& limits) const;

 private:
  ProfileKind kind_;
  std::optional<double> sigmoid_shape_;
};

}  // namespace kerf::profiles
