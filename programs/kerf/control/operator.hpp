// What people and programs ask of a machine that runs.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string_view>
#include <vector>

#include <kerf/controller.hpp>

#include "machine/inputs.hpp"
#include "programs/kerf/control/operator_order.hpp"
#include "programs/kerf/control/plan_pace.hpp"

namespace kerf::program {

// The orders of all of them, in the order in which they came. The thread that plans carries them
// out; the emergency stop is done at once, by whoever asks.
class Operator {
 public:
  // is_attended: somebody can let a program go on. Else an open door stops it. pace: notes what is
  // carried out, or says it, and then nobody else is heard; null: neither. followed: what of hear()
  // counts.
  Operator(Controller& controller, bool is_attended, PlanPace* pace = nullptr,
           const FeedInputNumbers& followed = {}) noexcept
      : controller_(&controller),
        pace_(pace),
        is_attended_(is_attended),
        input_numbers_(followed) {}

  // Any thread. asker: who may drop it.
  void ask(const void* asker, std::function<void()> order);
  void emergency_stop() noexcept {
    has_emergency_ = true;
    controller_->emergency_stop();
  }
  [[nodiscard]] bool has_emergency() const noexcept { return has_emergency_; }
  [[nodiscard]] ControllerStatus status() const noexcept { return controller_->status(); }
  // For what it says.
  [[nodiscard]] const Controller& controller() const noexcept { return *controller_; }

  // What the machine says before the first tick. Nobody else gives an order yet.
  void begin_with(const machine::MachineInputs& inputs);
  // The same of each tick. The thread of the ticks; real time.
  void hear(const machine::MachineInputs& inputs) noexcept;

  // Who asked is going: none of its orders is carried out any more. In the thread that plans, or
  // once that has ended.
  void drop_orders(const void* asker);

  // In the thread that plans, as all below.
  void carry_out();
  tl::expected<void, Refusal> give(const OperatorOrder& order);
  // After the search for the home switches; where that is refused or stopped, no program runs.
  tl::expected<void, Refusal> home_and_start();
  // The run ends, program or not: nothing begins to move any more.
  void end_run() noexcept;

  // Any thread. Somebody stopped the program, or what comes before it.
  [[nodiscard]] bool has_stopped() const noexcept { return has_stopped_; }
  [[nodiscard]] bool has_started() const noexcept { return has_started_; }
  // The machine's door was opened, and the program stopped, for nobody could let it go on.
  [[nodiscard]] bool has_door_stopped() const noexcept { return has_door_stopped_; }
  // What somebody changed first that the program by itself does not know, in words; null: nothing.
  [[nodiscard]] const char* first_change() const noexcept { return first_change_; }

 private:
  tl::expected<void, Refusal> execute(const OperatorOrder& order);
  tl::expected<void, Refusal> execute(kerf::Command command);
  // Why nothing begins now; empty: it may. A run has one program, and is over once that is.
  [[nodiscard]] std::string_view refusal_to_begin() const noexcept;
  void carry_out_what_was_asked();
  void carry_out_once_more();
  void stop_at_door(const ControllerStatus& status);
  void follow_machine();
  // The program, once the search for the home switches has come to its end.
  void start_behind_search();
  tl::expected<void, Refusal> note_stop(const tl::expected<void, Refusal>& given);
  tl::expected<void, Refusal> note_change(const char* what, tl::expected<void, Refusal> given);

  Controller* controller_;
  PlanPace* pace_;
  bool is_attended_;
  FeedInputNumbers input_numbers_;
  std::atomic<double> adaptive_heard_ = 1.0;
  std::atomic<bool> feed_stop_heard_ = false;
  FeedInputs told_{};
  bool starts_ = false;    // once it is idle
  bool ends_ = false;      // end_run()
  bool is_asked_ = false;  // what is given now
  std::atomic<bool> has_emergency_ = false;
  std::atomic<bool> has_started_ = false;
  std::atomic<bool> has_stopped_ = false;
  std::atomic<bool> has_door_stopped_ = false;
  std::atomic<const char*> first_change_ = nullptr;
  std::mutex mutex_;
  struct Asked {
    const void* asker = nullptr;
    std::function<void()> order;
  };
  std::vector<Asked> orders_;
};

}  // namespace kerf::program
