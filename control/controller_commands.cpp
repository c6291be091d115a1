// The planning side of a controller: commands, text, plans.
#include <algorithm>
#include <utility>

#include "control/controller_impl.hpp"

namespace kerf {

using State = ControllerState;

namespace {

// Behind a resume: the tick side has seen the motion already, or even the next wait.
bool has_gone_on(State state) noexcept {
  return state == State::running || state == State::waiting;
}

}  // namespace

Controller::Impl::Impl(MachineSettings settings, KernelOptions options)
    : settings_(std::move(settings)), options_(std::move(options)), home_search_(settings_) {
  last_.position_mm = options_.start_mm;
  last_.extra_rad_mm = options_.start_extra_rad_mm;
  operator_.optional_stop = options_.optional_stop;
  operator_.block_delete = options_.block_delete;
  published_.write(operator_);
  publish();
}

tl::expected<void, Refusal> Controller::Impl::give(Command command) {
  follow_manual();
  if (command == Command::resume && is_suspended_ && begin_return()) {
    return {};
  }
  std::unique_ptr<Kernel> next;
  State state = State::off;
  for (bool is_prepared = false;; is_prepared = true) {
    auto seen = state_.load();
    if (is_prepared && command == Command::resume && has_gone_on(seen.state())) {
      return {};
    }
    const Answer answer = answer_now(seen.state(), command);
    if (!answer.is_accepted()) {
      return tl::unexpected(
          Refusal{.state = seen.state(), .command = command, .reason = answer.refusal});
    }
    if (!is_prepared) {
      next = prepare(command);
    }
    state = answer.next;
    if (change(seen, state)) {
      break;
    }
  }
  if (next) {
    programs_.fetch_add(1);
    start(std::move(next), Runs::program);
  } else {
    carry_out(command, state);
  }
  return {};
}

// Before the state says so. Of a resume: else the next tick would find the old wait and say it
// again.
std::unique_ptr<Kernel> Controller::Impl::prepare(Command command) {
  if (command == Command::resume) {
    kernel_->resume();
  }
  return command == Command::start ? kernel_from_here(Runs::program) : nullptr;
}

tl::expected<void, Refusal> Controller::Impl::set_overrides(const Overrides& overrides) {
  if (!is_possible(overrides)) {
    return tl::unexpected(Refusal{.state = state_.state(),
                                  .command = Command::override,
                                  .reason = "an override is out of its range"});
  }
  operator_.overrides = overrides;
  return set(Command::override);
}

tl::expected<void, Refusal> Controller::Impl::set_single_block(bool on) {
  operator_.single_block = on;
  return set(Command::single_block);
}

tl::expected<void, Refusal> Controller::Impl::set_optional_stop(bool on) {
  operator_.optional_stop = on;
  return set(Command::optional_stop);
}

tl::expected<void, Refusal> Controller::Impl::set_block_delete(const BlockDelete& switches) {
  operator_.block_delete = switches;
  return set(Command::block_delete);
}

bool Controller::Impl::set_feed_inputs(const FeedInputs& inputs) {
  if (!is_possible(inputs)) {
    return false;
  }
  operator_.feed_inputs = inputs;
  published_.write(operator_);
  if (has_program()) {
    kernel_->set_feed_inputs(inputs);
  }
  return true;
}

tl::expected<void, Refusal> Controller::Impl::set(Command command) {
  published_.write(operator_);
  return give(command);
}

Answer Controller::Impl::answer_now(State state, Command command) const noexcept {
  if (command == Command::reset && running_.load() != nullptr &&
      answer_to(state, command).is_accepted()) {
    return {.next = state, .refusal = "the tool still moves"};
  }
  if (command == Command::resume && state == State::waiting && !waits_for_answer_.load()) {
    return {.next = state, .refusal = "it waits for no answer"};
  }
  if ((command == Command::mdi || command == Command::jog) &&
      answer_to(state, command).is_accepted()) {
    return {.next = state, .refusal = "it comes with a value"};
  }
  if (command == Command::home && !home_search_.has_switches() &&
      answer_to(state, command).is_accepted()) {
    return {.next = state, .refusal = "no axis has a home switch"};
  }
  if (command == Command::start && needs_homing() && answer_to(state, command).is_accepted()) {
    return {.next = state, .refusal = control::kNotHomed};
  }
  return answer_to(state, command);
}

bool Controller::Impl::change(control::StateWord::Seen& from, State to) noexcept {
  const State before = from.state();
  if (!state_.change(from, to)) {
    return false;
  }
  if (before != to) {
    events_.note({.state = to, .waits_for = waits_for(to), .line = line_.load()});
  }
  return true;
}

void Controller::Impl::carry_out(Command command, State state) {
  switch (command) {
    case Command::hold:
      state == State::holding || state == State::held ? kernel_->hold() : stop_manual();
      break;
    case Command::stop:
      state != State::stopping ? stop_manual() : is_suspended_ ? end_suspended() : kernel_->stop();
      break;
    case Command::override:
      if (has_program()) {
        kernel_->set_overrides(operator_.overrides);
      }
      break;
    case Command::single_block:
      if (has_program()) {
        kernel_->set_single_block(operator_.single_block);
      }
      break;
    case Command::optional_stop:
      if (has_program()) {
        kernel_->set_optional_stop(operator_.optional_stop);
      }
      break;
    case Command::block_delete:
      if (has_program()) {
        kernel_->set_block_delete(operator_.block_delete);
      }
      break;
    case Command::home:
      home_search_.begin();
      break;
    case Command::resume:  // done already
    case Command::start:
    case Command::mdi:
    case Command::jog:
    case Command::enable:
    case Command::disable:
    case Command::emergency_stop:
    case Command::reset:
      break;
  }
}

// A program behind programs begins as the first one; behind lines, with what they left.
std::unique_ptr<Kernel> Controller::Impl::kernel_from_here(Runs what) {
  const Setpoint at = here();
  KernelOptions options = options_;
  if (kernel_ && (what == Runs::line || ran_line_)) {
    kernel_->plan();  // it may not know yet how far the tool has come
    options.begins_with = kernel_->state_left();
    options.start_outputs = at.outputs;
    if (at.outputs.follows_speed_override) {
      options.start_outputs.spindle_rad_s /= operator_.overrides.spindle;
    }
  }
  if (what == Runs::line) {
    options.one_line = true;
    options.checks_travel = true;
    options.nominal_s = 0.0;
  }
  options.start_mm = at.position_mm;
  options.start_extra_rad_mm = at.extra_rad_mm;
  options.one_thread = false;
  options.waits = true;
  options.tells_operator = true;
  options.optional_stop = operator_.optional_stop;
  options.block_delete = operator_.block_delete;
  auto kernel = std::make_unique<Kernel>(settings_, options);
  if (operator_.overrides != Overrides{}) {
    kernel->set_overrides(operator_.overrides);
  }
  if (operator_.feed_inputs != FeedInputs{}) {
    kernel->set_feed_inputs(operator_.feed_inputs);
  }
  if (operator_.single_block) {
    kernel->set_single_block(true);
  }
  return kernel;
}

void Controller::Impl::start(std::unique_ptr<Kernel> kernel, Runs what) {
  kernel_ = std::move(kernel);
  ran_line_ = what == Runs::line;
  run_ticks_ = 0;
  by_hand_ = false;
  running_.store(kernel_.get(), std::memory_order_release);
}

void Controller::Impl::feed(std::string_view text) {
  if (has_program()) {
    kernel_->feed(text);
  }
}

void Controller::Impl::finish() {
  if (has_program()) {
    kernel_->finish();
  }
}

// Once more behind the program's end: it may have said something there.
bool Controller::Impl::plan() {
  follow_manual();
  const bool runs = has_program();
  bool wants_text = false;
  if (runs || ran_) {
    wants_text = kernel_->plan() && runs;
    tell();
  }
  ran_ = runs;
  wants_text_.store(wants_text, std::memory_order_relaxed);
  return wants_text;
}

void Controller::Impl::tell() {
  for (const ProgramMessage& message : kernel_->take_messages()) {
    events_.note({.kind = ControllerEvent::Kind::message,
                  .state = state_.state(),
                  .message = messages_.add(message)});
  }
  operator_.left_s = kernel_->left_s();
  const std::string_view codes = kernel_->active_codes().substr(0, operator_.codes.size());
  operator_.codes = {};
  std::ranges::copy(codes, operator_.codes.begin());
  published_.write(operator_);
}

void Controller::Impl::text_is_late() {
  if (has_program() && kernel_->runs_low()) {
    kernel_->plan_to_rest();
  }
}

}  // namespace kerf
