// The report on one program once it is over.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/report.hpp>

#include "curves/position.hpp"
#include "diagnostics/diagnostic.hpp"
#include "kernel/tick_judge.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/program_reader.hpp"
#include "programs/kerf/exit_status.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/report/fit.hpp"
#include "programs/kerf/report/speed_account.hpp"
#include "programs/kerf/report/start_report.hpp"
#include "programs/kerf/report/time_histogram.hpp"
#include "programs/kerf/report/time_parts.hpp"
#include "programs/kerf/report/time_split.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf::program {

// Known once a program is planned, whether it ran or not.
struct PlanReport {
  double cycle_time_s = 0.0;
  std::int64_t ticks = 0;
  double path_length_mm = 0.0;
  std::uint64_t blocks = 0;
  curves::Extents extents{};
  curves::AuxiliaryExtents extra_extents{};
  smoothing::PathDeviation deviation{};  // of the commanded path from the programmed one
  std::vector<PathControlUse> path_controls{};
  PlanWaits waits{};

  // By more than rounding.
  [[nodiscard]] bool deviates() const noexcept { return deviation.distance_mm >= 5e-7; }
};

// The path on the machine and in the coordinates of the program, as the check found it.
struct PathBoxes {
  curves::Extents all{};
  std::optional<curves::Extents> cutting;  // nothing: it only goes in rapids
  WorkExtents work{};
};

// The state just before a block runs for the first time, and the time of that.
struct BlockReport {
  std::uint32_t line = 0;
  parser::WatchedBlock block;
  double begin_s = 0.0;
  double duration_s = 0.0;  // 0: neither motion nor dwell
};

// Known once it ran.
struct MotionReport {
  Peaks path{};
  std::array<Peaks, 3> axes{};
  std::array<Peaks, curves::kAuxiliaryAxes> extra{};  // of A, B, C in rad
  double chord_error_mm = 0.0;
  double max_contour_error_mm = 0.0;
  double mean_contour_error_mm = 0.0;
  std::array<double, 3> max_following_error_mm{};
  TimeSplit time{};
  TimeParts parts{};  // empty of a run by the clock
  std::uint64_t starved_ticks = 0;
};

// Known once it ran by the clock.
struct ClockReport {
  std::uint64_t late_ticks = 0;
  double worst_delay_s = 0.0;
  TimeHistogram delays{};      // of each tick behind its time
  TimeHistogram tick_times{};  // how long each took
};

// What the machine ended the run for.
struct FaultReport {
  std::string_view kind;  // "following_error"
  std::string axis;       // empty: none is to blame
  std::uint32_t line = 0;
  double t_s = 0.0;
  bool needs_homing = false;  // the machine may be elsewhere than it says
};

struct FileReport {
  std::string file;
  Subcommand command = Subcommand::dry_run;
  bool syntax_only = false;
  std::string machine;  // the machine file, or "default"
  std::string driver;   // of a run
  std::string_view profile;
  double feed_override = 1.0;      // share of the programmed feedrates
  bool live = false;               // ran as its text came, without a check of the whole before
  bool trace_reader_gone = false;  // and the motion was left where it was: nobody asks for more
  double period_s = 0.001;
  lookahead::PlanLimits limits{};
  parser::Letters extra_axes = 0;       // that the machine has
  FeedUnit feed_unit = FeedUnit::mm_s;  // beside mm/s in words and pictures
  ExitStatus status = ExitStatus::done;
  std::vector<diagnostics::Diagnostic>
      diagnostics;                    // errors and warnings with a place in the program
  std::vector<std::string> failures;  // errors without one: files, faults of the machine
  std::vector<std::string> warnings;  // without a place
  std::optional<PathBoxes> boxes;     // of a program that was checked and moves
  std::optional<FitReport> fit;       // the same
  std::optional<PlanReport> plan;
  std::optional<BlockReport> block;  // of Subcommand::explain
  std::optional<StartReport> start;  // with --from-line
  std::optional<MotionReport> motion;
  std::optional<ClockReport> clock;
  std::optional<FaultReport> machine_fault;
  SpeedQuestion speed_question{};
  std::optional<SpeedReport> speed;  // with --explain-speed
  double check_duration_s =
      0.0;  // how long kerf itself took; the only figures that a second run changes
  double run_duration_s = 0.0;

  // The first status that is not done stays; every message does.
  void fail(ExitStatus why, std::string message);
  // The run did not keep a promise of kerf: an internal error.
  void fail(const RunFault& fault);
  void take(const std::vector<diagnostics::Diagnostic>& found);
  // Its time was up in the line: more than the look at its length alone could tell.
  struct TooLong {
    std::uint32_t line = 0;
    double max_time_s = 0.0;
  };
  void fail_too_long(const TooLong& at);
};

// One figure beside its limit.
struct LimitUse {
  std::string_view where{};     // "path", "x", "y", "z", and "a" and so on
  std::string_view quantity{};  // "velocity", "acceleration", "jerk"
  std::string_view unit{};
  double peak = 0.0;
  double limit = 0.0;  // infinite: does not bind

  [[nodiscard]] double ratio() const noexcept { return peak / limit; }
  // By more than what finite differences between ticks may overstate.
  [[nodiscard]] bool is_exceeded() const noexcept { return peak > 1.005 * limit; }
};

// Path, x, y, z and the machine's other axes, in degrees where they turn; for each of them
// velocity, acceleration, jerk.
[[nodiscard]] std::vector<LimitUse> limit_uses(const MotionReport& motion,
                                               const lookahead::PlanLimits& limits,
                                               parser::Letters extra_axes = 0);

// "axis x jerk 1.24e6 mm/s3 is 22.5 times its limit of 55000 mm/s3"
[[nodiscard]] std::string describe(const LimitUse& use);

// A warning for each line with a degradation, and one that counts what was not kept.
[[nodiscard]] std::vector<std::string> describe(const PlanDegradations& degradations);

}  // namespace kerf::program
