// What a command says about its programs.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "programs/kerf/exit_status.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// A reader that has seen enough of standard output is no error; a full disk after it is one.
ExitStatus print(int descriptor, std::string_view text);

// On standard error.
void print_messages(const FileReport& report, const Options& options);

// The messages, and the summary or its JSON.
ExitStatus print_report(const FileReport& report, const Options& options);

// All diagnostics of all files as one document, if the options ask for one.
ExitStatus print_document(const std::vector<FileReport>& reports, const Options& options);

[[nodiscard]] ExitStatus first_failure(std::initializer_list<ExitStatus> parts);

}  // namespace kerf::program
