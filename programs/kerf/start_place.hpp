// Where the tool is when a program begins, as --start says.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include <kerf/axes.hpp>

namespace kerf::program {

// Where the first moves bring each axis first: the program then has no approach.
struct AtFirstMove {};

// In machine coordinates.
using StartPlace = std::variant<Position, AtFirstMove>;

// "1,-2.5,30" in mm; nothing where it is not that.
[[nodiscard]] std::optional<Position> position_of(std::string_view text);

// The same, or "first-move".
[[nodiscard]] std::optional<StartPlace> start_place_of(std::string_view text);

}  // namespace kerf::program
