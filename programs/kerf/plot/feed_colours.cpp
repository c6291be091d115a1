#include "programs/kerf/plot/feed_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

namespace {

using Rgb = std::array<double, 3>;

// plasma at 0, 0.11, 0.22, .. 0.77.
constexpr std::array<Rgb, 8> kStops{{{13, 8, 135},
                                     {71, 3, 159},
                                     {115, 1, 168},
                                     {156, 23, 158},
                                     {189, 55, 134},
                                     {216, 87, 107},
                                     {237, 121, 83},
                                     {251, 159, 58}}};

}  // namespace

std::size_t colour_level(double v_mm_s, double max_mm_s) noexcept {
  if (!(max_mm_s > 0.0)) {
    return 0;
  }
  const double share = std::clamp(v_mm_s / max_mm_s, 0.0, 1.0);
  const auto level = static_cast<std::size_t>(share * static_cast<double>(kColourLevels));
  return std::min(level, kColourLevels - 1);
}

std::string colour_of(std::size_t level) {
  const double place = static_cast<double>(level) / static_cast<double>(kColourLevels - 1) *
                       static_cast<double>(kStops.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const double share = place - static_cast<double>(stop);
  std::string text = "#";
  for (std::size_t k = 0; k < 3; ++k) {
    const double part = kStops[stop][k] + share * (kStops[stop + 1][k] - kStops[stop][k]);
    text += fmt::format("{:02x}", static_cast<unsigned>(std::lround(part)));
  }
  return text;
}

}  // namespace kerf::program
