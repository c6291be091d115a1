// Warnings about blocks that are odd but not wrong.
#pragma once

#include <cstdint>

#include "diagnostics/diagnostic_list.hpp"
#include "parser/block/block.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

// Warnings that a program gets once, however many blocks give reason for them.
struct SaidOnce {
  bool fine_number = false;
  bool no_point = false;
};

struct LineInDialect {
  std::uint32_t number = 0;
  Dialect dialect = Dialect::rs274;
};

void warn_about(const BlockWords& block, LineInDialect where, SaidOnce& said,
                diagnostics::DiagnosticList& diagnostics);

// Of the Fanuc dialect: a coordinate without a decimal point, which a control may read in least
// increments. Precondition: numbers count in units.
void warn_of_missing_point(const BlockWords& block, const ModalState& state, std::uint32_t line,
                           SaidOnce& said, diagnostics::DiagnosticList& diagnostics);

}  // namespace kerf::parser
