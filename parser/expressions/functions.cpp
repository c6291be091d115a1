#include "parser/expressions/functions.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/expressions/parameters.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegrees = 180.0 / kPi;

struct Entry {
  std::string_view name;
  Function function;
  bool ngc;
  bool fanuc;
};
// Where two begin with the same two letters, Fanuc's abbreviation means the first.
constexpr std::array kFunctions = {
    Entry{"ABS", Function::abs, true, true},   Entry{"ACOS", Function::acos, true, true},
    Entry{"ASIN", Function::asin, true, true}, Entry{"ATAN", Function::atan, true, true},
    Entry{"BCD", Function::bcd, false, true},  Entry{"BIN", Function::bin, false, true},
    Entry{"COS", Function::cos, true, true},   Entry{"EXISTS", Function::exists, true, false},
    Entry{"EXP", Function::exp, true, true},   Entry{"FIX", Function::fix, true, true},
    Entry{"FUP", Function::fup, true, true},   Entry{"LN", Function::ln, true, true},
    Entry{"POW", Function::pow, false, true},  Entry{"ROUND", Function::round, true, true},
    Entry{"SIN", Function::sin, true, true},   Entry{"SQRT", Function::sqrt, true, true},
    Entry{"TAN", Function::tan, true, true},
};

Outcome finite(double value) {
  if (!std::isfinite(value)) {
    return {0.0, &errors::kNotFinite, "the result is not finite"};
  }
  return {value, nullptr, {}};
}

// Sine and cosine of an angle in degrees, exact at every multiple of 90.
struct SineCosine {
  double sine;
  double cosine;
};
SineCosine sine_cosine(double angle_deg) {
  int quarter = 0;
  const double rest = std::remquo(angle_deg, 90.0, &quarter) / kDegrees;
  const double sine = std::sin(rest);
  const double cosine = std::cos(rest);
  switch (quarter & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

Outcome tangent(double angle_deg) {
  const auto [sine, cosine] = sine_cosine(angle_deg);
  if (cosine == 0.0) {
    return {0.0, &errors::kNotFinite,
            joined({"TAN has no value at ", shortest(angle_deg), " degrees"})};
  }
  return {sine / cosine, nullptr, {}};
}

Outcome arc_function(Function function, double argument) {
  const bool sine = function == Function::asin;
  if (!(std::fabs(argument) <= 1.0)) {
    return {0.0, &errors::kArcFunctionRange,
            joined({sine ? "ASIN" : "ACOS", ": the argument must be -1 to 1, found ",
                    shortest(argument)})};
  }
  return {(sine ? std::asin(argument) : std::acos(argument)) * kDegrees, nullptr, {}};
}

// BCD writes a number's decimal digits as the digits of a hexadecimal one; BIN is its inverse.
Outcome recode(Function function, double argument) {
  const bool to_bcd = function == Function::bcd;
  const std::uint32_t from = to_bcd ? 10 : 16;
  const std::uint32_t base = to_bcd ? 16 : 10;
  const double whole = std::round(argument);
  const auto refuse = [&] {
    return Outcome{0.0, &errors::kNotDecimalDigits,
                   joined({to_bcd ? "BCD" : "BIN", " needs eight decimal digits at most, found ",
                           shortest(argument)})};
  };
  if (!(whole >= 0.0 && whole < (to_bcd ? 1e8 : 4294967296.0))) {
    return refuse();
  }
  double result = 0.0;
  double place = 1.0;
  for (auto rest = static_cast<std::uint32_t>(whole); rest > 0; rest /= from) {
    if (rest % from > 9) {
      return refuse();
    }
    result += place * (rest % from);
    place *= base;
  }
  return {result, nullptr, {}};
}

Outcome logarithm(double argument) {
  if (!(argument > 0.0)) {
    return {0.0, &errors::kLogarithmRange,
            joined({"LN: the argument must be greater than 0, found ", shortest(argument)})};
  }
  return {std::log(argument), nullptr, {}};
}

Outcome square_root(double argument) {
  if (argument < 0.0) {
    return {0.0, &errors::kNegativeRoot,
            joined({"SQRT of a negative number (", shortest(argument), ")"})};
  }
  return {std::sqrt(argument), nullptr, {}};
}

}  // namespace

Function find_function(std::string_view name, Dialect dialect) {
  const bool fanuc = rules_of(dialect).macro_arithmetic;
  for (const Entry& entry : kFunctions) {
    const bool known = fanuc ? entry.fanuc : entry.ngc;
    const bool shortened = fanuc && name.size() == 2 && entry.name.substr(0, 2) == name;
    if (known && (entry.name == name || shortened)) {
      return entry.function;
    }
  }
  return Function::none;
}

double arc_tangent_deg(double y, double x, Dialect dialect) {
  // A zero has no sign here: adding +0 takes it off.
  const double angle = std::atan2(y + 0.0, x + 0.0) * kDegrees;
  return rules_of(dialect).macro_arithmetic && angle < 0.0 ? angle + 360.0 : angle;
}

Outcome apply(Function function, double argument, Dialect dialect) {
  const double x = is_vacant(argument) ? 0.0 : argument;
  const bool fanuc = rules_of(dialect).macro_arithmetic;
  switch (function) {
    case Function::abs:
      return {std::fabs(x), nullptr, {}};
    case Function::acos:
    case Function::asin:
      return arc_function(function, x);
    case Function::atan:
      return {std::atan(x) * kDegrees, nullptr, {}};
    case Function::bcd:
    case Function::bin:
      return recode(function, x);
    case Function::cos:
      return {sine_cosine(x).cosine, nullptr, {}};
    case Function::exp:
      return finite(std::exp(x));
    case Function::fix:
      return {fanuc ? std::trunc(x) : std::floor(x), nullptr, {}};
    case Function::fup:
      return {fanuc && x < 0.0 ? std::floor(x) : std::ceil(x), nullptr, {}};
    case Function::ln:
      return logarithm(x);
    case Function::round:
      return {std::round(x), nullptr, {}};
    case Function::sin:
      return {sine_cosine(x).sine, nullptr, {}};
    case Function::sqrt:
      return square_root(x);
    case Function::tan:
      return tangent(x);
    default:
      return {x, nullptr, {}};
  }
}

}  // namespace kerf::parser
