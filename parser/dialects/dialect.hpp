// Which control's language a program is written in.
#pragma once

#include <cstdint>

namespace kerf::parser {

enum class Dialect : std::uint8_t {
  rs274,  // RS274/NGC as LinuxCNC reads it
  fanuc,  // program numbers, custom macro B, Fanuc's meaning of shared codes
};

}  // namespace kerf::parser
