// The motion of one program, from its text to its report.
#pragma once

#include <optional>
#include <vector>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "curves/position.hpp"
#include "programs/kerf/control/plan_record.hpp"
#include "programs/kerf/io/text_feed.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/page/plan_gatherer.hpp"
#include "programs/kerf/plot/scanned_curve.hpp"
#include "programs/kerf/report/report.hpp"
#include "programs/kerf/run/journal.hpp"

namespace kerf::program {

// The path as the check of the whole program found it; empty for text that runs as it comes.
struct CheckedPath {
  std::optional<curves::Extents> extents;    // none: no path
  std::optional<curves::Extents> cutting{};  // none: nothing is cut
  curves::AuxiliaryExtents extra_extents{};
  double length_mm = 0.0;              // of all that is run; 0: nobody knows
  std::optional<ScannedCurve> scan{};  // for the plot
  std::vector<Heading> headings{};     // of a program that runs without a clock
};

struct MotionOrder {
  const Options& options;
  const MachineSettings& settings;
  const KernelOptions& kernel_options;
  CheckedPath path;
  bool shows_progress = false;
  bool has_keys = false;             // somebody is at the terminal
  PageRecord* page = nullptr;        // to be filled in, where it is not null
  JournalWriter* journal = nullptr;  // of Subcommand::run; null: none is kept
  const PlanRecord* plan = nullptr;  // of the run that is repeated; null: of none under commands
};

// Runs the text to its end, or to where it is stopped (dry-run: without a clock; run: by it), with
// trace and plot as the options say. Fills in what was measured, why the run is over, and what of
// it could not be written; without files to write into, nothing moves.
void run_motion(const MotionOrder& order, TextFeed& text, FileReport& report);

}  // namespace kerf::program
