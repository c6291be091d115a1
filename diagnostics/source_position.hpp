// A place in the text of a program.
#pragma once

#include <cstdint>

namespace kerf::diagnostics {

struct SourcePosition {
  std::uint32_t line = 0;    // 1-based
  std::uint32_t column = 0;  // 1-based, in bytes
  std::uint16_t file = 0;    // 0: the program itself; else ProgramReader::file_name() has it
};

}  // namespace kerf::diagnostics
