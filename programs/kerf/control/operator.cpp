#include "programs/kerf/control/operator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::program {

namespace {

// An analog input is never still: a smaller change of the share is not followed.
constexpr double kLeastChangeOfShare = 0.005;

bool is_another_share(double said, double followed) noexcept {
  const bool is_end = said == 0.0 || said == 1.0;
  return said != followed && (is_end || std::abs(said - followed) >= kLeastChangeOfShare);
}

}  // namespace

void Operator::ask(const void* asker, std::function<void()> order) {
  const std::lock_guard lock(mutex_);
  orders_.push_back({asker, std::move(order)});
}

void Operator::drop_orders(const void* asker) {
  const std::lock_guard lock(mutex_);
  std::erase_if(orders_, [asker](const Asked& one) { return one.asker == asker; });
}

void Operator::carry_out() {
  ControllerStatus seen = controller_->status();
  while (pace_ != nullptr && !pace_->look(seen.setpoint.tick)) {
    seen = controller_->status();
  }
  if (pace_ != nullptr && pace_->is_repeated()) {
    carry_out_once_more();
  } else {
    follow_machine();
    carry_out_what_was_asked();
  }
  if (!is_attended_) {
    stop_at_door(seen);
  }
  start_behind_search();
}

void Operator::start_behind_search() {
  const ControllerStatus status = controller_->status();
  if (!starts_ || (status.state != ControllerState::idle && !status.door_open)) {
    return;
  }
  starts_ = false;
  const bool is_homed = !status.door_open && status.unhomed == 0;
  has_stopped_ = !is_homed || !execute(kerf::Command::start);
}

void Operator::carry_out_what_was_asked() {
  std::vector<Asked> orders;
  {
    const std::lock_guard lock(mutex_);
    orders.swap(orders_);
  }
  is_asked_ = true;
  for (const Asked& one : orders) {
    one.order();
  }
  is_asked_ = false;
}

// What was refused then is refused again.
void Operator::carry_out_once_more() {
  while (const auto text = pace_->next_order()) {
    if (const auto order = order_from(*text)) {
      static_cast<void>(execute(*order));
    }
  }
}

void Operator::stop_at_door(const ControllerStatus& status) {
  const bool goes_on =
      status.state == ControllerState::running || status.state == ControllerState::waiting ||
      status.state == ControllerState::holding || status.state == ControllerState::held;
  if (status.door_open && goes_on) {
    const bool stops = execute(kerf::Command::stop).has_value();  // else it has come to its end
    has_door_stopped_ = has_door_stopped_ || stops;
  }
}

// A record has what followed from it.
void Operator::begin_with(const machine::MachineInputs& inputs) {
  controller_->set_door(inputs.door_open);
  hear(inputs);
  if (pace_ != nullptr && pace_->is_repeated()) {
    carry_out_once_more();
  } else {
    follow_machine();
  }
}

void Operator::hear(const machine::MachineInputs& inputs) noexcept {
  if (const auto number = input_numbers_.adaptive_feed) {
    const double share = inputs.analog[static_cast<std::size_t>(*number)];
    adaptive_heard_ = share > 0.0 ? std::min(share, 1.0) : 0.0;  // 0 of what is not a number, too
  }
  if (const auto number = input_numbers_.feed_stop) {
    feed_stop_heard_ = (inputs.digital >> static_cast<unsigned>(*number) & 1U) != 0;
  }
}

void Operator::follow_machine() {
  const FeedInputs said{.adaptive = adaptive_heard_, .stop = feed_stop_heard_};
  if (!is_another_share(said.adaptive, told_.adaptive) && said.stop == told_.stop) {
    return;
  }
  told_ = said;
  is_asked_ = true;
  static_cast<void>(give(said));  // within its range: not refused
  is_asked_ = false;
}

tl::expected<void, Refusal> Operator::home_and_start() {
  auto given = execute(kerf::Command::home);
  starts_ = given.has_value();
  return given;
}

