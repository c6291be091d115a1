// Why a curve cannot be built.
#pragma once

#include <cstddef>
#include <string>

namespace kerf::curves {

struct CurveError {
  enum class Where : unsigned char { whole, point, knot };
  std::string message;         // with the numbers that broke the rule
  Where where = Where::whole;  // what index counts, to find the source line to blame
  std::size_t index = 0;
};

}  // namespace kerf::curves
