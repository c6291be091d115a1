// Something wrong in one line, before it is known which line it is.
#pragma once

#include <cstdint>
#include <string>

namespace kerf::parser {

struct Fault {
  std::uint32_t offset = 0;  // bytes from the start of the line
  std::string message;
};

}  // namespace kerf::parser
