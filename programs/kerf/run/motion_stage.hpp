// What a dry run and a run by the clock have in common: the ticks' way, and the end.
#pragma once

#include <functional>
#include <string>

#include <kerf/kernel.hpp>

#include "programs/kerf/io/progress.hpp"
#include "programs/kerf/io/progress_bar.hpp"
#include "programs/kerf/io/text_feed.hpp"
#include "programs/kerf/report/report.hpp"
#include "programs/kerf/run/feeder.hpp"
#include "programs/kerf/run/motion_run.hpp"
#include "programs/kerf/run/output_files.hpp"
#include "programs/kerf/run/run_loop.hpp"
#include "programs/kerf/run/tick_stage.hpp"

namespace kerf::program {

// Refers to all that it is given.
class MotionStage {
 public:
  struct Ends {
    TextFeed& text;
    OutputFiles& outputs;
    FileReport& report;
  };
  // The machine is enabled where the program begins.
  MotionStage(const MotionOrder& order, const Ends& ends, machine::Machine& machine)
      : order_(order),
        text_(ends.text),
        outputs_(ends.outputs),
        report_(ends.report),
        progress_(order.path.length_mm),
        ticks_({.settings = order.settings,
                .tool_change = tool_change_in(order),
                .spindle_timeout_s = order.options.driver.spindle_timeout_s,
                .keeps_flight = order.options.flight_file.has_value()},
               machine) {
    ticks_.enable({.mm = order.kernel_options.start_mm,
                   .extra_rad_mm = order.kernel_options.start_extra_rad_mm});
    if (order.options.command != Subcommand::run) {
      outputs_.recorder().parts.emplace(order.path.headings, tool_change_in(order));
    }
  }

  [[nodiscard]] const MotionOrder& order() const noexcept { return order_; }
  [[nodiscard]] FileReport& report() noexcept { return report_; }

  [[nodiscard]] TextFeed& text() noexcept { return text_; }
  [[nodiscard]] Progress& progress() noexcept { return progress_; }
  [[nodiscard]] Feeder feeder(PlanningSide& planning) { return {planning, text_, progress_}; }
  [[nodiscard]] ProgressBar progress_bar(std::function<std::string()> label,
                                         ProgressBar::Left left) const {
    return {std::move(label), [this] { return progress_.share(); }, order_.shows_progress, left};
  }
  [[nodiscard]] RunStage stage_with(Feeder& feeder);
  void disable() noexcept { ticks_.disable(); }
  // Of the machine, as of the latest tick or before the first.
  [[nodiscard]] const machine::MachineInputs& inputs() const noexcept { return ticks_.inputs(); }

  // Fills in the report and ends the files.
  struct End {
    const Kernel& kernel;
    const Feeder& feeder;
    const RunOutcome& outcome;
    bool is_stopped = false;  // by an operator
    std::string no_home{};    // why the search for it failed
    bool is_unhomed = false;  // an axis with a home switch is
    bool is_emergency = false;
  };
  void finish(const End& end);

 private:
  [[nodiscard]] static ToolChange tool_change_in(const MotionOrder& order) noexcept {
    const bool waits = order.options.command == Subcommand::run || order.plan != nullptr;
    const bool takes_time =
        waits || order.settings.program.tool_change_s >= order.settings.limits.period_s;
    return takes_time ? ToolChange::takes_time : ToolChange::takes_none;
  }
  void report_end(const End& end);
  void report_program(const End& end);
  void write_flight();

  const MotionOrder& order_;
  TextFeed& text_;
  OutputFiles& outputs_;
  FileReport& report_;
  Progress progress_;
  TickStage ticks_;
};

}  // namespace kerf::program
