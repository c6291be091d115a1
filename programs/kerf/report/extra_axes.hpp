// The axes A, B, C, U, V and W that a machine has, as people read them: in degrees and mm.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "parser/moves/auxiliary_axes.hpp"

namespace kerf::program {

struct ExtraAxis {
  std::size_t index = 0;    // in arrays of all six
  std::string_view name{};  // "a"
  std::string_view unit{};  // "deg" or "mm"
  double factor = 1.0;      // from rad or mm to the unit
};

[[nodiscard]] std::vector<ExtraAxis> extra_axes(parser::Letters named);

}  // namespace kerf::program
