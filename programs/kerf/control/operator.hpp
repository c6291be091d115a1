// What people and programs ask of a machine that runs.
#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include <kerf/controller.hpp>

namespace kerf::program {

// The orders of all of them, in the order in which they came. The thread that plans carries them
// out; the emergency stop is done at once, by whoever asks.
class Operator {
 public:
  explicit Operator(Controller& controller) noexcept : controller_(&controller) {}

  // Any thread.
  void ask(std::function<void()> order);
  void emergency_stop() noexcept { controller_->emergency_stop(); }
  [[nodiscard]] ControllerStatus status() const noexcept { return controller_->status(); }
  // For what is no command without a value; its threads are the same.
  [[nodiscard]] Controller& controller() const noexcept { return *controller_; }

  // No more are carried out: who asked is going.
  void drop_orders();

  // In the thread that plans, as all below.
  void carry_out();
  tl::expected<void, Refusal> give(kerf::Command command);
  // Somebody stopped the program. Also once no thread plans any more.
  [[nodiscard]] bool has_stopped() const noexcept { return has_stopped_; }

 private:
  Controller* controller_;
  bool has_stopped_ = false;
  std::mutex mutex_;
  std::vector<std::function<void()>> orders_;
};

}  // namespace kerf::program
