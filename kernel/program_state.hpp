// What Kernel::state_left() gives.
#pragma once

#include <kerf/kernel.hpp>

#include "parser/flow/reader_options.hpp"

namespace kerf {
inline namespace v0 {

struct ProgramState::Content {
  parser::ReaderState of_reader{};
};

}  // namespace v0
}  // namespace kerf
