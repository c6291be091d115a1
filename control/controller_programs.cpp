// Programs and lines of an operator: how they begin, their text, their plans.
#include <algorithm>
#include <string_view>
#include <utility>

#include "control/controller_impl.hpp"

namespace kerf {

using State = ControllerState;

namespace {

bool is_of_line(const Diagnostic& found) {
  return found.severity == Severity::error && found.source.file == 0;
}

constexpr double kLongestHorizon_s = 3600.0;  // that KernelOptions takes

}  // namespace

tl::expected<void, Refusal> Controller::Impl::run_mdi(std::string_view line) {
  follow_ticks();
  for (auto seen = state_.load();;) {
    const auto refused = [&](std::string_view why) {
      return tl::unexpected(Refusal{.state = seen.state(), .command = Command::mdi, .reason = why});
    };
    if (const Answer answer = answer_to(seen.state(), Command::mdi); !answer.is_accepted()) {
      return refused(answer.refusal);
    }
    if (const std::string_view why = door_refusal(Command::mdi); !why.empty()) {
      return refused(why);
    }
    if (needs_homing()) {
      return refused(control::kNotHomed);
    }
    if (line.find_first_of("\r\n") != std::string_view::npos) {
      return refused("one line is wanted");
    }
    auto kernel = kernel_of_line(line);
    if (kernel->has_errors()) {
      kernel_ = std::move(kernel);
      return tl::unexpected(Refusal{.state = seen.state(),
                                    .command = Command::mdi,
                                    .reason = "the line is wrong",
                                    .of_line = true});
    }
    if (change(seen, State::running)) {
      start(std::move(kernel), Runs::line);
      return {};
    }
  }
}

// What stands after a wait of the line is read only once it is over. So the line is planned
// without any first. A subprogram may go elsewhere by what the machine says: it counts as it runs.
std::unique_ptr<Kernel> Controller::Impl::kernel_of_line(std::string_view line) {
  const auto plan = [line](Kernel& kernel) {
    kernel.feed(line);
    kernel.feed("\n");
    kernel.finish();
    kernel.plan();
  };
  KernelOptions options = options_from_here(Runs::line);
  options.waits = options.asks_machine = options.tells_operator = false;
  options.assumes_contact = true;
  options.horizon_s = kLongestHorizon_s;
  options.plan_log = {};
  options.plan_clock = {};
  auto kernel = std::make_unique<Kernel>(settings_, options);
  plan(*kernel);
  if (!std::ranges::any_of(kernel->diagnostics(), is_of_line)) {
    kernel = kernel_from_here(Runs::line);
    plan(*kernel);
  }
  return kernel;
}

// A program after programs begins as the first one; after lines, with what they left.
KernelOptions Controller::Impl::options_from_here(Runs what) {
  const Setpoint at = rest_as_programmed();
  KernelOptions options = options_;
  if (what == Runs::line || programs_.load() > 0) {
    options.start_in_program.reset();
  }
  hear_out();
  if (kernel_ && (what == Runs::line || ran_line_)) {
    options.begins_with = kernel_->state_left();
    options.start_outputs = at.outputs;
  }
  if (what == Runs::line) {
    options.one_line = true;
    options.checks_travel = true;
    options.nominal.reset();
  }
  options.start_mm = at.position_mm;
  options.start_extra_rad_mm = at.extra_rad_mm;
  options.one_thread = false;
  options.waits = true;
  options.tells_operator = true;
  options.optional_stop = operator_.optional_stop;
  options.block_delete = operator_.block_delete;
  return options;
}

std::unique_ptr<Kernel> Controller::Impl::kernel_from_here(Runs what) {
  auto kernel = std::make_unique<Kernel>(settings_, options_from_here(what));
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
  is_text_late_.store(false, std::memory_order_relaxed);
  wants_text_.store(false, std::memory_order_relaxed);
  ran_line_ = what == Runs::line;
  told_failure_ = false;
  ran_ = true;
  run_ticks_ = 0;
  run_program();
}

void Controller::Impl::run_program() {
  spindle_share_ = operator_.overrides.spindle;
  by_hand_ = false;
  run(*kernel_);
}

// An operator's line is whole: what comes while it runs is of a program that is over.
void Controller::Impl::feed(std::string_view text) {
  is_text_late_.store(false, std::memory_order_relaxed);
  if (has_program() && !ran_line_) {
    kernel_->feed(text);
  }
}

void Controller::Impl::finish() {
  is_text_late_.store(false, std::memory_order_relaxed);
  if (has_program() && !ran_line_) {
    kernel_->finish();
  }
}

bool Controller::Impl::plan() {
  follow_ticks();
  follow_door();
  const bool runs = has_program(seen_.running);
  const bool wants_text = hear_out() && runs;
  ran_ = runs;
  wants_text_.store(wants_text, std::memory_order_relaxed);
  return wants_text;
}

// After its end, too: it may have said something there.
bool Controller::Impl::hear_out() {
  if (!std::exchange(ran_, false)) {
    return false;
  }
  bool wants_text = kernel_->plan();
  if (tell()) {
    wants_text = kernel_->plan();  // it may have waited for that
  }
  tell_failure_of_line();
  return wants_text;
}

bool Controller::Impl::tell() {
  std::vector<ProgramMessage> messages = kernel_->take_messages();
  for (ProgramMessage& message : messages) {
    message.line = ran_line_ ? 0 : message.line;  // an operator's line is none of the program's
    events_.note({.kind = ControllerEvent::Kind::message,
                  .state = state_.state(),
                  .message = messages_.add(message)});
  }
  operator_.left_s = kernel_->left_s();
  // Before its first block those of what ran before are in force.
  if (const std::string_view codes = kernel_->active_codes(); !codes.empty()) {
    operator_.codes = {};
    std::ranges::copy(codes.substr(0, operator_.codes.size()), operator_.codes.begin());
  }
  published_.write(operator_);
  return !messages.empty();
}

// Once it runs: nobody but its operator would hear of it.
void Controller::Impl::tell_failure_of_line() {
  if (!ran_line_ || told_failure_ || !kernel_->has_errors()) {
    return;
  }
  const auto& found = kernel_->diagnostics();
  const auto error = std::ranges::find(found, Severity::error, &Diagnostic::severity);
  told_failure_ = true;
  const std::string place =
      error->file.empty() ? "" : error->file + ":" + std::to_string(error->source.line) + ": ";
  say(place + error->message + " [" + identifier(*error->page) + "]");
}

void Controller::Impl::text_is_late() {
  is_text_late_.store(true, std::memory_order_relaxed);
  if (has_program() && kernel_->runs_low()) {
    kernel_->plan_to_rest();
  }
}

}  // namespace kerf
