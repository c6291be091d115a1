// The motion kernel in one object: G-code text in, one setpoint a tick out.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <kerf/diagnostic.hpp>
#include <kerf/machine.hpp>
#include <kerf/profile.hpp>
#include <kerf/program_data.hpp>
#include <kerf/report.hpp>
#include <kerf/setpoint.hpp>
#include <tl/expected.hpp>

namespace kerf {
inline namespace v0 {

/// How one program is run.
struct KernelOptions {
  ProfileChoice profile{};
  std::size_t window_blocks = 1000;  ///< of the look-ahead, >= 2
  double horizon_s = 0.25;           ///< how far ahead of the tick motion is frozen
  BlockDelete block_delete{};        ///< which blocks that begin with '/' are left out
  bool checks_travel = false;        ///< a block that leaves the table is an error, as in the check
  std::array<double, 3> start_mm{};  ///< where the tool is
  std::array<double, kAuxiliaryAxes> start_extra_rad_mm{};  ///< A, B, C in rad, U, V, W in mm
  std::optional<Dialect> dialect{};                         ///< nothing: the machine's
  SubprogramSource subprograms{};  ///< those that are not in the program's own text
};

/// Runs one program. Feeding and planning happen in the caller's thread; tick() only reads what was
/// planned and is safe in a real-time thread of its own. docs/embedding.md has threads, memory and
/// errors of each method.
///
/// A program with an error stops on the path before the block that is wrong; check_program() finds
/// errors before anything moves. Where validate() finds settings or options impossible, the program
/// ends at once with that error and the tool stays where it is.
///
/// A run checks itself: the plan against the program's blocks, each setpoint against the limits,
/// the last one against the programmed end. What does not hold is a fault(), a defect of Kerf. If
/// the segments of the plan do not fit together, the motion ends with what has been delivered. Any
/// other fault lets it go on.
class KERF_API Kernel {
 public:
  /// The tool rests at options.start_mm. See validate() for what is impossible.
  explicit Kernel(const MachineSettings& settings, const KernelOptions& options = {});
  ~Kernel();
  Kernel(Kernel&&) noexcept;
  Kernel& operator=(Kernel&&) noexcept;

  /// Takes the next bytes of the program, in pieces of any size.
  void feed(std::string_view text);
  /// No more text follows.
  void finish();

  /// Plans ahead until the horizon is reached or more text is needed. True: more text is needed.
  bool plan();
  /// One setpoint. Real time: allocates nothing, takes no lock, throws nothing.
  TickStatus tick(Setpoint& setpoint) noexcept;
  /// plan() and tick(): for callers with one thread and no clock. Starved means: feed() or
  /// finish().
  TickStatus next(Setpoint& setpoint);

  /// Before tick(), for callers with one thread: passes what is over before it and plans on, until
  /// the queue holds the tick. Else a queue full of blocks that are all shorter than a tick starves
  /// it. next() does so by itself.
  void reach_tick();

  /// Lets the tool come to rest after all that was read: for when more text does not come before
  /// the horizon is used up. next() does so by itself.
  void plan_to_rest();
  /// Less than half of the horizon is planned. Belongs to the planning side.
  [[nodiscard]] bool runs_low() const noexcept;
  /// Lets the tool come to rest on the path as soon as the limits allow, and ends the program
  /// there.
  void stop();

  /// How far the path leaves the straight line between the last two setpoints.
  [[nodiscard]] double chord_error_mm() const noexcept;
  /// What did not hold so far. Nothing: all did. Not from a real-time thread, and complete only
  /// once tick() is not called any more.
  [[nodiscard]] std::optional<RunFault> fault() const;
  /// The largest figures so far. Belongs to the tick side.
  [[nodiscard]] RunFigures figures() const noexcept;
  /// Where G64 leads the path farthest from what the program says, as far as it is planned: the
  /// larger of both directions, from the geometry. 0: nowhere. Belongs to the planning side.
  [[nodiscard]] PathDeviation deviation() const noexcept;
  [[nodiscard]] bool has_errors() const;
  /// The error is a block that leaves the travel (KernelOptions::checks_travel).
  [[nodiscard]] bool left_travel() const noexcept;
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const;
  [[nodiscard]] const PlanTotals& totals() const;

 private:
  class Impl;
  Impl* impl_;  ///< owned; null once moved from
};

/// The first impossible value, under its name: "horizon_s".
KERF_API tl::expected<void, SettingsError> validate(const KernelOptions& options);

}  // namespace v0
}  // namespace kerf
