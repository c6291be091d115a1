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

Outcome logical(BinaryOperator op, const Operands& operands) {
  const bool left = operands.left != 0.0;
  const bool right = operands.right != 0.0;
  return truth(op == BinaryOperator::conjunction
                   ? left && right
                   : (op == BinaryOperator::disjunction ? left || right : left != right));
}

Outcome bitwise(BinaryOperator op, const Operands& operands) {
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
  const std::uint32_t bits = op == BinaryOperator::conjunction
                                 ? l & r
                                 : (op == BinaryOperator::disjunction ? l | r : l ^ r);
  return {static_cast<double>(static_cast<std::int32_t>(bits)), nullptr, {}};
}

Outcome apply_plain(BinaryOperator op, const Operands& operands, Dialect dialect) {
  switch (op) {
    case BinaryOperator::power:
      return power(operands);
    case BinaryOperator::multiply:
      return finite(operands.left * operands.right);
    case BinaryOperator::divide:
      return divide(operands);
    case BinaryOperator::modulo:
      return modulo(operands, dialect);
    case BinaryOperator::add:
      return finite(operands.left + operands.right);
    case BinaryOperator::subtract:
      return finite(operands.left - operands.right);
    case BinaryOperator::equal:
      return truth(equal(operands, dialect));
    case BinaryOperator::not_equal:
      return truth(!equal(operands, dialect));
    case BinaryOperator::greater:
      return truth(operands.left > operands.right);
    case BinaryOperator::greater_equal:
      return truth(operands.left >= operands.right);
    case BinaryOperator::less:
      return truth(operands.left < operands.right);
    case BinaryOperator::less_equal:
      return truth(operands.left <= operands.right);
    default:
      return !rules_of(dialect).macro_arithmetic ? logical(op, operands) : bitwise(op, operands);
  }
}

}  // namespace

int level_of(BinaryOperator op, Dialect dialect) {
  constexpr std::array<int, 16> kNgc = {-1, 4, 3, 3, 3, 2, 2, 1, 1, 1, 1, 1, 1, 0, 0, 0};
  constexpr std::array<int, 16> kFanuc = {-1, -1, 3, 3, 3, 2, 2, 1, 1, 1, 1, 1, 1, 3, 2, 2};
  return (!rules_of(dialect).macro_arithmetic ? kNgc : kFanuc)[static_cast<std::size_t>(op)];
}

Outcome apply(BinaryOperator op, const Operands& operands, Dialect dialect) {
  const bool left = is_vacant(operands.left);
  const bool right = is_vacant(operands.right);
  if (left || right) {
    if (op == BinaryOperator::equal || op == BinaryOperator::not_equal) {
      return truth((left && right) == (op == BinaryOperator::equal));
    }
    return apply_plain(op, {left ? 0.0 : operands.left, right ? 0.0 : operands.right}, dialect);
  }
  return apply_plain(op, operands, dialect);
}

}  // namespace kerf::parser
