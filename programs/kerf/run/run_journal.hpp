// The journal that a run keeps, and the one that it goes on from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <kerf/kernel.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/options.hpp"
#include "programs/kerf/report/report.hpp"
#include "programs/kerf/run/journal.hpp"

namespace kerf::program {

// Of Options::journal_file, which is not empty.
class RunJournal {
 public:
  // Reads what is there. program: ProgramMark::of(). Nothing: the run is not to go on from it, as
  // it asks to (Options::continues), and the report says why.
  static std::optional<RunJournal> prepare(const Options& options,
                                           const tl::expected<std::uint64_t, std::string>& program,
                                           FileReport& report);

  // Of the run that goes on; nothing: this run begins anew.
  [[nodiscard]] const std::optional<Journal>& before() const noexcept { return before_; }
  // False: it cannot be written, and the report says so.
  bool begin(const std::optional<StartInProgram>& start, FileReport& report);
  // The run is over. A journal that is not whole is a warning: the motion has been. Precondition:
  // begin().
  void end(FileReport& report);
  // Null before begin().
  [[nodiscard]] JournalWriter* writer() noexcept { return writer_ ? &*writer_ : nullptr; }

 private:
  RunJournal(std::string path, JournalledRun run) : path_(std::move(path)), run_(std::move(run)) {}

  std::string path_;
  JournalledRun run_;
  std::optional<Journal> before_;
  std::optional<JournalWriter> writer_;
};

}  // namespace kerf::program
