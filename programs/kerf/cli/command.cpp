#include "programs/kerf/cli/command.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

#include <spdlog/spdlog.h>

#include "programs/kerf/cli/machine_choice.hpp"
#include "programs/kerf/cli/option_parser.hpp"
#include "programs/kerf/cli/page_maker.hpp"
#include "programs/kerf/cli/report_output.hpp"
#include "programs/kerf/cli/written_files.hpp"
#include "programs/kerf/compare/comparison.hpp"
#include "programs/kerf/compare/comparison_text.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/log.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/run/session.hpp"
#include "programs/kerf/run/tick_cost.hpp"

namespace kerf::program {

namespace {

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

// Every program on every machine.
class AllPrograms {
 public:
  explicit AllPrograms(const Options& options) : options_(options) {}

  ExitStatus process(const std::vector<NamedMachine>& machines) {
    if (makes_page(options_.command)) {
      auto opened = PageMaker::open(options_);
      if (!opened) {
        spdlog::error("{}", visible(opened.error()));
        return ExitStatus::io_error;
      }
      page_.emplace(*std::move(opened));
    }
    for (const std::string& path : options_.files) {
      for (const NamedMachine& machine : machines) {
        if (!stop_requested()) {
          process(path, machine);
        }
      }
    }
    return first_failure(
        {status_, page_ ? page_->finish() : ExitStatus::done, print_document(reports_, options_)});
  }

 private:
  void process(const std::string& path, const NamedMachine& machine) {
    const Options options = options_on(machine, options_);
    const MachineSettings& settings = machine.chosen.settings;
    PageRecord record{.wants_source = !options.leaves_out_source,
                      .quotes_text = !options.leaves_out_source};
    reports_.push_back(process_file(path, options, settings, page_ ? &record : nullptr));
    const FileReport& report = reports_.back();
    status_ = first_failure({status_, report.status, print_report(report, options)});
    if (page_) {
      page_->add(report, settings, record);
    }
    if (const auto requested = stop_requested()) {
      status_ = first_failure({report.status, *requested});
    }
  }

  const Options& options_;
  std::optional<PageMaker> page_;
  std::vector<FileReport> reports_;
  ExitStatus status_ = ExitStatus::done;
};

ExitStatus show_tick_cost(const Options& options, const MachineSettings& settings) {
  const auto cost =
      measure_tick_cost({.measured_s = options.measured_s, .realtime = options.realtime}, settings);
  if (!cost) {
    spdlog::error("{}", visible(cost.error()));
    return ExitStatus::machine_fault;
  }
  const ExitStatus printed =
      print(STDOUT_FILENO, options.json ? tick_cost_json(*cost) : tick_cost_text(*cost));
  return first_failure({printed, stop_requested().value_or(ExitStatus::done)});
}

// Precondition: two programs or two machines; of what is there once, both take that one.
ExitStatus show_comparison(const Options& options, const std::vector<NamedMachine>& machines) {
  std::vector<FileReport> reports;
  std::vector<std::string> sources;
  for (const std::size_t side : {0U, 1U}) {
    const std::string& file = side < options.files.size() ? options.files[side] : options.files[0];
    const NamedMachine& machine = side < machines.size() ? machines[side] : machines[0];
    PageRecord text{.wants_motion = false};
    reports.push_back(
        process_file(file, options_on(machine, options), machine.chosen.settings, &text));
    sources.push_back(text.source.value_or(""));
    if (const auto requested = stop_requested()) {
      return *requested;
    }
    if (options.format == DiagnosticFormat::text) {
      print_messages(reports.back(), options);
    }
  }
  const ExitStatus status = first_failure({reports[0].status, reports[1].status});
  std::optional<Comparison> comparison;
  if (status == ExitStatus::done) {
    comparison = compare_programs({reports[0], sources[0]}, {reports[1], sources[1]},
                                  options.compared_lines);
  }
  const ComparedReports compared{
      .first = reports[0], .second = reports[1], .comparison = comparison ? &*comparison : nullptr};
  ExitStatus printed = ExitStatus::done;
  if (options.json) {
    printed = print(STDOUT_FILENO, comparison_json(compared, status));
  } else if (!options.quiet) {
    printed = print(STDOUT_FILENO, comparison_text(compared));
  }
  return first_failure({status, printed, print_document(reports, options)});
}

using Machines = tl::expected<std::vector<NamedMachine>, MachineRefusal>;

ExitStatus process_all(const Options& options, const Machines& machines) {
  if (machines && options.command == Subcommand::tick_cost) {
    return show_tick_cost(options, machines->front().chosen.settings);
  }
  if (!machines) {
    return refuse_machine(machines.error(), options);
  }
  return options.command == Subcommand::compare ? show_comparison(options, *machines)
                                                : AllPrograms(options).process(*machines);
}

// Before the first file is opened: what machine files name is read, too.
std::optional<std::string> written_over(const Options& options, const Machines& machines,
                                        std::vector<std::string> named) {
  const auto is_fanuc = [](const NamedMachine& machine) {
    return machine.chosen.settings.dialect == parser::Dialect::fanuc;
  };
  const bool may_be_fanuc = options.dialect
                                ? options.dialect == parser::Dialect::fanuc
                                : machines.has_value() && std::ranges::any_of(*machines, is_fanuc);
  return written_over(options, {.files = std::move(named), .is_fanuc = may_be_fanuc});
}

}  // namespace

int run_command(int argc, char** argv) {
  install_signal_handlers();
  static_cast<void>(open_log({}));  // without a file it cannot fail
  try {
    const auto parsed = parse_options(argc, argv);
    if (const auto* leave = std::get_if<Leave>(&parsed)) {
      const bool asked_for = leave->status == ExitStatus::done;
      const ExitStatus printed = print(asked_for ? STDOUT_FILENO : STDERR_FILENO, leave->text);
      return to_int(asked_for ? printed : leave->status);
    }
    const auto& options = std::get<Options>(parsed);
    std::vector<std::string> named;
    const Machines machines = choose_machines(options, named);
    if (const auto message = written_over(options, machines, std::move(named))) {
      write_error_line("kerf: " + visible(*message));
      return to_int(ExitStatus::wrong_use);
    }
    if (const auto opened = open_log(
            {.quiet = options.quiet, .level = options.log_level, .file = options.log_file});
        !opened) {
      spdlog::error("{}", visible(opened.error()));
      return to_int(ExitStatus::io_error);
    }
    const ExitStatus status = process_all(options, machines);
    const auto logged = close_log();
    if (!logged) {
      spdlog::error("{}", visible(logged.error()));
    }
    return to_int(first_failure({status, logged ? ExitStatus::done : ExitStatus::io_error}));
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
