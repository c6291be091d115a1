#include "programs/session.hpp"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <optional>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/block_lookup.hpp"
#include "programs/check_pass.hpp"
#include "programs/interrupt.hpp"
#include "programs/motion_report.hpp"
#include "programs/number_text.hpp"
#include "programs/outputs.hpp"
#include "programs/plan_only.hpp"
#include "programs/progress_bar.hpp"
#include "programs/run_loop.hpp"
#include "programs/subprogram_folder.hpp"
#include "programs/text_feed.hpp"

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

class Session {
 public:
  Session(const Options& options, const MachineSettings& settings)
      : options_(options),
        settings_(settings),
        kernel_options_{.profile = profiles::Profile(options.profile, options.sigmoid_shape),
                        .window_blocks = options.window_blocks,
                        .block_delete = options.block_delete,
                        .dialect = options.dialect} {
    report_.command = options.command;
    report_.machine = options.machine_file.value_or("default");
    report_.profile = name_of(options.profile);
    report_.period_s = settings.limits.period_s;
    report_.limits = settings.limits;
    report_.extra_axes = settings.program.extra_axes;
    report_.speed_question = options.explained_speed.value_or(SpeedQuestion{});
  }

  FileReport process(const std::string& path) {
    report_.file = path == "-" ? "<stdin>" : path;
    if (path != "-") {
      kernel_options_.subprograms =
          subprograms_beside(path, options_.dialect.value_or(settings_.dialect));
    }
    if (options_.command == Command::run && ProgramFile::is_live(path)) {
      run_live(path);
      return std::move(report_);
    }
    auto file = ProgramFile::open(path);
    if (stop_requested()) {
      report_.status = *stop_requested();
    } else if (!file) {
      fail(ExitStatus::io_error, file.error());
    } else if (check(*file)) {
      file->rewind();
      const Stopwatch watch;
      if (options_.command == Command::check || options_.command == Command::explain) {
        plan(*file);
      } else {
        FileFeed text(*file);
        run(text);
      }
      report_.run_duration_s = watch.elapsed_s();
    }
    return std::move(report_);
  }

 private:
  void fail(ExitStatus status, std::string message) {
    if (report_.status == ExitStatus::done) {
      report_.status = status;
    }
    report_.failures.push_back(std::move(message));
  }

  [[nodiscard]] bool shows_progress() const {
    return !options_.quiet && options_.format == DiagnosticFormat::text &&
           ProgressBar::has_terminal();
  }

  // True: the program may run.
  bool check(ProgramFile& file) {
    const Stopwatch watch;
    const auto found = check_pass(file, settings_, kernel_options_, shows_progress());
    report_.check_duration_s = watch.elapsed_s();
    if (stop_requested()) {
      report_.status = *stop_requested();
    } else if (!found) {
      fail(ExitStatus::io_error, found.error());
    } else {
      judge(*found);
      fill_in_blocks(report_.diagnostics, file);
    }
    return report_.status == ExitStatus::done;
  }

  void take(const std::vector<parser::Diagnostic>& diagnostics) {
    report_.diagnostics.insert(report_.diagnostics.end(), diagnostics.begin(), diagnostics.end());
  }

  void judge(const CheckReport& found) {
    take(found.diagnostics);
    if (found.has_errors()) {
      report_.status = ExitStatus::program_error;
    } else if (!found.limit_faults.empty()) {
      take(found.limit_faults);
      report_.status = ExitStatus::machine_fault;
    }
    extents_ = found.moves ? std::optional(found.extents) : std::nullopt;
    extra_extents_ = found.extra_extents;
  }

  void plan(ProgramFile& file) {
    Progress progress;
    const ProgressBar bar(
        "planning", [&] { return progress.read_share(); }, shows_progress());
    BlockWatch watch({.line = options_.explained_line, .period_s = report_.period_s});
    const auto planned = plan_only(file, settings_, kernel_options_, progress, watch);
    if (!planned) {
      fail(ExitStatus::io_error, planned.error());
    } else if (stop_requested()) {
      report_.status = *stop_requested();
    } else {
      const lookahead::PlanTotals& totals = planned->totals;
      report_.plan =
          PlanReport{.cycle_time_s = static_cast<double>(totals.ticks) * report_.period_s,
                     .ticks = totals.ticks,
                     .path_length_mm = totals.path_length_mm,
                     .blocks = totals.blocks,
                     .extents = extents_.value_or(curves::Extents{}),
                     .extra_extents = extra_extents_,
                     .deviation = planned->departure};
      report_.warnings = describe(totals.shortfalls);
      explain(watch);
    }
  }

