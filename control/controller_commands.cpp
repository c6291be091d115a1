// What a controller makes of commands.
#include <utility>

#include "control/controller_impl.hpp"

namespace kerf {

using State = ControllerState;

namespace {

constexpr int kMostNotes = 4;  // of one change: the other side does not change it for ever

// After a resume: the tick side has seen the motion already, or even the next wait.
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
  follow_ticks();
  if (const std::string_view why = door_refusal(command); !why.empty()) {
    return tl::unexpected(Refusal{.state = state_.state(), .command = command, .reason = why});
  }
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
    options_.nominal.reset();
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

tl::expected<void, Refusal> Controller::Impl::set_tool(const Tool& tool) {
  const std::string_view why =
      !is_possible(tool) ? "its number or a length is impossible"
      : settings_.program.tools.find(tool.number) == nullptr ? "the tool table has no such tool"
      : has_program() && kernel_->start_counts_on_tools()
          ? "the start counts on lengths that are known: stop, and start again with this one in "
            "the tool table"
          : "";
  if (!why.empty()) {
    return tl::unexpected(Refusal{.state = state_.state(), .reason = why});
  }
  settings_.program.tools.put(tool);
  options_.checks_travel = true;  // of programs to come, which were checked without it
  if (kernel_) {                  // one that has ended, too: lines begin with what it has left
    kernel_->set_tool(tool);
  }
  return {};
}

bool Controller::Impl::set_feed_inputs(const FeedInputs& inputs) {
  if (!is_possible(inputs)) {
    return false;
  }
  look_at_ticks();
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
  const Answer answer = answer_to(state, command);
  if (!answer.is_accepted()) {
    return answer;
  }
  const auto refuse = [state](std::string_view why) {
    return Answer{.next = state, .refusal = why};
  };
  switch (command) {
    case Command::reset:
      return running_.load() != nullptr ? refuse("the tool still moves") : answer;
    case Command::resume:
      return state == State::waiting && !waits_for_answer_.load() ? refuse("it waits for no answer")
                                                                  : answer;
    case Command::mdi:
    case Command::jog:
      return refuse("it comes with a value");
    case Command::home:
      return home_search_.has_switches() ? answer : refuse("no axis has a home switch");
    case Command::start:
      return needs_homing() ? refuse(control::kNotHomed) : answer;
    default:
      return answer;
  }
}

std::string_view Controller::Impl::door_refusal(Command command) const noexcept {
  const bool moves = command == Command::resume || command == Command::start ||
                     command == Command::mdi || command == Command::jog || command == Command::home;
  return moves && door_open_.load() ? kDoorIsOpen : std::string_view{};
}

// A wait for an answer goes on by resume alone, which is refused.
void Controller::Impl::follow_door() {
  if (!seen_.door_open) {
    return;
  }
  const State state = seen_.state;
  const bool may_go_on =
      state == State::running || (state == State::waiting && !waits_for_answer_.load());
  const bool goes_by_hand = (state == State::jogging || state == State::returning) &&
                            (!manual_.stops || manual_.next);  // a jog that stops, and another
  if (may_go_on || goes_by_hand) {
    static_cast<void>(give(Command::hold));  // refused: it has come to an end meanwhile
  } else if (state == State::homing && !manual_.stops) {
    static_cast<void>(give(Command::stop));
  } else {
    return;
  }
  say(std::string(kDoorIsOpen));
}

bool Controller::Impl::change(control::StateWord::Seen& from, State to) noexcept {
  const State before = from.state();
  if (!state_.change(from, to)) {
    return false;
  }
  if (before == to) {
    return true;
  }
  note_state(to, line_.load());
  State now = state_.state();
  for (int i = 0; now != to && i < kMostNotes; ++i) {
    note_state(to = now, line_.load());
    now = state_.state();
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
    case Command::home:
      home_search_.begin();
      break;
    case Command::override:
    case Command::single_block:
    case Command::optional_stop:
    case Command::block_delete:
      if (has_program()) {
        tell_program(command);
      }
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

// What the operator has set.
void Controller::Impl::tell_program(Command command) {
  if (command == Command::override) {
    kernel_->set_overrides(operator_.overrides);
    spindle_share_ = is_suspended_ ? spindle_share_ : operator_.overrides.spindle;
  } else if (command == Command::single_block) {
    kernel_->set_single_block(operator_.single_block);
  } else if (command == Command::optional_stop) {
    kernel_->set_optional_stop(operator_.optional_stop);
  } else {
    kernel_->set_block_delete(operator_.block_delete);
  }
}

}  // namespace kerf
