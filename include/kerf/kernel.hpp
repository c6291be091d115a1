// The motion kernel in one object: G-code text in, one setpoint a tick out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <kerf/diagnostic.hpp>
#include <kerf/machine.hpp>
#include <kerf/profile.hpp>
#include <kerf/program_data.hpp>
#include <kerf/program_inputs.hpp>
#include <kerf/report.hpp>
#include <kerf/setpoint.hpp>
#include <tl/expected.hpp>

namespace kerf {
inline namespace v0 {

/// What a program leaves in force: modal codes, offsets, tools, parameters. One that is made
/// without anything is empty.
class KERF_API ProgramState {
 public:
  struct Content;

  ProgramState() noexcept = default;
  explicit ProgramState(Content content);
  ProgramState(const ProgramState& other);
  ProgramState(ProgramState&& other) noexcept : content_(std::exchange(other.content_, nullptr)) {}
  ProgramState& operator=(ProgramState other) noexcept {
    std::swap(content_, other.content_);
    return *this;
  }
  ~ProgramState();

  /// For the kernel alone. Null: it is empty.
  [[nodiscard]] const Content* content() const noexcept { return content_; }

 private:
  const Content* content_ = nullptr;
};

/// A program that is run from one of its blocks on: what lies before is read, and not run. The tool
/// goes up in Z, over the place where the path goes on, and down to it at feedrate; tool, outputs,
/// spindle and coolant are what they would be by then. A block that begins within a curve that
/// stands for several is no place to start at: the curve is left out as a whole.
struct StartInProgram {
  std::uint64_t blocks_before = 0;  ///< ControllerStatus::block counts them
  bool waits = false;               ///< for resume(), before the tool leaves its place
};

/// How long a program takes by its text, before any override.
struct NominalTime {
  double motion_s = 0.0;         ///< length over feedrate
  double rest_s = 0.0;           ///< dwells, tool changes and starts of the spindle
  double rapid_s = 0.0;          ///< of motion_s what the rapid override slows
  double steady_s = 0.0;         ///< of motion_s what no override changes: M49, M50 P0, tapping
  double spindle_s = 0.0;        ///< of motion_s what feed and spindle override change: G95
  double spindle_alone_s = 0.0;  ///< of motion_s what only the latter changes: G95 under M50 P0
};

/// How one program is run.
struct KernelOptions {
  ProfileChoice profile{};
  std::size_t window_blocks = 1000;  ///< of the look-ahead, 2 to 1'000'000
  double horizon_s = 0.25;     ///< how far ahead of the tick the motion is fixed, 1e-5 to 3600
  BlockDelete block_delete{};  ///< which blocks that begin with '/' are left out
  /// M0, M60 and M6 wait for resume(); with optional_stop so does M1. Else the tool rests for a
  /// tick there.
  bool waits = false;
  bool optional_stop = false;
  bool refuses_waits = false;  ///< what would wait is an error: nobody is there to answer
  /// G38 and M66 wait for what set_program_inputs() says. Else the machine's surface and inputs
  /// answer (MachineSettings::simulation), without motion: as check_program() assumes.
  bool asks_machine = false;
  /// Where the machine is not asked, as by check_program(): a probe finds what it looks for at the
  /// end of its way. Of a machine whose workpiece is not in the settings; with checks_travel in the
  /// run, since the places that follow from the real contact are other ones.
  bool assumes_contact = false;
  /// plan() and tick() are called by one thread, or tick() waits for plan() (needs_plan()), which
  /// is never late then: no way to rest is kept ready after what is planned.
  bool one_thread = false;
  /// A third thread reads, Kernel::read(). Not with tells_operator.
  bool reads_apart = false;
  /// take_messages(), active_codes(), active_words() and left_s() have something to say.
  bool tells_operator = false;
  /// CheckReport::nominal of the program, for left_s(); nothing: nobody knows.
  std::optional<NominalTime> nominal{};
  bool checks_travel = false;  ///< a block that leaves the travel is an error
  /// Where the tool is, in machine coordinates, each within +-1e6.
  std::array<double, 3> start_mm{};
  /// The same for A, B, C in rad and U, V, W in mm.
  std::array<double, kAuxiliaryAxes> start_extra_rad_mm{};
  /// Kernel::state_left() of the program before, with the outputs that the machine has, before any
  /// override. Empty: what the machine's settings say.
  ProgramState begins_with{};
  Outputs start_outputs{};
  bool one_line = false;  ///< of an operator: it needs no M2 after it
  /// Nothing: from its begin. Of a Controller: its first program.
  std::optional<StartInProgram> start_in_program{};
  std::optional<Dialect> dialect{};  ///< nothing: the machine's
  SubprogramSource subprograms{};    ///< those that are not in the program's own text
  /// Gets lines about how the motion is planned: scans, breaking points, blocks, adjusted
  /// feedrates, searches. Called by what plans, on the planning side; empty: nobody is told.
  std::function<void(std::string_view line)> plan_log{};
  /// Asked by the planning side each time that it looks how far the ticks are, with how many calls
  /// of tick() are over; false: it looks again at once. -1: the latest look that it let pass came
  /// to nothing, for a tick was faster; what it gives then does not count. Where the ticks have a
  /// thread of their own, this is all that makes two runs of the same text under the same commands
  /// differ: whoever notes what it was asked, and lets the same pass in a later run, each when the
  /// ticks are there, has every plan take over at the same tick. Throws nothing. Empty: nobody is
  /// asked.
  std::function<bool(std::int64_t ticks)> plan_clock{};
};

/// How far Kernel::read() has come.
enum class ReadStatus : std::uint8_t {
  read,        ///< something was read: call it again
  far_enough,  ///< far ahead of plan(), or the program waits for what the machine answers
  wants_text,  ///< feed() or finish() first
  ended,       ///< the whole program is read
};

/// What belongs to a tick beside its setpoint.
struct TickDetail {
  /// The parameter u of the NURBS at the setpoint: as the program wrote it where the path is exact,
  /// of Kerf's own curve where G64 made one. Nothing: it is on none.
  std::optional<double> curve_parameter{};
  /// How far the path leaves the straight line from the setpoint before to this one.
  double chord_error_mm = 0.0;
  /// How far the curve that the setpoint is on leaves the programmed path at the most: of a blend
  /// in a corner, or a curve in place of lines. Else 0.
  double deviation_mm = 0.0;
  /// How many blocks of the program's run the tool has come to; a block of a loop counts as often
  /// as it runs.
  std::uint64_t block = 0;
  WaitCause wait_cause = WaitCause::none;  ///< of TickStatus::waiting
  /// At rest until the machine answers: an input (M66), or the spindle that comes up to speed.
  bool waits_for_machine = false;
  bool at_rest = false;  ///< no axis moves at the setpoint, A to W neither
};

/// What an operator makes of the feedrates of a program, as shares of them. Limits of path and axes
/// hold whatever they are. A share of feedrates below kLeastFeed is taken for 0.
struct Overrides {
  static constexpr double kLeastFeed = 1e-6;
  double feed = 1.0;     ///< of programmed feedrates, 0 to 2; at 0 the tool holds
  double rapid = 1.0;    ///< of rapids, 0.05 to 1
  double spindle = 1.0;  ///< of the spindle's speed, and so of feedrates of G95, 0.1 to 2

  friend bool operator==(const Overrides&, const Overrides&) = default;
};

/// Each is a number within its range.
KERF_API bool is_possible(const Overrides& overrides) noexcept;

/// What the machine makes of the feedrates of a program, where the program lets it. A share below
/// Overrides::kLeastFeed is taken for 0.
struct FeedInputs {
  double adaptive =
      1.0;            ///< share of all feedrates, rapids too, under M52 P1; 0 to 1, at 0 it holds
  bool stop = false;  ///< the tool holds, but under M53 P0

  friend bool operator==(const FeedInputs&, const FeedInputs&) = default;
};

/// The same.
KERF_API bool is_possible(const FeedInputs& inputs) noexcept;

/// Each number is within the range that a machine file allows.
KERF_API bool is_possible(const Tool& tool) noexcept;

/// Runs one program. Feeding and planning are for one thread; tick() and what belongs to it may run
/// in another, with real-time priority. docs/embedding.md has threads, memory and errors of each
/// method.
///
/// A program with an error stops on the path before the block that is wrong; check_program() finds
/// errors before anything moves. Where validate() finds settings or options impossible, the program
/// ends at once with that error and the tool stays where it is.
///
/// A run checks itself: the plan against the program's blocks, each setpoint against the limits,
/// the last one against the programmed end. A promise that does not hold is a fault(), a defect of
/// Kerf. If the segments of the plan do not fit together, the motion ends with what has been
/// delivered. Any other fault lets it go on.
class KERF_API Kernel {
 public:
  /// The tool rests at options.start_mm. See validate() for what is impossible.
  explicit Kernel(const MachineSettings& settings, const KernelOptions& options = {});
  ~Kernel();
  Kernel(Kernel&&) noexcept;
  Kernel& operator=(Kernel&&) noexcept;

  /// Takes the next bytes of the program, in pieces of any size. Not after finish().
  void feed(std::string_view text);
  /// No more text follows. Call it once.
  void finish();

  /// Plans ahead until the horizon is reached or more text is needed. True: more text is needed.
  /// Where nearly half of the horizon is planned, a search may be left to the next call.
  bool plan();
  /// With KernelOptions::reads_apart, for a thread of its own beside plan(): reads the next part of
  /// the text, smooths it and makes blocks of it. feed() and finish() belong to that thread then,
  /// and plan() returns true where it needs what is not read yet. While that thread reads nothing
  /// else may be called that sees or changes what is read: of the planning side only plan(),
  /// stop(), hold(), resume() and set_overrides(). The motion is the same.
  ReadStatus read();
  /// One setpoint. Real time: allocates nothing, takes no lock, throws nothing.
  TickStatus tick(Setpoint& setpoint) noexcept;
  /// plan() and tick(): for callers with one thread and no clock. Starved means: feed() or
  /// finish().
  TickStatus next(Setpoint& setpoint);

  /// For callers with one thread that call plan() and tick() themselves: call it before each
  /// tick(). Where blocks are shorter than a tick, it passes those that are over and plans on, so
  /// that the queue reaches the tick. next() does so by itself.
  void reach_tick();
  /// For callers without a clock that call plan() in another thread, with
  /// KernelOptions::one_thread: call it before each tick(), and wait while it is true; the ticks
  /// are those of one thread then. Where it is still true after a plan() that began later,
  /// make_room() passes blocks that are shorter than a tick, as reach_tick() does, for the next
  /// plan(). Nothing passed: no more is planned. Tick side, as tick().
  [[nodiscard]] bool needs_plan() noexcept;
  void make_room() noexcept;

  /// Lets the tool come to rest after all that was read. Call it when the text is late and the
  /// horizon is nearly used up. next() does so by itself.
  void plan_to_rest();
  /// Less than half of the horizon is planned. Planning side.
  [[nodiscard]] bool runs_low() const noexcept;
  /// Lets the tool come to rest on the path as soon as the limits allow, and ends the program
  /// there.
  void stop();
  /// Feed hold: the tool begins to brake some milliseconds later, comes to rest on the path as soon
  /// as the limits allow, and rests until resume(); ticks are `held` then. What is left of a dwell
  /// waits, too. Does nothing while it holds, and once the program has ended. Planning side.
  void hold();
  /// Goes on from a hold, on the same path, or from where the program waits. Planning side.
  void resume();
  /// Whether M1 waits, of text that is not read yet. Planning side.
  void set_optional_stop(bool on);
  /// Which blocks with a '/' are left out, of text that is not read yet. Planning side.
  void set_block_delete(const BlockDelete& switches);
  /// A tool is another one than the tool table said: for text that is not read yet. Where an M6
  /// waits nothing after it is read, so all that follows is planned with it. What is read from now
  /// on is held against the travel, whatever KernelOptions::checks_travel says. False: its number
  /// or a length is impossible, and nothing changes. Planning side.
  bool set_tool(const Tool& tool);
  /// A start in the program (KernelOptions::start_in_program) is on its way to a place under G43:
  /// it was computed with the tools as they were, and set_tool() does not move it. Planning side.
  [[nodiscard]] bool start_counts_on_tools() const;
  /// The messages of the blocks that the tool has come to since the last call. Planning side, as
  /// active_codes(): both as of the latest plan().
  [[nodiscard]] std::vector<ProgramMessage> take_messages();
  /// The codes that are in force on the block that the tool is at: "G1 G17 G21 ..."; empty before
  /// the first.
  [[nodiscard]] std::string_view active_codes() const noexcept;
  /// Beside them F as it was written, S, and the tool in the spindle: "F600 S9000 T1"; no F before
  /// the first.
  [[nodiscard]] std::string_view active_words() const noexcept;
  /// How long the rest of the program takes, by what the part after the tool took. Nothing: nobody
  /// knows, or at a feed override of 0 never. Planning side.
  [[nodiscard]] std::optional<double> left_s() const;

  /// Goes on with other feedrates some milliseconds later, on the same path, without a stop where
  /// the limits allow; a feedrate that is too high by then falls as fast as they allow. The last
  /// one counts. At feed 0 the tool holds until another value comes. The profile of the options is
  /// back after the next rest or cruise: until then the motion is time-optimal. Where the program
  /// forbids it (M49, M50 P0, M51 P0, tapping) the programmed feedrate or speed is kept. False: a
  /// value is out of its range, and nothing changes. Planning side.
  bool set_overrides(const Overrides& overrides);

  /// Follows the machine's inputs, in the way of set_overrides(). Where the tool is, the program
  /// says whether a stop counts: the tool begins to hold some milliseconds after the block that
  /// lets it. False: a value is out of its range, and nothing changes. Planning side.
  bool set_feed_inputs(const FeedInputs& inputs);

  /// What the machine says, for G38 and M66: call it before each tick(), in the same thread. Real
  /// time. Without options.asks_machine it counts for nothing.
  void set_program_inputs(const ProgramInputs& inputs) noexcept;
  /// The program asks the machine something that is not answered yet. While it does not, ticks do
  /// not depend on set_program_inputs(). Tick side, as tick().
  [[nodiscard]] bool asks_machine() noexcept;

  /// The tool comes to rest at the junction after each block of the program and waits for
  /// resume(); ticks are `waiting` then. From then on G64 makes no curve of several blocks and
  /// leaves their corners as they are; lines of which it has made one by then are one block.
  /// Switched on in motion, the first is the block at whose end the limits still let it rest.
  /// Planning side.
  void set_single_block(bool on);

  /// From the next tick on the tool brakes on the path as fast as the accelerations of path and
  /// axes allow, whatever the jerk, with spindle and coolant off; then ticks are `emergency_stop`,
  /// and the program is over. Needs no planning. Any thread.
  void emergency_stop() noexcept;

  /// What is in force where the tool is: once the program has ended, or else at the block that the
  /// tool has come to; but data and parameters, as far as the text was read. An M2 or M30 has done
  /// what LinuxCNC does there. Of a program that tells_operator. Planning side; call it when no
  /// tick() runs any more.
  [[nodiscard]] ProgramState state_left() const;

  /// How far the path leaves the straight line between the last two setpoints. Tick side.
  [[nodiscard]] double chord_error_mm() const noexcept;
  /// Of the latest tick. Tick side.
  [[nodiscard]] TickDetail detail() const noexcept;
  /// The first promise that did not hold; nothing: all did. Call it when no tick() runs any more:
  /// it reads what tick() writes. Allocates.
  [[nodiscard]] std::optional<RunFault> fault() const;
  /// A promise did not hold so far: a defect of Kerf. Tick side.
  [[nodiscard]] bool has_fault() const noexcept;
  /// The largest figures so far. Tick side.
  [[nodiscard]] RunFigures figures() const noexcept;
  /// The place where G64 leads the path farthest from the programmed one, as far as it is planned:
  /// the larger of both directions, from the geometry. 0: nowhere. Planning side.
  [[nodiscard]] PathDeviation deviation() const noexcept;
  /// The path modes and tolerances under which motion was read so far, in the order in which they
  /// came first, at most 8. Planning side.
  [[nodiscard]] std::vector<PathControlUse> path_controls() const;
  /// The program has an error in what was read so far. Planning side.
  [[nodiscard]] bool has_errors() const;
  /// The error is a block that leaves the travel (KernelOptions::checks_travel). Planning side.
  [[nodiscard]] bool left_travel() const noexcept;
  /// Errors and warnings so far. The reference is good until the next call on the planning side.
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const;
  /// What was planned so far. Planning side.
  [[nodiscard]] const PlanTotals& totals() const;
  /// Where what was read rests for somebody or something. Planning side.
  [[nodiscard]] const PlanWaits& waits() const noexcept;

 private:
  class Impl;
  Impl* impl_;  ///< owned; null once moved from
};

/// The first impossible value, under its name: "horizon_s".
KERF_API tl::expected<void, SettingsError> validate(const KernelOptions& options);

}  // namespace v0
}  // namespace kerf
