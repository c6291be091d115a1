// What a Controller is made of.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include <kerf/controller.hpp>

#include "control/event_log.hpp"
#include "control/home_search.hpp"
#include "control/manual_move.hpp"
#include "control/messages.hpp"
#include "control/snapshot.hpp"
#include "control/state_word.hpp"
#include "interp/tick_calls.hpp"

namespace kerf {

// The state is one atomic word: each side changes it by exchange, from the state that it knows, so
// an emergency stop from any thread is never lost. A kernel belongs to the planning side; the tick
// side has it from `start` on until it has seen the program's end, and gives it back before the
// state says so.
//
// What moves by hand is a kernel, too, of one straight line, which Kernel::stop() ends. The
// program's kernel waits meanwhile, held. Such a state ends in plan(), once the tick side has given
// that kernel back.
class KERF_LOCAL Controller::Impl {
 public:
  Impl(MachineSettings settings, KernelOptions options);

  tl::expected<void, Refusal> give(Command command);
  tl::expected<void, Refusal> set_overrides(const Overrides& overrides);
  tl::expected<void, Refusal> set_single_block(bool on);
  tl::expected<void, Refusal> set_optional_stop(bool on);
  tl::expected<void, Refusal> set_block_delete(const BlockDelete& switches);
  bool set_feed_inputs(const FeedInputs& inputs);
  tl::expected<void, Refusal> run_mdi(std::string_view line);
  tl::expected<void, Refusal> jog(const Jog& jog);
  tl::expected<void, Refusal> set_tool(const Tool& tool);
  void set_nominal(const NominalTime& time) { options_.nominal = time; }

  void feed(std::string_view text);
  void finish();
  bool plan();
  void text_is_late();
  [[nodiscard]] const Kernel* program() const noexcept { return kernel_.get(); }

  ControllerState tick(Setpoint& setpoint) noexcept;
  void set_program_inputs(const ProgramInputs& inputs) noexcept { inputs_ = inputs; }
  [[nodiscard]] const TickDetail& detail() const noexcept { return detail_; }

  void set_home_switches(AxisSet closed) noexcept { closed_ = closed; }
  void set_door(bool is_open) noexcept { door_open_.store(is_open, std::memory_order_relaxed); }
  [[nodiscard]] bool has_new_place() const noexcept { return has_new_place_; }
  [[nodiscard]] AxisSet unhomed() const noexcept { return home_search_.unhomed(); }

  void leave_for(ControllerState next) noexcept;
  [[nodiscard]] bool drives_on() const noexcept;
  [[nodiscard]] WaitsFor waits_for() const noexcept { return waits_for(state_.state()); }
  [[nodiscard]] ControllerStatus status() const noexcept;
  [[nodiscard]] const control::EventLog& events() const noexcept { return events_; }
  [[nodiscard]] std::optional<ProgramMessage> message(std::uint32_t number) const {
    return messages_.find(number);
  }

 private:
  // Of the planning side, for all to see.
  struct Published {
    Overrides overrides{};
    FeedInputs feed_inputs{};
    bool single_block = false;
    bool optional_stop = false;
    BlockDelete block_delete{};
    std::optional<double> left_s{};
    std::array<char, ControllerStatus::kMaxCodes> codes{};
  };

  static constexpr std::string_view kDoorIsOpen = "the door is open";

  [[nodiscard]] static bool is_by_hand(ControllerState state) noexcept {
    return state == ControllerState::jogging || state == ControllerState::returning ||
           state == ControllerState::homing;
  }
  // Of the ticks, all between the same two: what planning goes by.
  struct Seen {
    Kernel* running = nullptr;
    ControllerState state = ControllerState::off;
    bool door_open = false;
    std::int64_t ticks = 0;
    double spindle_ratio = 1.0;
    Setpoint at{};
  };
  // Before what follows the ticks (KernelOptions::plan_clock).
  void look_at_ticks();
  // What moves by hand, and homing, go on as they are seen then.
  void follow_ticks();
  // From the next tick on it has what was written for it.
  void tell_ticks();
  // The table, and what it cannot say.
  [[nodiscard]] Answer answer_now(ControllerState state, Command command) const noexcept;
  // StateWord::change, with the event. Where the other side was faster with the next one the last
  // event is of the state that it is in all the same.
  bool change(control::StateWord::Seen& from, ControllerState to) noexcept;
  // What comes before the state changes: of a start, the kernel.
  std::unique_ptr<Kernel> prepare(Command command);
  void carry_out(Command command, ControllerState state);
  // Empty: the door lets it begin.
  [[nodiscard]] std::string_view door_refusal(Command command) const noexcept;
  // What moves is held or stopped while the door is open.
  void follow_door();
  void tell_program(Command command);
  // What the operator has set, for the program that runs and all to see.
  tl::expected<void, Refusal> set(Command command);

