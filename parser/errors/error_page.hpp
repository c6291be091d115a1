// What is known of one cause of an error or a warning: its identifier and the words of its page in
// docs/errors.md, which is generated from these.
#pragma once

#include <cstdint>
#include <string_view>

namespace kerf::parser {

enum class Severity : std::uint8_t { error, warning };

struct ErrorPage {
  std::uint16_t number = 0;  // shown as E0123; never used again for another cause
  Severity severity = Severity::error;
  std::string_view title;    // the cause in a few words
  std::string_view meaning;  // what the program says and why that cannot be run
  std::string_view remedy;   // how to mend it
  std::string_view trigger;  // a whole program that has this fault and, as its first, no other
};

}  // namespace kerf::parser
