// What a running program can read and write by parameters.
#pragma once

#include <cstddef>
#include <cstdint>

#include "parser/dialects/dialect.hpp"
#include "parser/modal/machine_data.hpp"
#include "parser/modal/machine_source.hpp"
#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

struct ProgramMemory {
  ModalState state{};
  MachineData machine{};
  MachineSource answers{};
  Dialect dialect = Dialect::rs274;
  std::uint32_t line = 0;  // that is being read
  std::size_t open_calls = 0;
};

}  // namespace kerf::parser
