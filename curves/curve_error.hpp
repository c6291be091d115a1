// Why a curve cannot be built.
#pragma once

#include <cstddef>
#include <string>

#include "curves/position.hpp"

namespace kerf::curves {

struct CurveError {
  enum class Where : unsigned char { whole, point, knot };
  std::string message;         // with the numbers that broke the rule
  Where where = Where::whole;  // what index counts, to find the source line to blame
  std::size_t index = 0;
};

// The shortest text that reads back as the same number, whatever the locale.
std::string to_text(double number);
// (x, y, z)
std::string to_text(const Position& p_mm);

}  // namespace kerf::curves
