// Something wrong in one line, before it is known which line it is.
#pragma once

#include <cstdint>
#include <string>

#include "parser/errors/error_page.hpp"

namespace kerf::parser {

struct Fault {
  std::uint32_t offset = 0;  // bytes from the start of the line
  std::string message;
  const ErrorPage* page = nullptr;
};

}  // namespace kerf::parser
