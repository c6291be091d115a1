// What a reader is told about the program and the machine before it begins.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <kerf/program_data.hpp>

#include "parser/dialects/dialect.hpp"
#include "parser/expressions/parameters.hpp"
#include "parser/flow/block_watcher.hpp"
#include "parser/modal/machine_data.hpp"
#include "parser/modal/machine_source.hpp"
#include "parser/modal/modal_state.hpp"
#include "parser/moves/move.hpp"

namespace kerf::parser {

using kerf::BlockDelete;
using kerf::SubprogramSource;
using kerf::SubprogramText;

// What a program leaves to the next one.
struct ReaderState {
  ModalState modal{};
  MachineData machine{};
  Parameters parameters{};
};

struct ReaderOptions {
  Point start_mm{};                        // where the tool is when the program starts
  AuxiliaryPosition start_extra_rad_mm{};  // A, B, C in rad
  BlockDelete block_delete{};              // which blocks that begin with '/' are left out
  std::size_t max_errors = 100;
  Dialect dialect = Dialect::rs274;
  MachineSource answers{};  // what a probe touches, and inputs
  MachineData machine{};    // work offsets, G28, G30 and tools as the program finds them
  // In place of `machine` and of what is in force at a start. Null: none.
  std::shared_ptr<const ReaderState> begins_with{};
  bool one_line = false;           // no M2 is wanted after it
  SubprogramSource subprograms{};  // empty: only those in the program's own text
  // Lines read since the last motion that end the program as an endless loop.
  std::uint64_t max_idle_steps = 10'000'000;
  bool keeps_messages = false;      // for ProgramReader::messages()
  BlockWatcher* watcher = nullptr;  // sees each block; null: nobody does
};

}  // namespace kerf::parser
