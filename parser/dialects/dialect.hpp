// Which control's language a program is written in, and how the languages differ.
#pragma once

#include <array>
#include <cstddef>

#include <kerf/program_data.hpp>

#include "parser/dialects/fanuc_rules.hpp"
#include "parser/dialects/rs274_rules.hpp"

namespace kerf::parser {

using kerf::Dialect;

inline constexpr std::array kDialectRules{kRs274Rules, kFanucRules};  // in the order of Dialect

constexpr const DialectRules& rules_of(Dialect dialect) {
  return kDialectRules[static_cast<std::size_t>(dialect)];
}

}  // namespace kerf::parser
