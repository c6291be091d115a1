#include "programs/kerf/run/run_journal.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

namespace kerf::program {

namespace {

bool has_bytes(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return !error && size > 0;
}

}  // namespace

std::optional<RunJournal> RunJournal::prepare(
    const Options& options, const tl::expected<std::uint64_t, std::string>& program,
    FileReport& report) {
  if (!program) {
    report.fail(ExitStatus::io_error, program.error());
    return std::nullopt;
  }
  RunJournal journal(
      options.journal_file,
      {.file = report.file, .program = *program, .machine = options.machine_checksum});
  auto before = read_journal_file(options.journal_file);
  if (!options.continues) {
    if (!before && has_bytes(options.journal_file)) {
      report.fail(ExitStatus::io_error, before.error() + "; it is not written over");
      return std::nullopt;
    }
    if (before && !before->exit_status) {
      report.warnings.push_back("the last run in " + options.journal_file +
                                " was not brought to an end, and is forgotten now");
    }
    return journal;
  }
  if (!before) {
    report.fail(ExitStatus::io_error, before.error());
  } else if (before->exit_status == to_int(ExitStatus::done)) {
    report.fail(ExitStatus::program_error,
                options.journal_file + ": the run has come to its end, there is nothing to go on");
  } else if (before->run.program != *program) {
    report.fail(ExitStatus::program_error,
                report.file + " is not the program of " + options.journal_file +
                    ": it, a subprogram, how they are read or --start was changed since");
  } else if (before->run.machine != options.machine_checksum) {
    report.fail(ExitStatus::settings_error,
                "the machine is not that of " + options.journal_file +
                    ": the machine file, its tool table or height map, or --g54 was changed since");
  } else if (!before->change.empty()) {
    report.fail(ExitStatus::program_error,
                "in the run of " + options.journal_file + " " + before->change +
                    ": what that led to is not known any more; --from-line starts nevertheless");
  } else {
    journal.before_ = *std::move(before);
    return journal;
  }
  return std::nullopt;
}

bool RunJournal::begin(const std::optional<StartInProgram>& start, FileReport& report) {
  run_.blocks_before = start ? start->blocks_before : 0;
  auto opened = JournalWriter::open(path_, run_, before_ ? before_->valid_bytes : 0);
  if (!opened) {
    report.fail(ExitStatus::io_error, opened.error());
    return false;
  }
  writer_.emplace(*std::move(opened));
  return true;
}

void RunJournal::end(FileReport& report) {
  if (const int error = writer_->end(report.status)) {
    report.warnings.push_back("the journal " + path_ + " is not whole: " + error_text(error));
  }
}

}  // namespace kerf::program