  [[nodiscard]] bool needs_homing() const noexcept {
    return home_search_.unhomed() != 0 && !settings_.manual.runs_unhomed;
  }
  enum class Runs : std::uint8_t { program, line };
  [[nodiscard]] KernelOptions options_from_here(Runs what);
  [[nodiscard]] std::unique_ptr<Kernel> kernel_from_here(Runs what);
  // Fed and planned.
  [[nodiscard]] std::unique_ptr<Kernel> kernel_of_line(std::string_view line);
  void start(std::unique_ptr<Kernel> kernel, Runs what);
  // The ticks are those of the program from now on.
  void run_program();
  // The same of any kernel.
  void run(Kernel& kernel);
  // A program runs, or is held while the tool moves by hand.
  [[nodiscard]] bool has_program(const Kernel* running) const noexcept {
    return is_suspended_ || (kernel_ && running == kernel_.get());
  }
  [[nodiscard]] bool has_program() const noexcept { return has_program(running_.load()); }
  // Of the latest tick. Where the state says that the tool rests, it rests there.
  [[nodiscard]] Setpoint here() const noexcept { return snapshot_.read().setpoint; }

  // What moves by hand is followed to its end; after an emergency stop it is dropped.
  void follow_manual();
  void follow_spindle();
  // Where the tool is, at rest, with the speed of the spindle without an override.
  [[nodiscard]] Setpoint rest_as_programmed() const;
  void follow_return();
  void run(const control::ManualMove& move);
  // It comes to rest.
  void end_move();
  // The same, and nothing by hand follows.
  void stop_manual();
  // At rest: somebody told it to stop, or the door does.
  bool stops_at_rest();
  // From where the hold was left. False: the state is another one by now.
  bool begin_return();
  // To the operator, as an event.
  void say(const std::string& text);
  void leave_manual_for(ControllerState next);
  // The program that is held ends where the tool was jogged to.
  void end_suspended();

  [[nodiscard]] tl::expected<control::ManualMove, std::string_view> move_of(const Jog& jog) const;
  [[nodiscard]] bool renews(const Jog& jog) const noexcept;
  void begin_jog(const Jog& jog, const control::ManualMove& move);
  void queue_jog(const Jog& jog);
  void follow_jog();

  void follow_homing();
  void fail_to_home(const std::string& why);

  // Plans the program and tells what it says, if it ran at the last plan() or began since. True: it
  // wants text.
  bool hear_out();
  // What the program says where the tool is. True: it said something.
  bool tell();
  void tell_failure_of_line();

  // What a tick found, and the state before it: a command that came meanwhile knows better.
  struct Ticked {
    control::StateWord::Seen before{};
    TickStatus status = TickStatus::running;
  };
  TickStatus tick(Kernel& kernel, ControllerState state) noexcept;
  void follow(Ticked tick, const Kernel& kernel) noexcept;
  void end(ControllerState next) noexcept;
  [[nodiscard]] WaitsFor waits_for(ControllerState state) const noexcept;
  // An event of that state.
  void note_state(ControllerState state, std::uint32_t line) noexcept;
  // Spindle and coolant stay as the program left them, and are off without drives.
  void rest(bool has_news) noexcept;
  void publish() noexcept;
  void tell_wait() noexcept;

  MachineSettings settings_;
  KernelOptions options_;  // `nominal` is of the program that is started next
  control::StateWord state_;
  std::atomic<std::uint64_t> programs_ = 0;
  std::atomic<std::int64_t> run_ticks_ = 0;
  std::atomic<bool> wants_text_ = false;
  std::atomic<bool> is_text_late_ = false;
  std::atomic<bool> waits_for_answer_ = false;
  std::atomic<bool> waits_for_machine_ = false;
  std::atomic<WaitCause> wait_cause_ = WaitCause::none;  // of that
  std::atomic<bool> door_open_ = false;
  std::atomic<std::uint32_t> line_ = 0;
  std::atomic<Kernel*> running_ = nullptr;  // until the tick side is at its end
  std::atomic<bool> by_hand_ = false;       // what runs is no program
  std::unique_ptr<Kernel> kernel_;
  Published operator_{};
  double spindle_share_ = 1.0;               // of the programmed speed, in the latest outputs
  double share_before_ = 1.0;                // until the tick that is told
  std::atomic<double> spindle_ratio_ = 1.0;  // by which that changes it; 1: it has
  bool ran_ = false;                         // at the last plan(), or began since
  bool ran_line_ = false;                    // the latest was one
  bool told_failure_ = false;                // of it
  // By hand.
  struct Manual {
    std::unique_ptr<Kernel> kernel{};
    Jog jog{};
    std::optional<Jog> next{};
    std::int64_t renewed_tick = 0;
    std::int64_t next_tick = 0;                    // `next` was given last
    bool ends = false;                             // the kernel was told to stop
    bool stops = false;                            // somebody told it so
    std::vector<control::AxisTargets> way_back{};  // its first place is that of the hold
  };
  Manual manual_{};
  bool is_suspended_ = false;  // the program is held, and the tool may be elsewhere
  control::HomeSearch home_search_;
  control::Snapshot<Published> published_;
  control::EventLog events_;
  control::Messages messages_;
  Seen seen_{};  // at the latest look at the ticks
  interp::TickCalls calls_;
  // Of the tick side.
  std::atomic<std::int64_t> tick_ = 0;  // to be written by it alone
  Kernel* ticked_ = nullptr;            // running_, from the tick on that was told
  bool has_new_place_ = false;
  std::optional<AxisSet> closed_{};  // home switches, as of last_: for the next tick
  ProgramInputs inputs_{};
  TickDetail detail_{};
  bool is_held_by_feed_ = false;  // it runs, and was held at the latest tick
  Setpoint last_{};
  WaitsFor told_wait_ = WaitsFor::nothing;
  control::Snapshot<ControllerStatus> snapshot_;
};

}  // namespace kerf
