#include "programs/kerf/run/session.hpp"

#include <chrono>
#include <utility>
#include <variant>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/driver/machine_record.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/keyboard.hpp"
#include "programs/kerf/io/log.hpp"
#include "programs/kerf/io/machine_lock.hpp"
#include "programs/kerf/io/progress_bar.hpp"
#include "programs/kerf/io/subprogram_folder.hpp"
#include "programs/kerf/io/text_feed.hpp"
#include "programs/kerf/run/block_lookup.hpp"
#include "programs/kerf/run/first_places.hpp"
#include "programs/kerf/run/first_scan.hpp"
#include "programs/kerf/run/motion_run.hpp"
#include "programs/kerf/run/plan_run.hpp"
#include "programs/kerf/run/program_check.hpp"
#include "programs/kerf/run/program_headings.hpp"
#include "programs/kerf/run/program_mark.hpp"
#include "programs/kerf/run/start_choice.hpp"

namespace kerf::program {

namespace {

class Stopwatch {
 public:
  [[nodiscard]] double elapsed_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Only the simulated table has the one of the machine file, and a record of a run on it.
bool knows_workpiece(const Options& options, const MachineSettings& settings) {
  return options.replay_file.empty() ? options.driver.name == "simulated"
                                     : settings.simulation.surface.has_value();
}

class Session {
 public:
  Session(const Options& options, const MachineSettings& settings, PageRecord* page)
      : options_(options),
        settings_(settings),
        page_(page),
        shows_progress_(!options.quiet && options.format == DiagnosticFormat::text &&
                        ProgressBar::has_terminal()),
        kernel_options_{.profile = profiles::Profile(options.profile, options.sigmoid_shape),
                        .window_blocks = options.window_blocks,
                        .block_delete = options.block_delete,
                        .optional_stop = options.optional_stop,
                        .asks_machine = true,
                        .one_thread = options.command != Subcommand::run,
                        .tells_operator = page != nullptr && page->wants_motion,
                        .dialect = options.dialect} {
    const bool has_machine = options.command == Subcommand::run || !options.replay_file.empty();
    if (has_machine && !knows_workpiece(options, settings)) {
      kernel_options_.assumes_contact = kernel_options_.checks_travel = true;
    }
    if (options.log_level == LogLevel::debug) {
      kernel_options_.plan_log = log_debug;
    }
    report_.command = options.command;
    report_.syntax_only = options.syntax_only;
    report_.machine = options.machine_file.value_or("default");
    report_.driver = options.driver.name;
    report_.profile = name_of(options.profile);
    report_.feed_override = options.feed_override;
    report_.period_s = settings.limits.period_s;
    report_.limits = settings.limits;
    report_.extra_axes = settings.program.extra_axes;
    report_.feed_unit = options.feed_unit.value_or(FeedUnit::mm_min);
    report_.speed_question = options.explained_speed.value_or(SpeedQuestion{});
  }

  FileReport process(const std::string& path) {
    report_.file = path == "-" ? "<stdin>" : path;
    if (path != "-") {
      kernel_options_.subprograms =
          mark_.noting(subprograms_beside(path, options_.dialect.value_or(settings_.dialect)));
    }
    if (!read_plan_record()) {
      return std::move(report_);
    }
    if (options_.command != Subcommand::run || !begin_run(path)) {
      check_and_run(path);
    }
    return std::move(report_);
  }

 private:
  // Of the run that is repeated. False: it cannot be, with these options.
  bool read_plan_record() {
    if (options_.replay_file.empty()) {
      return true;
    }
    plan_ = PlanRecord::from_bytes(RecordReader::plan_record_in(options_.replay_file));
    if (plan_ && options_.control) {
      report_.fail(ExitStatus::wrong_use,
                   options_.replay_file + ": the record has commands: it goes without --control");
      return false;
    }
    kernel_options_.one_thread = kernel_options_.one_thread && !plan_;
    return true;
  }

  // True: it is over. Another run has the machine, or the text came as it ran.
  bool begin_run(const std::string& path) {
    if (!lock()) {
      return true;
    }
    Descriptor source = ProgramFile::open_live(path);
    has_keys_ = !source.is_open() && !plan_ && Keyboard::has_terminal();
    kernel_options_.refuses_waits =
        !has_keys_ && !options_.control && !(plan_ && plan_->is_attended);
    if (options_.waits_for_start && kernel_options_.refuses_waits) {
      report_.fail(
          ExitStatus::wrong_use,
          "--wait-start needs a terminal or --control: nobody else could start the program");
      return true;
    }
    if (source.is_open() && std::holds_alternative<AtFirstMove>(options_.start)) {
      report_.fail(ExitStatus::wrong_use, "--start first-move needs a FILE that can be read twice");
      return true;
    }
    if (source.is_open() && (options_.from_line || !options_.journal_file.empty())) {
      report_.fail(ExitStatus::wrong_use,
                   path + ": --from-line, --journal and --continue take a FILE that is read twice");
      return true;
    }
    if (source.is_open()) {
      run_live(std::move(source));
      return true;
    }
    return false;
  }

