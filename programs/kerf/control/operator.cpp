#include "programs/kerf/control/operator.hpp"

#include <utility>

namespace kerf::program {

void Operator::ask(std::function<void()> order) {
  const std::lock_guard lock(mutex_);
  orders_.push_back(std::move(order));
}

void Operator::drop_orders() {
  const std::lock_guard lock(mutex_);
  orders_.clear();
}

void Operator::carry_out() {
  std::vector<std::function<void()>> orders;
  {
    const std::lock_guard lock(mutex_);
    orders.swap(orders_);
  }
  for (const auto& order : orders) {
    order();
  }
  if (!is_attended_) {
    stop_at_door();
  }
  if (starts_ && controller_->status().state == ControllerState::idle) {
    starts_ = false;
    has_stopped_ = !give(kerf::Command::start);  // the search was stopped
  }
}

void Operator::stop_at_door() {
  const ControllerStatus status = controller_->status();
  const bool goes_on =
      status.state == ControllerState::running || status.state == ControllerState::waiting ||
      status.state == ControllerState::holding || status.state == ControllerState::held;
  if (status.door_open && goes_on) {
    static_cast<void>(give(kerf::Command::stop));  // refused: it has come to its end
  }
}

tl::expected<void, Refusal> Operator::home_and_start() {
  auto given = give(kerf::Command::home);
  starts_ = given.has_value();
  return given;
}

tl::expected<void, Refusal> Operator::give(kerf::Command command) {
  if (command == kerf::Command::stop && !has_started_ &&
      controller_->status().state == ControllerState::idle) {
    has_stopped_ = true;
    return {};
  }
  const ControllerState before = controller_->status().state;
  auto given = controller_->give(command);
  if (given && command == kerf::Command::start) {
    has_started_ = true;
  } else if (given && command == kerf::Command::stop) {
    const bool is_by_hand = before == ControllerState::jogging ||
                            before == ControllerState::returning ||
                            before == ControllerState::homing;
    has_stopped_ = has_stopped_ || !is_by_hand;
  }
  return given;
}

}  // namespace kerf::program
