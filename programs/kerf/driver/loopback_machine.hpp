// A machine in another process.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "machine/machine.hpp"
#include "machine/setpoint_gate.hpp"
#include "programs/kerf/driver/frame_socket.hpp"

namespace kerf::program {

// Sends a told frame at each call and takes the answers that have come by then, so it knows the
// machine as it was a period ago. docs/machine-interface.md says what the other end owes.
//
// Where answers lag by more than the time-out, or one is none, the fault leaves the axes on: the
// run comes to rest on the path. Where an axis is farther from its setpoint than its following
// error may be, the machine is told to switch off. Where nothing answers for a time-out more, the
// machine is told to switch off and the connection is closed; so it is where a setpoint is refused.
class LoopbackMachine final : public machine::Machine {
 public:
  struct Order {
    std::string socket;  // the path of one that somebody listens at, SOCK_SEQPACKET
    double timeout_s = 0.1;
    const TableSettings& table;  // its travel, period and largest following errors
  };
  static constexpr int kMaxPeriods = 200;  // of a time-out: what the socket surely takes

  // Connects, tells the machine to be off, and waits for its answer, a second or the time-out.
  // Error: why there is none, with the path.
  static tl::expected<std::unique_ptr<LoopbackMachine>, std::string> open(const Order& order);

  void enable(const machine::AxisPlaces& places) noexcept override;
  void disable() noexcept override;
  void set_unhomed(machine::AxisBits axes) noexcept override { gate_.set_unhomed(axes); }
  void write(const machine::Setpoint& setpoint) noexcept override;
  [[nodiscard]] machine::MachineState read() const noexcept override { return state_; }
  [[nodiscard]] bool has_answered(std::int64_t tick) const noexcept override {
    return is_over_ || answered_tick_ >= tick;
  }

 private:
  LoopbackMachine(FrameSocket socket, const Order& order) noexcept;

  struct Told {
    std::int64_t tick = 0;
    std::optional<Position> place_mm{};  // where the axes are to be
    bool is_setpoint = false;            // to which they are on
    bool is_forgotten = false;
  };
  // What was told and not answered yet, the oldest first.
  class Pending {
   public:
    void add(const Told& told) noexcept;
    // This answer has come, and with it those before. Nothing: nothing of that tick waits.
    [[nodiscard]] std::optional<Told> answer(std::int64_t tick) noexcept;
    // What waits now is of no interest any more.
    void forget() noexcept { forgotten_ = count_; }
    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] bool is_full() const noexcept { return count_ == told_.size(); }

   private:
    std::array<Told, 512> told_{};  // a ring
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::size_t forgotten_ = 0;  // of count_, the oldest
  };

  void tell(const ToldFrame& told) noexcept;
  void take_answers() noexcept;
  void take(const machine::MachineState& answer) noexcept;
  // Against what the answer is to: whatever the machine says of itself.
  void judge_place(const Told& told) noexcept;
  void judge_delay() noexcept;
  // The axes stay on: setpoints still count.
  void note(machine::DriveFault fault) noexcept;
  void stop(machine::SetpointGate::Refusal why) noexcept;
  void hang_up(machine::DriveFault fault) noexcept;
  [[nodiscard]] bool follows() const noexcept;

  FrameSocket socket_;
  machine::SetpointGate gate_;
  Position max_following_error_mm_{};
  std::size_t timeout_periods_;
  Pending pending_;
  std::int64_t answered_tick_ = -1;
  bool is_over_ = false;     // the connection
  bool is_disabled_ = true;  // the last thing that was told
  machine::MachineState state_{.fault = machine::DriveFault::not_enabled};
};

}  // namespace kerf::program