tl::expected<void, Refusal> Operator::give(const OperatorOrder& order) {
  if (is_asked_ && pace_ != nullptr) {
    pace_->note(text_of(order));
  }
  return execute(order);
}

void Operator::end_run() noexcept {
  ends_ = true;
  starts_ = false;
  has_stopped_ = true;
}

std::string_view Operator::refusal_to_begin() const noexcept {
  const bool is_over =
      (has_started_ || has_stopped_) && controller_->status().state == ControllerState::idle;
  return ends_ ? "the run ends" : is_over ? "the run is over" : "";
}

tl::expected<void, Refusal> Operator::execute(const OperatorOrder& order) {
  struct Execute {
    Operator& by;
    Controller& controller;
    tl::expected<void, Refusal> operator()(kerf::Command of) const { return by.execute(of); }
    tl::expected<void, Refusal> operator()(const Overrides& of) const {
      return controller.set_overrides(of);
    }
    tl::expected<void, Refusal> operator()(SingleBlock of) const {
      return controller.set_single_block(of.is_on);
    }
    tl::expected<void, Refusal> operator()(OptionalStop of) const {
      return controller.set_optional_stop(of.is_on);
    }
    tl::expected<void, Refusal> operator()(const BlockDelete& of) const {
      return by.note_change("block delete was switched", controller.set_block_delete(of));
    }
    tl::expected<void, Refusal> operator()(const FeedInputs& of) const {
      if (controller.set_feed_inputs(of)) {
        return {};
      }
      return tl::unexpected(
          Refusal{.state = controller.status().state, .reason = "value is to be 0 to 1"});
    }
    tl::expected<void, Refusal> operator()(const Tool& of) const {
      return by.note_change("an operator gave a tool's length", controller.set_tool(of));
    }
    tl::expected<void, Refusal> operator()(const Jog& of) const { return controller.jog(of); }
    tl::expected<void, Refusal> operator()(const MdiLine& of) const {
      return by.note_change("an operator's line was run", controller.run_mdi(of.text));
    }
  };
  const auto* command = std::get_if<kerf::Command>(&order);
  const bool begins =
      std::holds_alternative<Jog>(order) || std::holds_alternative<MdiLine>(order) ||
      (command != nullptr && (*command == kerf::Command::start || *command == kerf::Command::home));
  if (const std::string_view why = refusal_to_begin(); begins && !why.empty()) {
    return tl::unexpected(Refusal{.state = controller_->status().state, .reason = why});
  }
  return std::visit(Execute{*this, *controller_}, order);
}

// By what it found: a move by hand may have been over, and the program have gone on.
tl::expected<void, Refusal> Operator::note_stop(const tl::expected<void, Refusal>& given) {
  using State = ControllerState;
  const State now = controller_->status().state;
  // Before the program it is a line or a move by hand that ends.
  const bool stops_by_hand = !has_started_ || now == State::jogging || now == State::returning ||
                             now == State::homing || now == State::held;
  const bool stops_program = (given && !stops_by_hand) || std::exchange(starts_, false);
  has_stopped_ = has_stopped_ || stops_program;
  return stops_program ? tl::expected<void, Refusal>{} : given;
}

tl::expected<void, Refusal> Operator::note_change(const char* what,
                                                  tl::expected<void, Refusal> given) {
  if (given && first_change_ == nullptr) {
    first_change_ = what;
  }
  return given;
}

tl::expected<void, Refusal> Operator::execute(kerf::Command command) {
  if (command == kerf::Command::stop && !has_started_ &&
      controller_->status().state == ControllerState::idle) {
    has_stopped_ = true;
    return {};
  }
  auto given = controller_->give(command);
  if (command == kerf::Command::stop) {
    return note_stop(given);
  }
  has_started_ = has_started_ || (given && command == kerf::Command::start);
  return given;
}

}  // namespace kerf::program
