// The path mode that a machine file names.
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

#include "kernel/machine_file_text.hpp"

namespace kerf {
namespace {

constexpr double kMax_mm = 1e3;

// The first word, taken off the text; empty at its end.
std::string_view take_word(std::string_view& text) {
  constexpr std::string_view kBlanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::size_t length = std::min(text.find_first_of(kBlanks), text.size());
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

std::optional<double> tolerance_of(std::string_view number) {
  double value = 0.0;
  const char* const end = number.data() + number.size();
  const auto read = std::from_chars(number.data(), end, value);
  const bool whole = read.ec == std::errc() && read.ptr == end;
  return whole && value >= 0.0 && value <= kMax_mm ? std::optional(value) : std::nullopt;
}

struct Tolerances {
  std::optional<double> p;
  std::optional<double> q;
};

// The words after G64. Nothing: one of them is neither P nor Q, comes twice or has no such number.
std::optional<Tolerances> tolerances_of(std::string_view words) {
  Tolerances found;
  for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
    if (word.front() != 'P' && word.front() != 'Q') {
      return std::nullopt;
    }
    std::optional<double>& tolerance = word.front() == 'P' ? found.p : found.q;
    const auto value = tolerance_of(word.substr(1));
    if (tolerance || !value) {
      return std::nullopt;
    }
    tolerance = value;
  }
  return found;
}

}  // namespace

std::optional<PathControl> path_control_of(std::string_view words, const ProgramData& machine) {
  const std::string_view mode = take_word(words);
  if (mode == "G61" || mode == "G61.1") {
    if (!take_word(words).empty()) {
      return std::nullopt;
    }
    return PathControl{.mode = mode == "G61" ? PathMode::exact_path : PathMode::exact_stop};
  }
  const auto tolerances = mode == "G64" ? tolerances_of(words) : std::nullopt;
  if (!tolerances) {
    return std::nullopt;
  }
  const auto& [p, q] = *tolerances;
  return PathControl{.mode = PathMode::blend,
                     .corner_tolerance_mm = p.value_or(machine.corner_tolerance_mm),
                     .merge_tolerance_mm = q.value_or(p.value_or(machine.merge_tolerance_mm))};
}

}  // namespace kerf
