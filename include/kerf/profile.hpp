// Feedrate profiles by name.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <kerf/api.hpp>

namespace kerf {
inline namespace v0 {

/// time_optimal plans the whole path at once; the others say how one change of feedrate runs. A new
/// one goes before time_optimal, which is the last.
enum class ProfileKind : std::uint8_t {
  trapezoid,
  s_curve,
  sine,
  quintic,
  sine_series,
  sigmoid,
  time_optimal,
};

inline constexpr ProfileKind kDefaultProfile = ProfileKind::time_optimal;

/// "trapezoid", "s-curve", "sine", "quintic", "sine-series", "sigmoid", "time-optimal". kind must
/// be one of the enumerators.
KERF_API std::string_view name_of(ProfileKind kind);
/// Nothing for any other name; case matters.
KERF_API std::optional<ProfileKind> profile_kind(std::string_view name);

/// sigmoid_shape: s of the sigmoid, 0.1 to 5.11; without it s is chosen for each transition. Other
/// profiles do not use it, but validate() checks its range.
struct ProfileChoice {
  ProfileKind kind = kDefaultProfile;
  std::optional<double> sigmoid_shape{};
};

}  // namespace v0
}  // namespace kerf
