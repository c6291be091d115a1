#include "programs/kerf/speed_question.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace kerf::program {

namespace {

// All of the text as a number.
template <typename T>
std::optional<T> number_in(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && after == end ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<SpeedQuestion> speed_question(std::string_view text) {
  if (text == "all") {
    return SpeedQuestion{};
  }
  if (text.starts_with('@')) {
    const auto time_s = number_in<double>(text.substr(1));
    const bool known = time_s && std::isfinite(*time_s) && *time_s >= 0.0 && *time_s < 1e9;
    return known ? std::optional(SpeedQuestion{.time_s = time_s}) : std::nullopt;
  }
  const auto line = number_in<std::uint32_t>(text);
  return line && *line > 0 ? std::optional(SpeedQuestion{.line = line}) : std::nullopt;
}

}  // namespace kerf::program
