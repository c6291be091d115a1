// The arithmetic between two values.
#pragma once

#include <cstdint>
#include <string>

#include "diagnostics/diagnostic.hpp"
#include "parser/dialects/dialect.hpp"

namespace kerf::parser {

enum class BinaryOperator : std::uint8_t {
  none,
  power,
  multiply,
  divide,
  modulo,
  add,
  subtract,
  equal,
  not_equal,
  greater,
  greater_equal,
  less,
  less_equal,
  conjunction,   // AND: logical in RS274/NGC, of bits with Fanuc, as the next two
  disjunction,   // OR
  exclusive_or,  // XOR
};

struct Operands {
  double left = 0.0;
  double right = 0.0;
};

// A value, or what is wrong where `page` is set.
struct Outcome {
  double value = 0.0;
  const diagnostics::ErrorPage* page = nullptr;
  std::string message;
};

// What binds closest has the highest level; -1: the dialect does not have the operator.
// RS274/NGC: ** | * / MOD | + - | EQ NE GT GE LT LE | AND OR XOR, each from left to right [LinuxCNC
// 2.9, measured with rs274]. Fanuc: * / MOD AND | + - OR XOR | comparisons [B-64304EN, 16.2].
inline constexpr int kLowestLevel = 0;
inline constexpr int kHighestLevel = 4;
int level_of(BinaryOperator op, Dialect dialect);

// RS274/NGC: EQ and NE take values that differ by less than 0.0001 for equal, AND OR XOR are
// logical, MOD is never negative. Fanuc: AND OR XOR work on the bits of whole numbers, MOD has the
// sign of the left value, kVacant counts as 0 but equals only kVacant.
Outcome apply(BinaryOperator op, const Operands& operands, Dialect dialect);

}  // namespace kerf::parser
