// Foreign text (names of files, words of a program) in a form that is safe on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace kerf::program {

// On one line: control characters, bytes that are not UTF-8, invisible characters and those that
// turn the direction of writing appear as "\x1B", byte by byte. The rest stays as it is.
[[nodiscard]] std::string visible(std::string_view text);

}  // namespace kerf::program
