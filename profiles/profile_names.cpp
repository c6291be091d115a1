#include <algorithm>
#include <array>

#include <kerf/profile.hpp>

namespace kerf {
inline namespace v0 {
namespace {

constexpr auto kNames = std::to_array<std::string_view>(
    {"trapezoid", "s-curve", "sine", "quintic", "sine-series", "sigmoid", "time-optimal"});
static_assert(kNames.size() == static_cast<std::size_t>(ProfileKind::time_optimal) + 1);

}  // namespace

std::string_view name_of(ProfileKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<ProfileKind> profile_kind(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) {
    return std::nullopt;
  }
  return static_cast<ProfileKind>(found - kNames.begin());
}

}  // namespace v0
}  // namespace kerf
