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
}

tl::expected<void, Refusal> Operator::give(kerf::Command command) {
  auto given = controller_->give(command);
  has_stopped_ = has_stopped_ || (given && command == kerf::Command::stop);
  return given;
}

}  // namespace kerf::program
