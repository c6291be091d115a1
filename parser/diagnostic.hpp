// An error or a warning about the program's text, as a value.
#pragma once

#include <string>
#include <string_view>

#include "parser/errors/error_page.hpp"
#include "parser/move.hpp"

namespace kerf::parser {

struct Diagnostic {
  Severity severity = Severity::error;
  SourcePosition source;
  std::string message;  // what was found and what was expected
  const ErrorPage* page = nullptr;
  std::string file{};  // of the subprogram it is about; empty: the program itself
};

// "file:line:column: error: message", the form that editors understand. `file` is the program's.
std::string to_string(const Diagnostic& diagnostic, std::string_view file);

}  // namespace kerf::parser
