// What a Controller is made of.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include <kerf/controller.hpp>

#include "control/event_log.hpp"
#include "control/messages.hpp"
#include "control/snapshot.hpp"
#include "control/state_word.hpp"

namespace kerf {

// The state is one atomic word: each side changes it by exchange, from the state that it knows, so
// an emergency stop from any thread is never lost. A kernel belongs to the planning side; the tick
// side has it from `start` on until it has seen the program's end, and gives it back before the
// state says so.
class KERF_LOCAL Controller::Impl {
 public:
  Impl(MachineSettings settings, KernelOptions options);

  tl::expected<void, Refusal> give(Command command);
  tl::expected<void, Refusal> set_overrides(const Overrides& overrides);
  tl::expected<void, Refusal> set_single_block(bool on);
  tl::expected<void, Refusal> set_optional_stop(bool on);
  tl::expected<void, Refusal> set_block_delete(const BlockDelete& switches);
  bool set_feed_inputs(const FeedInputs& inputs);

  void feed(std::string_view text);
  void finish();
  bool plan();
  void text_is_late();
  [[nodiscard]] const Kernel* program() const noexcept { return kernel_.get(); }

  ControllerState tick(Setpoint& setpoint) noexcept;
  [[nodiscard]] const TickDetail& detail() const noexcept { return detail_; }

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

  // The table, and what it cannot say.
  [[nodiscard]] Answer answer_now(ControllerState state, Command command) const noexcept;
  // StateWord::change, with the event.
  bool change(control::StateWord::Seen& from, ControllerState to) noexcept;
  // What comes before the state changes: of a start, the kernel.
  std::unique_ptr<Kernel> prepare(Command command);
  void carry_out(Command command);
  // What the operator has set, for the program that runs and all to see.
  tl::expected<void, Refusal> set(Command command);

  [[nodiscard]] std::unique_ptr<Kernel> kernel_from_here() const;
  void start(std::unique_ptr<Kernel> kernel);
  // What the program says where the tool is.
  void tell();

  // What a tick found, and the state before it: a command that came meanwhile knows better.
  struct Ticked {
    control::StateWord::Seen before{};
    TickStatus status = TickStatus::running;
  };
  void follow(Ticked tick, const Kernel& kernel) noexcept;
  void end(ControllerState next) noexcept;
  [[nodiscard]] WaitsFor waits_for(ControllerState state) const noexcept;
  // Spindle and coolant stay as the program left them, and are off without drives.
  void rest() noexcept;
  void publish() noexcept;

  MachineSettings settings_;
  KernelOptions options_;
  control::StateWord state_;
  std::atomic<std::uint64_t> programs_ = 0;
  std::atomic<std::int64_t> run_ticks_ = 0;
  std::atomic<bool> wants_text_ = false;
  std::atomic<bool> waits_for_answer_ = false;
  std::atomic<std::uint32_t> line_ = 0;
  std::atomic<Kernel*> running_ = nullptr;
  std::unique_ptr<Kernel> kernel_;
  Published operator_{};
  bool ran_ = false;  // at the last plan()
  control::Snapshot<Published> published_;
  control::EventLog events_;
  control::Messages messages_;
  // Of the tick side.
  std::int64_t tick_ = 0;
  TickDetail detail_{};
  Setpoint last_{};
  WaitsFor told_wait_ = WaitsFor::nothing;
  control::Snapshot<ControllerStatus> snapshot_;
};

}  // namespace kerf
