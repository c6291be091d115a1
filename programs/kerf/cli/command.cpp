#include "programs/kerf/cli/command.hpp"

#include <cerrno>
#include <exception>
#include <initializer_list>
#include <string>
#include <string_view>
#include <unistd.h>
#include <variant>
#include <vector>

#include <spdlog/spdlog.h>

#include "programs/kerf/cli/machine_choice.hpp"
#include "programs/kerf/cli/option_parser.hpp"
#include "programs/kerf/io/descriptor.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/log.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/report/diagnostic_document.hpp"
#include "programs/kerf/report/json_report.hpp"
#include "programs/kerf/report/summary.hpp"
#include "programs/kerf/run/session.hpp"

namespace kerf::program {

namespace {

// A reader that has seen enough of standard output is no error; a full disk behind it is one.
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
    // The summary has them, too.
    if (options.json || !report.plan) {
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
  // Where the trace goes to standard output, nothing else does; a document stands alone, too.
  const bool traced = options.trace_file == "-";
  if (options.quiet || report.trace_reader_gone ||
      (!text && (traced || options.command == Command::check))) {
    return ExitStatus::done;
  }
  return print(traced ? STDERR_FILENO : STDOUT_FILENO, summary(report));
}

// All diagnostics of all files, as one document.
ExitStatus print_document(const std::vector<FileReport>& reports, const Options& options) {
  if (options.format == DiagnosticFormat::text) {
    return ExitStatus::done;
  }
  return print(options.command == Command::check ? STDOUT_FILENO : STDERR_FILENO,
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

ExitStatus refuse_machine(const MachineRefusal& refusal, const Options& options) {
  if (options.format == DiagnosticFormat::text) {
    for (const std::string& message : refusal.messages) {
      write_error_line(visible(message));
    }
    return refusal.status;
  }
  FileReport report;
  report.file = options.files.front();
  report.status = refusal.status;
  report.failures = refusal.messages;
  print_document({report}, options);
  return refusal.status;
}

ExitStatus process_all(const Options& options) {
  const auto settings =
      choose_machine({.machine = options.machine_file, .tools = options.tool_file});
  if (!settings) {
    return refuse_machine(settings.error(), options);
  }
  ExitStatus status = ExitStatus::done;
  std::vector<FileReport> reports;
  for (const std::string& path : options.files) {
    reports.push_back(process_file(path, options, *settings));
    const ExitStatus ended = reports.back().status;
    status = first_failure({status, ended, print_report(reports.back(), options)});
    if (const auto requested = stop_requested()) {
      status = first_failure({ended, *requested});
      break;
    }
  }
  return first_failure({status, print_document(reports, options)});
}

}  // namespace

int run_command(int argc, char** argv) {
  install_signal_handlers();
  open_log(false);
  try {
    const auto parsed = parse_options(argc, argv);
    if (const auto* leave = std::get_if<Leave>(&parsed)) {
      const bool asked_for = leave->status == ExitStatus::done;
      const ExitStatus printed = print(asked_for ? STDOUT_FILENO : STDERR_FILENO, leave->text);
      return to_int(asked_for ? printed : leave->status);
    }
    const auto& options = std::get<Options>(parsed);
    open_log(options.quiet);
    return to_int(process_all(options));
  } catch (const std::exception& exception) {
    const ExitStatus status = status_of(exception);
    spdlog::critical(
        "{}: {}",
        status == ExitStatus::io_error ? "the system refuses what is needed" : "internal error",
        visible(exception.what()));
    return to_int(status);
  }
}

}  // namespace kerf::program
