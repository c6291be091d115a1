#include "parser/expressions/operators.hpp"

#include <array>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/expressions/parameters.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kNgcTolerance = 1e-4;
// Two results of different roundings; a real difference of Fanuc's eight digits is far larger.
constexpr double kFanucTolerance = 1e-12;

Outcome finite(double value) {
  if (!std::isfinite(value)) {
    return {0.0, &errors::kNotFinite, "the result is not finite"};
  }
  return {value, nullptr, {}};
}

Outcome truth(bool value) {
  return {value ? 1.0 : 0.0, nullptr, {}};
}

Outcome power(const Operands& operands) {
  if (operands.left < 0.0 && operands.right != std::floor(operands.right)) {
    return {0.0, &errors::kFractionalPower, "a negative number is raised to a fractional power"};
  }
  return finite(std::pow(operands.left, operands.right));
}

Outcome divide(const Operands& operands) {
  if (operands.right == 0.0) {
    return {0.0, &errors::kDivisionByZero, "division by zero"};
  }
  return finite(operands.left / operands.right);
}

Outcome modulo(const Operands& operands, Dialect dialect) {
  if (operands.right == 0.0) {
    return {0.0, &errors::kDivisionByZero, "division by zero in MOD"};
  }
  const double rest = std::fmod(operands.left, operands.right);
  const bool lift = rest < 0.0 && !rules_of(dialect).macro_arithmetic;
  return finite(lift ? rest + std::fabs(operands.right) : rest);
}

bool equal(const Operands& operands, Dialect dialect) {
  const double difference = std::fabs(operands.left - operands.right);
  if (!rules_of(dialect).macro_arithmetic) {
    return difference < kNgcTolerance;
  }
  return difference <=
         kFanucTolerance * std::fmax(std::fabs(operands.left), std::fabs(operands.right));
}

Outcome logical(Operator op, const Operands& operands) {
  const bool left = operands.left != 0.0;
  const bool right = operands.right != 0.0;
  return truth(op == Operator::conjunction
                   ? left && right
                   : (op == Operator::disjunction ? left || right : left != right));
}

Outcome bitwise(Operator op, const Operands& operands) {
  constexpr double kMax = 2147483647.0;
  for (const double value : {operands.left, operands.right}) {
    if (!(std::fabs(value) <= kMax)) {
      return {0.0, &errors::kNotABitPattern,
              joined({"AND, OR and XOR need whole numbers of 32 bits, found ", shortest(value)})};
    }
  }
  const auto left = static_cast<std::int32_t>(std::lround(operands.left));
  const auto right = static_cast<std::int32_t>(std::lround(operands.right));
  const auto l = static_cast<std::uint32_t>(left);
  const auto r = static_cast<std::uint32_t>(right);
  const std::uint32_t bits =
      op == Operator::conjunction ? l & r : (op == Operator::disjunction ? l | r : l ^ r);
  return {static_cast<double>(static_cast<std::int32_t>(bits)), nullptr, {}};
}

Outcome apply_plain(Operator op, const Operands& operands, Dialect dialect) {
  switch (op) {
    case Operator::power:
      return power(operands);
    case Operator::multiply:
      return finite(operands.left * operands.right);
    case Operator::divide:
      return divide(operands);
    case Operator::modulo:
      return modulo(operands, dialect);
    case Operator::add:
      return finite(operands.left + operands.right);
    case Operator::subtract:
      return finite(operands.left - operands.right);
    case Operator::equal:
      return truth(equal(operands, dialect));
    case Operator::not_equal:
      return truth(!equal(operands, dialect));
    case Operator::greater:
      return truth(operands.left > operands.right);
    case Operator::greater_equal:
      return truth(operands.left >= operands.right);
    case Operator::less:
      return truth(operands.left < operands.right);
    case Operator::less_equal:
      return truth(operands.left <= operands.right);
    default:
      return !rules_of(dialect).macro_arithmetic ? logical(op, operands) : bitwise(op, operands);
  }
}

}  // namespace

int level_of(Operator op, Dialect dialect) {
  constexpr std::array<int, 16> kNgc = {-1, 4, 3, 3, 3, 2, 2, 1, 1, 1, 1, 1, 1, 0, 0, 0};
  constexpr std::array<int, 16> kFanuc = {-1, -1, 3, 3, 3, 2, 2, 1, 1, 1, 1, 1, 1, 3, 2, 2};
  return (!rules_of(dialect).macro_arithmetic ? kNgc : kFanuc)[static_cast<std::size_t>(op)];
}

Outcome apply(Operator op, const Operands& operands, Dialect dialect) {
  const bool left = is_vacant(operands.left);
  const bool right = is_vacant(operands.right);
  if (left || right) {
    if (op == Operator::equal || op == Operator::not_equal) {
      return truth((left && right) == (op == Operator::equal));
    }
    return apply_plain(op, {left ? 0.0 : operands.left, right ? 0.0 : operands.right}, dialect);
  }
  return apply_plain(op, operands, dialect);
}

}  // namespace kerf::parser
