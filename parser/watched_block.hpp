// A block and what is in force just before it: what `kerf explain` shows.
#pragma once

#include <string>

#include "parser/modal_state.hpp"

namespace kerf::parser {

struct WatchedBlock {
  std::string text;  // the line as written
  ModalState state{};
};

}  // namespace kerf::parser
