// What people and programs ask of a machine that runs.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

#include <kerf/controller.hpp>

namespace kerf::program {

// The orders of all of them, in the order in which they came. The thread that plans carries them
// out; the emergency stop is done at once, by whoever asks.
class Operator {
 public:
  // is_attended: somebody can let a program go on. Else an open door stops it.
  Operator(Controller& controller, bool is_attended) noexcept
      : controller_(&controller), is_attended_(is_attended) {}

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
  // Behind the search for the home switches; where that is refused or stopped, no program runs.
  tl::expected<void, Refusal> home_and_start();

  // Any thread. Somebody stopped the program, or what comes before it.
  [[nodiscard]] bool has_stopped() const noexcept { return has_stopped_; }
  [[nodiscard]] bool has_started() const noexcept { return has_started_; }

 private:
  void stop_at_door();

  Controller* controller_;
  bool is_attended_;
  bool starts_ = false;  // once it is idle
  std::atomic<bool> has_started_ = false;
  std::atomic<bool> has_stopped_ = false;
  std::mutex mutex_;
  std::vector<std::function<void()>> orders_;
};

}  // namespace kerf::program
