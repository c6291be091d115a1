#include "programs/kerf/cli/report_output.hpp"

#include <cerrno>
#include <string>
#include <unistd.h>

#include <spdlog/spdlog.h>

#include "programs/kerf/io/descriptor.hpp"
#include "programs/kerf/io/log.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/report/diagnostic_document.hpp"
#include "programs/kerf/report/json_report.hpp"
#include "programs/kerf/report/summary.hpp"

namespace kerf::program {

ExitStatus print(int descriptor, std::string_view text) {
  const int error = write_all(descriptor, text);
  if (error == 0 || error == EPIPE) {
    return ExitStatus::done;
  }
  spdlog::error("standard output: {}", error_text(error));
  return ExitStatus::io_error;
}

void print_messages(const FileReport& report, const Options& options) {
  for (const diagnostics::Diagnostic& diagnostic : report.diagnostics) {
    if (!options.quiet || diagnostic.severity == diagnostics::Severity::error) {
      diagnostics::Diagnostic shown = diagnostic;
      shown.message = visible(shown.message);
      shown.file = visible(shown.file);
      write_error_line(diagnostics::to_text(shown, visible(report.file)));
    }
  }
  for (const std::string& failure : report.failures) {
    spdlog::error("{}", visible(failure));
  }
  for (const std::string& warning : report.warnings) {
    // A summary has them, too.
    if (options.json || !report.plan || options.command == Subcommand::compare) {
      spdlog::warn("{}: {}", visible(report.file), visible(warning));
    }
  }
}

ExitStatus print_report(const FileReport& report, const Options& options) {
  const bool text = options.format == DiagnosticFormat::text;
  if (text) {
    print_messages(report, options);
  }
  if (options.json) {
    return print(STDOUT_FILENO, json_report(report));
  }
  // Where a trace or picture goes to standard output, nothing else does; a document stands alone,
  // too.
  const bool traced =
      options.trace_file == "-" || options.plot_file == "-" || options.page_file == "-";
  if (options.quiet || report.trace_reader_gone ||
      (!text && (traced || options.command == Subcommand::check))) {
    return ExitStatus::done;
  }
  return print(traced ? STDERR_FILENO : STDOUT_FILENO, summary(report));
}

ExitStatus print_document(const std::vector<FileReport>& reports, const Options& options) {
  if (options.format == DiagnosticFormat::text) {
    return ExitStatus::done;
  }
  return print(options.command == Subcommand::check ? STDOUT_FILENO : STDERR_FILENO,
               options.format == DiagnosticFormat::json ? json_diagnostics(reports)
                                                        : sarif_diagnostics(reports));
}

ExitStatus first_failure(std::initializer_list<ExitStatus> parts) {
  for (const ExitStatus part : parts) {
    if (part != ExitStatus::done) {
      return part;
    }
  }
  return ExitStatus::done;
}

}  // namespace kerf::program
