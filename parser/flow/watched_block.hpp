// A block and what is in force just before it: what `kerf explain` shows.
#pragma once

#include <cstdint>
#include <string>

#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

struct WatchedBlock {
  std::string text;  // the line as written
  ModalState state{};
  std::uint64_t blocks_before = 0;  // Move::block of its own moves and later ones is greater
};

}  // namespace kerf::parser
