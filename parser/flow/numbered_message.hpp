// What a program told the operator, and before which block.
#pragma once

#include <cstddef>
#include <cstdint>

#include <kerf/program_data.hpp>

namespace kerf::parser {

struct NumberedMessage {
  std::uint64_t block = 0;  // as Move::block
  ProgramMessage message{};
};

// Between two moves; further ones are lost.
inline constexpr std::size_t kMaxMessages = 1000;

}  // namespace kerf::parser
