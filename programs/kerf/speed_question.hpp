// The question that --explain-speed asks.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace kerf::program {

// Besides the whole program: nothing, a line, or an instant; of a comparison each line.
struct SpeedQuestion {
  std::optional<std::uint32_t> line{};
  std::optional<double> time_s{};
  bool each_line = false;
};

// "all", a line's number, or "@" and seconds >= 0; nothing where it is none of them.
[[nodiscard]] std::optional<SpeedQuestion> speed_question(std::string_view text);

}  // namespace kerf::program
