// Files that are no part programs at all.
#pragma once

#include <string_view>

#include "diagnostics/fault.hpp"

namespace kerf::parser {

// Told by the first line: UTF-16, binary data, a web page, another control's language. Without a
// page: nothing is wrong.
diagnostics::Fault explain_first_line(std::string_view line);

}  // namespace kerf::parser
