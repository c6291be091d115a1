// Messages for people, on standard error.
#pragma once

#include <string>
#include <string_view>

namespace kerf::program {

// "kerf: error: ..." and, unless quiet, "kerf: warning: ...". Off the tick path: a terminal may
// wait.
void open_log(bool quiet);

// A line as it is, for diagnostics that already have the form that editors understand.
void write_error_line(std::string_view line);

}  // namespace kerf::program
