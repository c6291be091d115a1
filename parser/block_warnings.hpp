// What is odd about a block without being wrong.
#pragma once

#include <cstdint>

#include "parser/block.hpp"
#include "parser/diagnostic_list.hpp"
#include "parser/dialect.hpp"

namespace kerf::parser {

struct LineInDialect {
  std::uint32_t number = 0;
  Dialect dialect = Dialect::rs274;
};

void warn_about(const Block& block, LineInDialect where, DiagnosticList& diagnostics);

}  // namespace kerf::parser
