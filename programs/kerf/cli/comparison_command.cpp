#include "programs/kerf/cli/comparison_command.hpp"

#include <optional>
#include <string>
#include <unistd.h>

#include "programs/kerf/cli/report_output.hpp"
#include "programs/kerf/compare/comparison.hpp"
#include "programs/kerf/compare/comparison_text.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/session.hpp"

namespace kerf::program {

ExitStatus compare(const Options& options, const std::vector<NamedMachine>& machines) {
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

}  // namespace kerf::program
