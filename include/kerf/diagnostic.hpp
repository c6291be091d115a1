// Errors and warnings about a program or about settings, as values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <kerf/api.hpp>

namespace kerf {
inline namespace v0 {

enum class Severity : std::uint8_t { error, warning };

/// Text too long to be written out.
struct Repeated {
  std::string_view text;  ///< '@' stands for 1, 2, 3 ...
  std::uint32_t times = 0;
};

/// What is known of one cause of an error or a warning.
struct ErrorPage {
  std::uint16_t number = 0;  ///< shown as E0123; never used again for another cause
  Severity severity = Severity::error;
  std::string_view title;      ///< the cause in a few words
  std::string_view meaning;    ///< what the program says and why that cannot be run
  std::string_view remedy;     ///< how to mend it
  std::string_view trigger;    ///< a whole program that has this fault and, as its first, no other
  std::string_view dialect{};  ///< the --dialect that the trigger needs; empty: any
  Repeated more{};             ///< what the trigger goes on with
};

/// A place in the text of a program.
struct SourcePosition {
  std::uint32_t line = 0;    ///< 1-based
  std::uint32_t column = 0;  ///< 1-based, in bytes
  std::uint16_t file =
      0;  ///< 0: the program itself; else a subprogram's, which Diagnostic::file names
  std::uint32_t calling_line = 0;  ///< of a subprogram's file: where the program calls it

  /// The line of the program itself that the place belongs to.
  [[nodiscard]] std::uint32_t program_line() const noexcept {
    return file == 0 ? line : calling_line;
  }
};

/// A line of the program, or a part of it, in a form that can be shown.
struct Excerpt {
  std::string text;              ///< valid UTF-8, without tabs and control characters
  std::uint32_t caret = 0;       ///< columns before the place, as a terminal shows the text
  std::uint32_t characters = 0;  ///< of the whole line before the place
};

/// The page is one of docs/errors.md.
struct Diagnostic {
  Diagnostic(SourcePosition where, const ErrorPage& why, std::string what)
      : severity(why.severity), source(where), message(std::move(what)), page(&why) {}

  Severity severity;
  SourcePosition source;
  std::string message;    ///< what was found and what is allowed
  const ErrorPage* page;  ///< never null; lives as long as the program
  Excerpt block;          ///< of the line; no text where the line is no longer known
  std::string file;       ///< of the subprogram it is about; empty: the program itself
};

/// "E0123"
KERF_API std::string identifier(const ErrorPage& page);

/// "file:line:column: error: message [E0123]", the form that editors understand. `file` is the
/// program's.
KERF_API std::string to_string(const Diagnostic& diagnostic, std::string_view file);

/// The same with the block below it and a caret under the place.
KERF_API std::string to_text(const Diagnostic& diagnostic, std::string_view file);

}  // namespace v0
}  // namespace kerf
