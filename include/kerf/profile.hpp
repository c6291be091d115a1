// Feedrate profiles by name.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <kerf/api.hpp>

namespace kerf {
inline namespace v0 {

/// time_optimal is found for the whole path; the others say how one change of feedrate runs.
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

/// "trapezoid", "s-curve", "sine", "quintic", "sine-series", "sigmoid", "time-optimal".
KERF_API std::string_view name_of(ProfileKind kind);
/// Nothing for any other name; case matters.
KERF_API std::optional<ProfileKind> profile_kind(std::string_view name);

/// sigmoid_shape fixes s of the sigmoid, from 0.1 on; without it s is chosen for each transition.
/// The other profiles ignore it.
struct ProfileChoice {
  ProfileKind kind = kDefaultProfile;
  std::optional<double> sigmoid_shape{};
};

}  // namespace v0
}  // namespace kerf
