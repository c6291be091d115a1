// The functions of an expression.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "parser/dialects/dialect.hpp"
#include "parser/expressions/operators.hpp"

namespace kerf::parser {

enum class Function : std::uint8_t {
  none,
  abs,
  acos,
  asin,
  atan,
  bcd,
  bin,
  cos,
  exists,
  exp,
  fix,
  fup,
  ln,
  pow,
  round,
  sin,
  sqrt,
  tan,
};

// `name` in capitals. Fanuc takes two letters for the name (RO for ROUND). none: not known.
Function find_function(std::string_view name, Dialect dialect);

// A function of one value. Angles are in degrees. RS274/NGC: FIX goes down, FUP up. Fanuc: FIX goes
// towards 0, FUP away from it; kVacant counts as 0.
Outcome apply(Function function, double argument, Dialect dialect);

// ATAN[y]/[x], -180 to 180 degrees; Fanuc 0 to 360.
double arc_tangent_deg(double y, double x, Dialect dialect);

}  // namespace kerf::parser
