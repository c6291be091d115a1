// Where a program starts: looked for, shown, and confirmed by somebody.
#pragma once

#include <cstdint>
#include <optional>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "programs/kerf/control/plan_record.hpp"
#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/report/report.hpp"
#include "programs/kerf/run/program_mark.hpp"
#include "programs/kerf/run/run_journal.hpp"

namespace kerf::program {

struct StartOrder {
  const Options& options;
  const MachineSettings& settings;
  const KernelOptions& kernel_options;
  const ProgramMark& mark;
  bool has_keys = false;             // somebody is at the terminal
  const PlanRecord* plan = nullptr;  // of the run that is repeated: confirmed as then
};

// Of one run: its start, where the options name a line or a journal to go on from, and its journal.
class RunStart {
 public:
  // Shows on standard error what is in force where the program is to start in its middle. A run is
  // confirmed at the terminal, by Options::is_confirmed or, over the control channel, as the
  // program waits before it leaves its place. False: it is not to run, and the report says why.
  // Precondition: check_program() found no error.
  bool choose(const StartOrder& order, ProgramFile& file, FileReport& report);

  // Nothing: the program's begin.
  [[nodiscard]] const std::optional<StartInProgram>& place() const noexcept { return place_; }
  // The run is over.
  void end(FileReport& report) {
    if (journal_) {
      journal_->end(report);
    }
  }

  // Null: none is kept.
  [[nodiscard]] JournalWriter* journal() noexcept {
    return journal_ ? journal_->writer() : nullptr;
  }

 private:
  std::optional<StartInProgram> place_;
  std::optional<RunJournal> journal_;
};

}  // namespace kerf::program
