#include <atomic>
#include <memory>
#include <utility>

#include <kerf/controller.hpp>

#include "control/snapshot.hpp"

namespace kerf {

using State = ControllerState;

// The state is one atomic word: each side changes it by exchange, from the state that it knows, so
// an emergency stop from any thread is never lost. A kernel belongs to the planning side; the tick
// side has it from `start` on until it has seen the program's end, and gives it back before the
// state says so.
class Controller::Impl {
 public:
  Impl(MachineSettings settings, KernelOptions options)
      : settings_(std::move(settings)), options_(std::move(options)) {
    last_.position_mm = options_.start_mm;
    last_.extra_rad_mm = options_.start_extra_rad_mm;
    published_.write(operator_);
    publish();
  }

  tl::expected<void, Refusal> give(Command command) {
    std::unique_ptr<Kernel> next;
    for (;;) {
      State state = state_.load();
      const Answer answer = answer_now(state, command);
      if (!answer.is_accepted()) {
        return tl::unexpected(
            Refusal{.state = state, .command = command, .reason = answer.refusal});
      }
      if (command == Command::start && !next) {
        next = kernel_from_here();
      }
      if (change(state, answer.next)) {
        break;
      }
    }
    if (next) {
      start(std::move(next));
    } else {
      carry_out(command);
    }
    return {};
  }

  tl::expected<void, Refusal> set_overrides(const Overrides& overrides) {
    if (!is_possible(overrides)) {
      return tl::unexpected(Refusal{.state = state_.load(),
                                    .command = Command::override,
                                    .reason = "an override is out of its range"});
    }
    operator_.overrides = overrides;
    return set(Command::override);
  }
  tl::expected<void, Refusal> set_single_block(bool on) {
    operator_.single_block = on;
    return set(Command::single_block);
  }

  void feed(std::string_view text) {
    if (running_.load() != nullptr) {
      kernel_->feed(text);
    }
  }
  void finish() {
    if (running_.load() != nullptr) {
      kernel_->finish();
    }
  }
  bool plan() {
    const bool wants_text = running_.load() != nullptr && kernel_->plan();
    wants_text_.store(wants_text, std::memory_order_relaxed);
    return wants_text;
  }
  void text_is_late() {
    if (running_.load() != nullptr && kernel_->runs_low()) {
      kernel_->plan_to_rest();
    }
  }
  [[nodiscard]] const Kernel* program() const noexcept { return kernel_.get(); }

  ControllerState tick(Setpoint& setpoint) noexcept {
    if (Kernel* kernel = running_.load(std::memory_order_acquire)) {
      const State state = state_.load();
      if (state == State::emergency_stop || state == State::fault) {
        kernel->emergency_stop();
      }
      const TickStatus status = kernel->tick(last_);
      ++run_ticks_;
      follow(status, *kernel);
    } else {
      rest();
    }
    last_.tick = tick_++;
    publish();
    setpoint = last_;
    return state_.load();
  }

  void leave_for(State next) noexcept {
    State state = state_.load();
    while (!change(state, next)) {
    }
  }
  [[nodiscard]] bool drives_on() const noexcept {
    const State state = state_.load();
    return state != State::off && state != State::fault &&
           (state != State::emergency_stop || running_.load() != nullptr);
  }
  [[nodiscard]] ControllerStatus status() const noexcept {
    ControllerStatus status = snapshot_.read();
    const OperatorSettings by = published_.read();
    status.overrides = by.overrides;
    status.single_block = by.single_block;
    status.state = state_.load();
    status.changes = changes_.load();
    status.waits_for = status.state != State::waiting ? WaitsFor::nothing
                       : waits_for_answer_.load()     ? WaitsFor::answer
                       : wants_text_.load()           ? WaitsFor::text
                                                      : WaitsFor::planning;
    return status;
  }

 private:
  struct OperatorSettings {
    Overrides overrides{};
    bool single_block = false;
  };

  // What the operator has set, for the program that runs and all to see.
  tl::expected<void, Refusal> set(Command command) {
    published_.write(operator_);
    return give(command);
  }

  // The table, and what it cannot say.
  [[nodiscard]] Answer answer_now(State state, Command command) const noexcept {
    if (command == Command::reset && running_.load() != nullptr &&
        answer_to(state, command).is_accepted()) {
      return {.next = state, .refusal = "the tool still moves"};
    }
    if (command == Command::resume && state == State::waiting && !waits_for_answer_.load()) {
      return {.next = state, .refusal = "it waits for no answer"};
    }
    return answer_to(state, command);
  }

  // False: it is another state by now, and `from` says which.
  bool change(State& from, State to) noexcept {
    const State before = from;
    if (!state_.compare_exchange_strong(from, to)) {
      return false;
    }
    changes_.fetch_add(before != to ? 1 : 0);
    return true;
  }
  void change_if(State from, State to) noexcept { change(from, to); }

