// Text of others (names of files, words of a program) as it may be shown on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace kerf::program {

// On one line: control characters, bytes that are not UTF-8 and what else cannot be seen or turns
// the direction of writing as "\x1B", byte by byte. The rest as it is.
[[nodiscard]] std::string visible(std::string_view text);

}  // namespace kerf::program
