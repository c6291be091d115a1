#include "programs/kerf/run/start_choice.hpp"

#include <string>
#include <unistd.h>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/log.hpp"
#include "programs/kerf/report/block_text.hpp"
#include "programs/kerf/run/block_lookup.hpp"
#include "programs/kerf/run/check_pass.hpp"
#include "programs/kerf/run/passed_place.hpp"
#include "programs/kerf/run/start_search.hpp"

namespace kerf::program {

namespace {

std::string safe_lines(const FoundStart& found) {
  if (found.before && found.after) {
    return fmt::format("one can start at {} before it or at {} after it", name_of(*found.before),
                       name_of(*found.after));
  }
  return found.before  ? fmt::format("one can start at {} before it", name_of(*found.before))
         : found.after ? fmt::format("one can start at {} after it", name_of(*found.after))
                       : "there is no other place to start at";
}

// Standard input is a terminal that gives whole lines.
bool says_yes(const std::string& question) {
  write_all(STDERR_FILENO, question + " [y/N] ");
  std::string answer;
  for (char c = 0; answer.size() < 100 && ::read(STDIN_FILENO, &c, 1) == 1 && c != '\n';) {
    answer += c;
  }
  return answer == "y" || answer == "Y" || answer == "yes";
}

constexpr double kOnPath_mm = 1e-3;

// At the line of the options, or the last place before a block of the program's run.
class Choice {
 public:
  Choice(const StartOrder& order, ProgramFile& file, FileReport& report)
      : order_(order), options_(order.kernel_options), file_(file), report_(report) {
    options_.refuses_waits = false;  // of what is left out
  }

  std::optional<StartInProgram> make(const std::optional<Journal>& journal) {
    if (journal && !leads_to(*journal)) {
      return std::nullopt;
    }
    file_.rewind();
    auto found = journal ? find_start_before(file_, search(), journal->block())
                         : find_start(file_, search(), *order_.options.from_line);
    if (found && !found->refused.empty() && order_.options.takes_safe_line && found->before) {
      file_.rewind();
      found = find_start_before(file_, search(), found->before->blocks_before + 1);
    }
    if (stop_requested()) {
      report_.status = *stop_requested();
    } else if (!found) {
      refuse(found.error());
    } else if (!found->refused.empty()) {
      refuse(fmt::format("{} is no place to start at, {}: {}", name_of(found->start.place),
                         found->refused, safe_lines(*found)));
    } else {
      report_.start = std::move(found->start);
      const StartInProgram start{.blocks_before = report_.start->place.blocks_before};
      return waits_for_nobody(start) ? std::nullopt : confirm(start);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] StartSearchOrder search() const {
    return {.settings = order_.settings,
            .options = options_,
            .knows_answers = order_.options.command != Subcommand::run ||
                             order_.options.driver.name == "simulated"};
  }
  // What the machine answered in that run is not in the program, nor a jog before it.
  // At the place where it began the tool is elsewhere anyway.
  bool leads_to(const Journal& journal) {
    const auto& place = journal.on_path;
    if (!place || place->block <= journal.run.blocks_before + 1) {
      return true;
    }
    file_.rewind();
    const auto off_mm =
        distance_from_path_mm(file_, order_.settings, options_,
                              {.block = place->block, .position_mm = place->position_mm});
    if (!off_mm) {
      refuse(off_mm.error());
    } else if (*off_mm > kOnPath_mm && !stop_requested()) {
      refuse(
          fmt::format("the run was at X{:.3f} Y{:.3f} Z{:.3f} in line {}, {:.3f} mm from where "
                      "the program leads by itself: what the machine answered counted, and is not "
                      "known any more",
                      place->position_mm[0], place->position_mm[1], place->position_mm[2],
                      place->line, *off_mm));
    }
    return off_mm && *off_mm <= kOnPath_mm;
  }

  void refuse(const std::string& why) {
    report_.fail(ExitStatus::program_error, report_.file + ": " + why);
  }

  // True: somebody is to answer after the start, and nobody is there; the report says where.
  bool waits_for_nobody(const StartInProgram& start) {
    if (!order_.kernel_options.refuses_waits) {
      return false;
    }
    KernelOptions options = order_.kernel_options;
    options.start_in_program = start;
    file_.rewind();
    auto found = check_pass(file_, order_.settings, options,
                            {.max_time_s = order_.options.max_time_s,
                             .max_moves = order_.options.max_moves,
                             .shows_progress = false,
                             .syntax_only = false,
                             .starts_at_first_places = false});
    if (!found) {
      report_.fail(ExitStatus::io_error, found.error());
      return true;
    }
    if (!found->has_errors()) {
      return false;
    }
    std::erase_if(found->diagnostics, [](const Diagnostic& diagnostic) {
      return diagnostic.severity != Severity::error;  // the others are in the report
    });
    report_.take(found->diagnostics);
    report_.status = ExitStatus::program_error;
    fill_in_blocks(report_.diagnostics, file_);
    return true;
  }

  std::optional<StartInProgram> confirm(StartInProgram start) {
    if (!order_.options.quiet || order_.has_keys) {
      write_error_line(start_text(report_));
    }
    if (order_.plan != nullptr) {
      start.waits = order_.plan->start_waits;
      return start;
    }
    if (order_.options.command != Subcommand::run || order_.options.is_confirmed) {
      return start;
    }
    if (!order_.has_keys && order_.options.control) {
      start.waits = true;
      return start;
    }
    if (!order_.has_keys) {
      report_.fail(ExitStatus::wrong_use,
                   "nobody is there to confirm the start: at a terminal, with --control or with "
                   "--yes it is");
    } else if (says_yes("Start there?")) {
      return start;
    } else {
      report_.status = stop_requested().value_or(ExitStatus::stopped);
    }
    return std::nullopt;
  }

  const StartOrder& order_;
  KernelOptions options_;
  ProgramFile& file_;
  FileReport& report_;
};

}  // namespace

bool RunStart::choose(const StartOrder& order, ProgramFile& file, FileReport& report) {
  std::optional<Journal> before;
  if (!order.options.journal_file.empty()) {
    journal_ =
        RunJournal::prepare(order.options, order.mark.of(file, order.kernel_options), report);
    if (!journal_) {
      return false;
    }
    before = journal_->before();
  }
  if (order.options.from_line || before) {
    place_ = Choice(order, file, report).make(before);
    if (!place_) {
      return false;
    }
  }
  return !journal_ || journal_->begin(place_, report);
}

}  // namespace kerf::program