  void carry_out(Command command) {
    switch (command) {
      case Command::hold:
        kernel_->hold();
        break;
      case Command::resume:
        kernel_->resume();
        break;
      case Command::stop:
        kernel_->stop();
        break;
      case Command::override:
        if (running_.load() != nullptr) {
          kernel_->set_overrides(operator_.overrides);
        }
        break;
      case Command::single_block:
        if (running_.load() != nullptr) {
          kernel_->set_single_block(operator_.single_block);
        }
        break;
      case Command::start:
      case Command::enable:
      case Command::disable:
      case Command::emergency_stop:
      case Command::reset:
        break;
    }
  }

  [[nodiscard]] std::unique_ptr<Kernel> kernel_from_here() const {
    const Setpoint at = snapshot_.read().setpoint;
    KernelOptions options = options_;
    options.start_mm = at.position_mm;
    options.start_extra_rad_mm = at.extra_rad_mm;
    options.one_thread = false;
    options.waits = true;
    auto kernel = std::make_unique<Kernel>(settings_, options);
    if (operator_.overrides != Overrides{}) {
      kernel->set_overrides(operator_.overrides);
    }
    if (operator_.single_block) {
      kernel->set_single_block(true);
    }
    return kernel;
  }

  void start(std::unique_ptr<Kernel> kernel) {
    kernel_ = std::move(kernel);
    run_ticks_ = 0;
    programs_.fetch_add(1);
    running_.store(kernel_.get(), std::memory_order_release);
  }

  void follow(TickStatus status, const Kernel& kernel) noexcept {
    waits_for_answer_.store(status == TickStatus::waiting, std::memory_order_relaxed);
    switch (status) {
      case TickStatus::running:
        change_if(State::waiting, State::running);
        break;
      case TickStatus::starved:
      case TickStatus::waiting:
        change_if(State::running, State::waiting);
        break;
      case TickStatus::held:
        change_if(State::holding, State::held);
        break;
      case TickStatus::finished:
      case TickStatus::failed:
      case TickStatus::emergency_stop:
        end(kernel.has_fault() ? State::fault : State::idle);
        break;
    }
  }

  void end(State next) noexcept {
    running_.store(nullptr, std::memory_order_release);
    State state = state_.load();
    while (state != State::emergency_stop && state != State::fault && !change(state, next)) {
    }
  }

  // Spindle and coolant stay as the program left them, and are off without drives.
  void rest() noexcept {
    last_.v_mm_s = last_.a_mm_s2 = last_.j_mm_s3 = 0.0;
    last_.velocity_mm_s = last_.acceleration_mm_s2 = {};
    last_.limit = Constraint::rest;
    if (!drives_on()) {
      last_.outputs.spindle_rad_s = 0.0;
      last_.outputs.surface = {};
      last_.outputs.mist = last_.outputs.flood = false;
    }
  }

  void publish() noexcept {
    snapshot_.write({.programs = programs_.load(),
                     .run_s = static_cast<double>(run_ticks_.load()) * settings_.limits.period_s,
                     .setpoint = last_});
  }

  MachineSettings settings_;
  KernelOptions options_;
  std::atomic<State> state_ = State::off;
  std::atomic<std::uint64_t> changes_ = 0;
  std::atomic<std::uint64_t> programs_ = 0;
  std::atomic<std::int64_t> run_ticks_ = 0;
  std::atomic<bool> wants_text_ = false;
  std::atomic<bool> waits_for_answer_ = false;
  std::atomic<Kernel*> running_ = nullptr;
  std::unique_ptr<Kernel> kernel_;
  OperatorSettings operator_{};
  control::Snapshot<OperatorSettings> published_;
  // Of the tick side.
  std::int64_t tick_ = 0;
  Setpoint last_{};
  control::Snapshot<ControllerStatus> snapshot_;
};

Controller::Controller(const MachineSettings& settings, const KernelOptions& options)
    : impl_(std::make_unique<Impl>(settings, options).release()) {}
Controller::~Controller() {
  delete impl_;
}

tl::expected<void, Refusal> Controller::give(Command command) {
  return impl_->give(command);
}
tl::expected<void, Refusal> Controller::set_overrides(const Overrides& overrides) {
  return impl_->set_overrides(overrides);
}
tl::expected<void, Refusal> Controller::set_single_block(bool on) {
  return impl_->set_single_block(on);
}
void Controller::feed(std::string_view text) {
  impl_->feed(text);
}
void Controller::finish() {
  impl_->finish();
}
bool Controller::plan() {
  return impl_->plan();
}
void Controller::text_is_late() {
  impl_->text_is_late();
}
const Kernel* Controller::program() const noexcept {
  return impl_->program();
}
ControllerState Controller::tick(Setpoint& setpoint) noexcept {
  return impl_->tick(setpoint);
}
void Controller::emergency_stop() noexcept {
  impl_->leave_for(State::emergency_stop);
}
void Controller::fail() noexcept {
  impl_->leave_for(State::fault);
}
bool Controller::drives_on() const noexcept {
  return impl_->drives_on();
}
ControllerStatus Controller::status() const noexcept {
  return impl_->status();
}

}  // namespace kerf
