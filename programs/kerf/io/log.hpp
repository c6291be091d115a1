// Messages for people, on standard error or in a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "programs/kerf/options.hpp"

namespace kerf::program {

struct LogSettings {
  bool quiet = false;  // errors alone on standard error
  LogLevel level = LogLevel::info;
  std::optional<std::string> file{};  // emptied first; standard error has no debug lines then
};

// "kerf: error: ..." and, unless quiet, "kerf: warning: ..."; in a file with the time before it.
// Off the tick path: a terminal may wait. Error: what the system says, with the file's name; the
// log is as it was then.
tl::expected<void, std::string> open_log(const LogSettings& settings);

// Writes what the log still holds. Error: what the system said of the first line that is lost.
tl::expected<void, std::string> close_log();

// A line of the level debug. Any thread but that of the ticks.
void log_debug(std::string_view line);

// A line as it is, for diagnostics that already have the form that editors understand.
void write_error_line(std::string_view line);

}  // namespace kerf::program