  void explain(const BlockWatch& watch) {
    if (options_.command != Command::explain) {
      return;
    }
    if (!watch.block()) {
      fail(ExitStatus::program_error,
           fmt::format("{}: line {} is never run", report_.file, options_.explained_line));
      return;
    }
    report_.block = BlockReport{.line = options_.explained_line,
                                .block = *watch.block(),
                                .begin_s = watch.begin_s().value_or(report_.plan->cycle_time_s),
                                .duration_s = watch.duration_s()};
  }

  // Text that can be read only once runs as it comes: each block is checked before it is planned,
  // and a wrong one ends the program at rest before it.
  void run_live(const std::string& path) {
    Descriptor source(path == "-" ? ::dup(STDIN_FILENO)
                                  : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!source.is_open()) {
      fail(ExitStatus::io_error, report_.file + ": " + error_text(errno));
      return;
    }
    report_.live = kernel_options_.checks_travel = true;
    const Stopwatch watch;
    LiveFeed text(report_.file, std::move(source));
    run(text);
    report_.run_duration_s = watch.elapsed_s();
  }

  void run(TextFeed& text) {
    auto outputs = Outputs::open(options_, settings_, extents_.value_or(curves::Extents{}));
    if (!outputs) {
      fail(ExitStatus::io_error, outputs.error());
      return;
    }
    Kernel kernel(settings_, kernel_options_);
    Progress progress;
    Feeder feeder(kernel, text, progress);
    TickStage ticks(kernel, settings_, kernel_options_.start_mm);
    const RunStage stage{feeder, ticks, outputs->recorder(), progress, report_.live};
    RunOutcome outcome;
    {
      const ProgressBar bar(
          "running ", [&] { return progress.share(); }, shows_progress());
      outcome = options_.command == Command::run ? run_in_real_time(stage, report_.period_s)
                                                 : run_without_clock(stage);
    }
    report_motion(report_, kernel, ticks.statistics(), outcome);
    if (const auto& speed = outputs->recorder().speed) {
      report_.speed = speed->report();
    }
    note_end(kernel, ticks.fault(), feeder.error(), outcome);
    for (const auto& error :
         {outputs->close_trace(outcome.dropped_records), outputs->write_plot(plot_caption())}) {
      if (error) {
        fail(ExitStatus::io_error, *error);
      }
    }
  }

  // Why the run is over, the gravest reason first.
  void note_end(const Kernel& kernel, const MachineFault& fault,
                const std::optional<std::string>& read_error, const RunOutcome& outcome) {
    if (outcome.hung) {
      fail(ExitStatus::internal_error,
           "internal error: the program is read and nothing is planned");
    } else if (fault.kind != machine::Fault::none) {
      fail(ExitStatus::machine_fault, describe(fault, report_.period_s));
    } else if (stop_requested()) {
      report_.status = *stop_requested();
    } else if (read_error) {
      fail(ExitStatus::io_error, *read_error);
    } else if (kernel.has_errors()) {
      take(kernel.diagnostics());
      report_.status = kernel.left_travel() ? ExitStatus::machine_fault : ExitStatus::program_error;
    } else if (report_.live) {
      take(kernel.diagnostics());
    } else if (extents_) {
      report_.plan->extra_extents = extra_extents_;
      report_.plan->extents = *extents_;  // of the curves; ticks need not meet their extremes
    }
  }

  [[nodiscard]] PlotCaption plot_caption() const {
    const PlanReport& plan = *report_.plan;
    return {.title = report_.file,
            .subtitle =
                fmt::format("{} \u00b7 {:.1f} mm in {} \u00b7 {}", clock_time(plan.cycle_time_s),
                            plan.path_length_mm, counted(plan.blocks, "block"), report_.profile),
            .period_s = report_.period_s,
            .limits = report_.limits.path,
            .deviation = plan.deviates() ? std::optional(plan.deviation) : std::nullopt};
  }

  const Options& options_;
  const MachineSettings& settings_;
  KernelOptions kernel_options_;
  FileReport report_;
  std::optional<curves::Extents> extents_;  // of the whole path, if there is one
  curves::ExtraExtents extra_extents_{};
};

}  // namespace

FileReport process_file(const std::string& path, const Options& options,
                        const MachineSettings& settings) {
  return Session(options, settings).process(path);
}

}  // namespace kerf::program
