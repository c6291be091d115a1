// An error or a warning about the program's text, as a value.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "diagnostics/errors/error_page.hpp"
#include "diagnostics/excerpt.hpp"
#include "diagnostics/source_position.hpp"

namespace kerf::diagnostics {

struct Diagnostic {
  Diagnostic(SourcePosition where, const ErrorPage& why, std::string what)
      : severity(why.severity), source(where), message(std::move(what)), page(&why) {}

  Severity severity;
  SourcePosition source;
  std::string message;    // what was found and what is allowed
  const ErrorPage* page;  // never null
  Excerpt block;          // of the line; no text where the line is known no more
  std::string file;       // of the subprogram it is about; empty: the program itself
};

// "E0123"
std::string identifier(const ErrorPage& page);

// "file:line:column: error: message [E0123]", the form that editors understand. `file` is the
// program's.
std::string to_string(const Diagnostic& diagnostic, std::string_view file);

// The same with the block below it and a caret under the place.
std::string to_text(const Diagnostic& diagnostic, std::string_view file);

}  // namespace kerf::diagnostics
