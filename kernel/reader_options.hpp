// The reader's options, made in one place: the check, the plan and the run must read the same
// program.
#pragma once

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "parser/flow/reader_options.hpp"

namespace kerf {

inline parser::ReaderOptions reader_options(const MachineSettings& settings,
                                            const KernelOptions& options) {
  return {.start_mm = options.start_mm,
          .start_extra_rad_mm = options.start_extra_rad_mm,
          .block_delete = options.block_delete,
          .dialect = options.dialect.value_or(settings.dialect),
          .machine = settings.program,
          .subprograms = options.subprograms,
          .keeps_messages = options.tells_operator};
}

}  // namespace kerf
