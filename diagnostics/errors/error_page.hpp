// What is known of one cause of an error or a warning: its identifier and the words of its page in
// docs/errors.md, which is generated from these.
#pragma once

#include <cstdint>
#include <string_view>

namespace kerf::diagnostics {

enum class Severity : std::uint8_t { error, warning };

// Text too long to be written out.
struct Repeated {
  std::string_view text;  // '@' stands for 1, 2, 3 ...
  std::uint32_t times = 0;
};

struct ErrorPage {
  std::uint16_t number = 0;  // shown as E0123; never used again for another cause
  Severity severity = Severity::error;
  std::string_view title;      // the cause in a few words
  std::string_view meaning;    // what the program says and why that cannot be run
  std::string_view remedy;     // how to mend it
  std::string_view trigger;    // a whole program that has this fault and, as its first, no other
  std::string_view dialect{};  // the --dialect that the trigger needs; empty: any
  Repeated more{};             // what the trigger goes on with
};

}  // namespace kerf::diagnostics

namespace kerf::errors {

using diagnostics::ErrorPage;
using diagnostics::Repeated;
using diagnostics::Severity;

}  // namespace kerf::errors
