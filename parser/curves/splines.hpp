// G5 and G5.1: one Bezier curve per block.
#pragma once

#include <array>
#include <optional>

#include "parser/curves/curve_block.hpp"

namespace kerf::parser {

struct Spline {
  NurbsMove curve;
  std::optional<std::array<double, 2>> second_handle_mm;  // of G5, for the next one
};

// Nothing: a code of high-speed machining, which is warned of.
Expected<std::optional<Spline>> cubic_spline(const RunningBlock& at, ModalState& state);
Expected<std::optional<Spline>> quadratic_spline(const RunningBlock& at, ModalState& state);

}  // namespace kerf::parser
