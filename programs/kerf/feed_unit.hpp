// Units of feedrates for people.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kerf::program {

enum class FeedUnit : std::uint8_t { mm_s, mm_min, inch_min };

inline constexpr std::array<std::string_view, 3> kFeedUnitNames{"mm/s", "mm/min", "inch/min"};

constexpr std::string_view name_of(FeedUnit unit) noexcept {
  return kFeedUnitNames[static_cast<std::size_t>(unit)];
}

// That many of the unit are one mm/s.
constexpr double per_mm_s(FeedUnit unit) noexcept {
  constexpr std::array kFactors{1.0, 60.0, 60.0 / 25.4};
  return kFactors[static_cast<std::size_t>(unit)];
}

}  // namespace kerf::program
