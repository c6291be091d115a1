#include "programs/kerf/start_place.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace kerf::program {

std::optional<Position> position_of(std::string_view text) {
  constexpr double kFarthest_mm = 1e6;
  Position position{};
  for (std::size_t k = 0; k < position.size(); ++k) {
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, position[k]);
    if (read.ec != std::errc{} || !(std::abs(position[k]) <= kFarthest_mm)) {
      return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    const bool is_last = k + 1 == position.size();
    if (is_last != text.empty() || (!is_last && text.front() != ',')) {
      return std::nullopt;
    }
    text.remove_prefix(is_last ? 0 : 1);
  }
  return position;
}

std::optional<StartPlace> start_place_of(std::string_view text) {
  if (text == "first-move") {
    return AtFirstMove{};
  }
  const auto position = position_of(text);
  return position ? std::optional<StartPlace>(*position) : std::nullopt;
}

}  // namespace kerf::program
