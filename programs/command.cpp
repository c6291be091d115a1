#include "programs/command.hpp"

#include <cerrno>
#include <exception>
#include <string>
#include <string_view>
#include <unistd.h>
#include <variant>

#include <spdlog/spdlog.h>

#include "programs/descriptor.hpp"
#include "programs/interrupt.hpp"
#include "programs/json_report.hpp"
#include "programs/log.hpp"
#include "programs/machine_choice.hpp"
#include "programs/options.hpp"
#include "programs/session.hpp"
#include "programs/summary.hpp"

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

void print_messages(const FileReport& report, bool warns) {
  for (const parser::Diagnostic& error : report.errors) {
    write_error_line(parser::to_text(error, report.file));
  }
  for (const std::string& failure : report.failures) {
    spdlog::error("{}", failure);
  }
  for (const std::string& warning : report.warnings) {
    if (warns) {
      spdlog::warn("{}: {}", report.file, warning);
    }
  }
}

ExitStatus print_report(const FileReport& report, const Options& options) {
  // The summary has the warnings, too.
  print_messages(report, options.json || !report.plan);
  if (options.json) {
    return print(STDOUT_FILENO, json_report(report));
  }
  if (options.quiet) {
    return ExitStatus::done;
  }
  // Where the trace goes to standard output, nothing else does.
  return print(options.trace_file == "-" ? STDERR_FILENO : STDOUT_FILENO, summary(report));
}

ExitStatus process_all(const Options& options) {
  const auto settings =
      choose_machine({.machine = options.machine_file, .tools = options.tool_file});
  if (!settings) {
    for (const std::string& message : settings.error().messages) {
      write_error_line(message);
    }
    return settings.error().status;
  }
  ExitStatus status = ExitStatus::done;
  for (const std::string& path : options.files) {
    const FileReport report = process_file(path, options, *settings);
    const ExitStatus printed = print_report(report, options);
    for (const ExitStatus part : {report.status, printed}) {
      status = status == ExitStatus::done ? part : status;
    }
    if (const auto requested = stop_requested()) {
      return report.status == ExitStatus::done ? *requested : report.status;
    }
  }
  return status;
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
    spdlog::critical("internal error: {}", exception.what());
    return to_int(ExitStatus::internal_error);
  }
}

}  // namespace kerf::program