  // Text that can be read twice.
  void check_and_run(const std::string& path) {
    auto file = ProgramFile::open(path);
    if (stop_requested()) {
      report_.status = *stop_requested();
    } else if (!file) {
      report_.fail(ExitStatus::io_error, file.error());
    } else if (choose_start(*file) && check(*file) && !options_.syntax_only) {
      file->rewind();
      const Stopwatch watch;
      if (options_.command == Subcommand::check || options_.command == Subcommand::explain) {
        plan(*file);
      } else {
        move(*file);
      }
      if (options_.command != Subcommand::run && report_.status == ExitStatus::program_error) {
        // Up to where it was cut off it has no figures of its own.
        report_.plan.reset();
        report_.motion.reset();
        report_.speed.reset();
        fill_in_blocks(report_.diagnostics, *file);
      }
      report_.run_duration_s = watch.elapsed_s();
    }
  }

  // False: the program says no place where it starts.
  bool choose_start(ProgramFile& file) {
    const auto* given = std::get_if<Position>(&options_.start);
    const tl::expected<Position, std::string> place =
        given != nullptr ? *given : first_places(file, settings_, kernel_options_);
    if (!place) {
      report_.fail(ExitStatus::program_error, place.error());
      return false;
    }
    kernel_options_.start_mm = *place;
    return true;
  }

  // False: another run has the machine.
  bool lock() {
    if (!options_.machine_file) {
      return true;
    }
    auto held = lock_machine(*options_.machine_file);
    if (!held) {
      report_.fail(ExitStatus::io_error, held.error());
      return false;
    }
    machine_lock_ = *std::move(held);
    return true;
  }

  // True: the program may run.
  bool check(ProgramFile& file) {
    const Stopwatch watch;
    const bool may_run = check_program({.options = options_,
                                        .settings = settings_,
                                        .kernel_options = kernel_options_,
                                        .path = path_,
                                        .shows_progress = shows_progress_,
                                        .page = page_},
                                       file, report_);
    report_.check_duration_s = watch.elapsed_s();
    return may_run;
  }

  void plan(ProgramFile& file) {
    run_plan({.options = options_,
              .settings = settings_,
              .kernel_options = kernel_options_,
              .path = path_,
              .shows_progress = shows_progress_},
             file, report_);
  }

  void move(ProgramFile& file) {
    if (!start_.choose({.options = options_,
                        .settings = settings_,
                        .kernel_options = kernel_options_,
                        .mark = mark_,
                        .has_keys = has_keys_,
                        .plan = plan_ ? &*plan_ : nullptr},
                       file, report_)) {
      return;
    }
    if (start_.place()) {
      kernel_options_.start_in_program = start_.place();
      kernel_options_.nominal.reset();  // that and the length are of the whole program
      path_.length_mm = 0.0;
    }
    file.rewind();
    if (options_.command != Subcommand::run) {
      path_.headings = headings_in(file);
      if (path_.headings.size() == kMaxHeadings) {
        report_.warnings.push_back(fmt::format(
            "more than {} comments are headings: what follows counts as the last operation",
            kMaxHeadings - 1));
      }
      file.rewind();
    }
    if (options_.plot_file) {
      path_.scan = first_scan(file, settings_, kernel_options_);
      file.rewind();
    }
    FileFeed text(file);
    run(text);
    start_.end(report_);
  }

  // Text that can be read only once runs as it comes: each block is checked before it is planned,
  // and a wrong one ends the program at rest before it.
  void run_live(Descriptor source) {
    kernel_options_.start_mm = std::get<Position>(options_.start);
    report_.live = kernel_options_.checks_travel = true;
    const Stopwatch watch;
    LiveFeed text(report_.file, std::move(source));
    run(text);
    report_.run_duration_s = watch.elapsed_s();
  }

  void run(TextFeed& text) {
    run_motion({.options = options_,
                .settings = settings_,
                .kernel_options = kernel_options_,
                .path = path_,
                .shows_progress = shows_progress_,
                .has_keys = has_keys_,
                .page = page_,
                .journal = start_.journal(),
                .plan = plan_ ? &*plan_ : nullptr},
               text, report_);
  }

  const Options& options_;
  const MachineSettings& settings_;
  PageRecord* page_;
  bool shows_progress_;
  bool has_keys_ = false;
  std::optional<PlanRecord> plan_{};  // of a run under commands that is repeated
  MachineLock machine_lock_;          // of a run
  ProgramMark mark_;
  RunStart start_;
  KernelOptions kernel_options_;
  FileReport report_;
  CheckedPath path_;
};

}  // namespace

FileReport process_file(const std::string& path, const Options& options,
                        const MachineSettings& settings, PageRecord* page) {
  return Session(options, settings, page).process(path);
}

}  // namespace kerf::program
