// A machine that runs programs, in one state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <kerf/program_inputs.hpp>
#include <kerf/setpoint.hpp>
#include <tl/expected.hpp>

namespace kerf {
inline namespace v0 {

enum class ControllerState : std::uint8_t {
  off,             ///< the drives are off
  emergency_stop,  ///< braking, or at rest with the drives off
  idle,            ///< enabled, no program
  running,
  waiting,  ///< a program rests until what it waits for is there (WaitsFor)
  holding,  ///< braking for a feed hold
  held,
  stopping,   ///< braking to the end of the program
  fault,      ///< the drives are off
  jogging,    ///< by hand, from idle or held, or coming to rest after it
  returning,  ///< from where it was jogged to, to the place of the hold
  homing,     ///< the axes look for their switches
};
inline constexpr std::size_t kControllerStates = 12;

enum class Command : std::uint8_t {
  enable,
  disable,
  start,
  hold,
  resume,
  stop,
  emergency_stop,
  reset,
  override,       ///< set_overrides()
  single_block,   ///< set_single_block()
  optional_stop,  ///< set_optional_stop()
  block_delete,   ///< set_block_delete()
  mdi,            ///< run_mdi()
  jog,            ///< jog()
  home
};
inline constexpr std::size_t kCommands = 15;

enum class WaitsFor : std::uint8_t {
  nothing,
  answer,    ///< resume: M0, M1, M60, M6, or the end of a block in single block
  text,      ///< feed() or finish()
  planning,  ///< plan() is late
  machine,   ///< an input (M66), or the spindle that comes up to speed
};

KERF_API std::string_view name_of(ControllerState state) noexcept;
KERF_API std::string_view name_of(Command command) noexcept;
KERF_API std::string_view name_of(WaitsFor what) noexcept;
KERF_API std::string_view name_of(WaitCause cause) noexcept;

/// What a state makes of a command.
struct Answer {
  ControllerState next = ControllerState::off;  ///< the state itself where nothing changes
  std::string_view refusal{};                   ///< why not; empty: it is accepted

  [[nodiscard]] constexpr bool is_accepted() const noexcept { return refusal.empty(); }
};

/// The one table of states and commands (docs/control.md).
KERF_API Answer answer_to(ControllerState state, Command command) noexcept;

struct Refusal {
  ControllerState state = ControllerState::off;
  Command command = Command::enable;
  std::string_view reason{};
  bool of_line = false;  ///< the line itself is wrong: program() says why
};

/// One bit an axis: bit 0 is x, then y, z.
using AxisSet = std::uint16_t;

/// A motion by hand, of several axes at once along a straight line. It ends at the travel; step or
/// not, it comes to rest within the limits.
struct Jog {
  /// Of a step: how far. Else how fast, in mm/s and rad/s.
  Position mm{};
  AuxiliaryPosition extra_rad_mm{};
  bool is_step = false;
  double step_mm_s = kUnbounded;  ///< of a step, along its path; where A, B, C move alone, deg/s

  friend bool operator==(const Jog&, const Jog&) = default;
};

/// Something that an operator should hear of: the state is another one, or the program said
/// something.
struct ControllerEvent {
  static constexpr std::size_t kKept = 2048;  ///< older ones are forgotten
  enum class Kind : std::uint8_t { state, message };

  std::uint64_t number = 0;  ///< counts from 1
  Kind kind = Kind::state;
  ControllerState state = ControllerState::off;  ///< after it
  WaitsFor waits_for = WaitsFor::nothing;
  WaitCause wait_cause = WaitCause::none;  ///< of WaitsFor::answer
  std::uint32_t line = 0;                  ///< of a state: where the tool was
  std::uint32_t message = 0;               ///< of a message: Controller::message() has it
};

/// What an operator sees, of one tick.
struct ControllerStatus {
  static constexpr std::size_t kMaxCodes = 200;

  ControllerState state = ControllerState::off;
  WaitsFor waits_for = WaitsFor::nothing;
  WaitCause wait_cause = WaitCause::none;  ///< of WaitsFor::answer
  std::uint64_t next_event = 1;            ///< that number will have the next event
  std::uint64_t programs = 0;              ///< started, ever
  double run_s = 0.0;              ///< how long the present or last program has run, rests included
  std::optional<double> left_s{};  ///< Kernel::left_s(), as of the latest plan()
  Overrides overrides{};
  FeedInputs feed_inputs{};
  bool is_held_by_feed = false;  ///< it runs, and rests: by the feed override or those inputs
  bool single_block = false;
  bool optional_stop = false;
  BlockDelete block_delete{};
  AxisSet unhomed = 0;      ///< have a home switch that was not found
  bool door_open = false;   ///< at the latest tick
  std::uint64_t block = 0;  ///< TickDetail::block of the present or last program
  Setpoint setpoint{};      ///< its tick counts from the controller's first
  /// "G1 G17 G21 ...": in force where the tool is, cut off where they are longer; the rest is 0.
  std::array<char, kMaxCodes> codes{};
};

/// Runs programs one after the other, each by a Kernel of its own, which begins where the tool is.
/// Commands, feeding and planning are for one thread; tick() for another, which calls it once a
/// period for ever, program or not. emergency_stop(), fail(), drives_on(), waits_for() and
/// events_since() are for any thread; status() and message() for any but that of tick(); detail()
/// and what its comments name for that one. docs/embedding.md has a row for each.
///
/// The drives follow the state: they are on but in off and fault, and in emergency_stop once the
/// tool rests or after a fault (drives_on).
class KERF_API Controller {
 public:
  /// Off, with the tool at rest at the start place of the options, which are those of every
  /// program, but that it waits for answers and has a planning thread. validate() says what is
  /// impossible; such a program ends at once with that error.
  explicit Controller(const MachineSettings& settings, const KernelOptions& options = {});
  ~Controller();
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// `start` begins a program: feed() it. `home` lets each axis with a home switch find it
  /// (ManualSettings). The commands that come with a value change nothing here. Allocates.
  tl::expected<void, Refusal> give(Command command);
  /// Kernel::set_overrides(), for the present program and those to come. Refused where a value is
  /// out of its range.
  tl::expected<void, Refusal> set_overrides(const Overrides& overrides);
  /// Kernel::set_single_block(), for the present program and those to come.
  tl::expected<void, Refusal> set_single_block(bool on);

  /// Kernel::set_optional_stop() and set_block_delete(), the same.
  tl::expected<void, Refusal> set_optional_stop(bool on);
  tl::expected<void, Refusal> set_block_delete(const BlockDelete& switches);

  /// Runs one line of an operator as a program of its own, with what the program or line before has
  /// left in force; a program after lines begins with what they left. A line that is wrong is
  /// refused, and program() says why; of a line that calls others, what is wrong far behind is
  /// found as of a program.
  tl::expected<void, Refusal> run_mdi(std::string_view line);
  /// Moves by hand, from idle or held. A continuous jog goes on while it is given again, at least
  /// every jog_timeout_s; `stop` ends it. Another one while it jogs begins once that has come to
  /// rest; steps add up. A resume goes back over the places where jogs began, the last one first.
  tl::expected<void, Refusal> jog(const Jog& jog);

  /// Kernel::set_feed_inputs(), for the present program and those to come. False: a value is out of
  /// its range, and nothing changes.
  bool set_feed_inputs(const FeedInputs& inputs);

  /// Kernel::set_tool(), for the present program and those to come. Refused: a number or length
  /// that is impossible, a tool that the machine's table does not have, and while a start counts on
  /// the tools as they were (Kernel::start_counts_on_tools()).
  tl::expected<void, Refusal> set_tool(const Tool& tool);

  /// CheckReport::nominal of the program that is started next, for its left_s. The options say that
  /// of the first; where neither does, nobody knows.
  void set_nominal(const NominalTime& time);

  /// To the present program; where there is none, as while an operator's line runs, text is
  /// dropped.
  void feed(std::string_view text);
  /// No more text follows.
  void finish();
  /// Kernel::plan(), some times a horizon. True: more text is wanted.
  bool plan();
  /// The text is late: the tool comes to rest after what was read, unless much is planned still.
  void text_is_late();
  /// The present or last program or line: its errors and figures. Null: there was none. Planning
  /// side.
  [[nodiscard]] const Kernel* program() const noexcept;

  /// One setpoint; without a program it repeats the last. Real time: allocates nothing, takes no
  /// lock, throws nothing.
  ControllerState tick(Setpoint& setpoint) noexcept;
  /// Kernel::set_program_inputs(), for the present program and those to come. Of the thread that
  /// calls tick(), before it. Real time.
  void set_program_inputs(const ProgramInputs& inputs) noexcept;
  /// Kernel::detail(); without a program that of the last one. Of the thread that calls tick().
  [[nodiscard]] TickDetail detail() const noexcept;

  /// Which home switches are closed, as of the latest setpoint. The next tick() sees it. Of the
  /// thread that calls tick().
  void set_home_switches(AxisSet closed) noexcept;
  /// While the door is open nothing begins to move: programs in motion are held, jogs and homing
  /// stopped, by plan(); resume, start, mdi, jog and home are refused. Nothing goes on by itself
  /// once it is closed. Of the thread that calls tick().
  void set_door(bool is_open) noexcept;
  /// At the latest tick homing has given an axis, at rest, its place: the drives are to be enabled
  /// anew, at the setpoint. Of the thread that calls tick().
  [[nodiscard]] bool has_new_place() const noexcept;
  /// ControllerStatus::unhomed: axes that have no travel yet. Of the thread that calls tick().
  [[nodiscard]] AxisSet unhomed() const noexcept;

  /// Kernel::emergency_stop(), and the program is over. From every state.
  void emergency_stop() noexcept;
  /// The machine reports a fault: as emergency_stop(), but the state is fault.
  void fail() noexcept;
  [[nodiscard]] bool drives_on() const noexcept;
  /// ControllerStatus::waits_for. Waits for nobody, so that the thread of tick() may ask, too.
  [[nodiscard]] WaitsFor waits_for() const noexcept;
  /// Of the latest tick, whole. Takes no lock, but waits for a thread that is just writing: not for
  /// the thread of tick().
  [[nodiscard]] ControllerStatus status() const noexcept;
  /// The events from that number on, as many as there is room for, oldest first; returns how many.
  /// Any thread; takes no lock.
  [[nodiscard]] std::size_t events_since(std::uint64_t number,
                                         std::span<ControllerEvent> events) const noexcept;
  /// Of an event; nothing: it is forgotten, 1,024 others came after it. Of a text that is longer
  /// than 500 bytes, these. Any thread; takes no lock, allocates.
  [[nodiscard]] std::optional<ProgramMessage> message(std::uint32_t number) const;

 private:
  class Impl;
  Impl* impl_;  ///< owned
};

}  // namespace v0
}  // namespace kerf
