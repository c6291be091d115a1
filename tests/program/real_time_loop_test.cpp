#include "programs/kerf/run/real_time_loop.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <new>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "machine/simulated_table.hpp"

namespace kerf::program {
namespace {

class WholeText final : public TextFeed {
 public:
  explicit WholeText(std::string text) : text_(std::move(text)) {}
  tl::expected<TextPiece, std::string> read() override {
    return std::exchange(was_read_, true)
               ? TextPiece{}
               : TextPiece{.state = TextPiece::State::text, .bytes = text_};
  }
  [[nodiscard]] double share_read() const noexcept override { return 1.0; }

 private:
  std::string text_;
  bool was_read_ = false;
};

// Of the default machine.
RunOutcome run_on(machine::Machine& machine, Controller& controller, Operator& by, TextFeed& text) {
  const MachineSettings settings = default_machine();
  TickStage ticks({.settings = settings}, machine);
  ticks.enable({});
  Progress progress;
  ControllerPlanning planning(controller);
  Feeder feeder(planning, text, progress);
  Recorder recorder;
  return run_in_real_time(
      {.controller = controller, .by = by, .period_s = settings.limits.period_s},
      {feeder, ticks, recorder, progress});
}

RunOutcome run_on(machine::Machine& machine, Controller& controller, Operator& by,
                  std::string program) {
  WholeText text(std::move(program));
  return run_on(machine, controller, by, text);
}

// A table under which the program is started within a tick, after its setpoint.
class StartedWithinATick final : public machine::Machine {
 public:
  StartedWithinATick(const MachineSettings& settings, Operator& by)
      : table_(settings.table), by_(&by) {}

  void enable(const machine::AxisPlaces& places) noexcept override { table_.enable(places); }
  void disable() noexcept override { table_.disable(); }
  void write(const Setpoint& setpoint) noexcept override {
    table_.write(setpoint);
    if (++writes_ != kStart) {
      return;
    }
    by_->ask(this, [this] { EXPECT_TRUE(by_->give(kerf::Command::start)); });
    for (int i = 0; i < 5000 && !by_->has_started(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  [[nodiscard]] machine::MachineState read() const noexcept override { return table_.read(); }

 private:
  static constexpr int kStart = 20;

  machine::SimulatedTable table_;
  Operator* by_;
  int writes_ = 0;
};

// An emergency stop that cuts the drives: the loop is open, and a drive has tripped.
class CutOff final : public machine::Machine {
 public:
  explicit CutOff(const MachineSettings& settings) : table_(settings.table) {}

  void enable(const machine::AxisPlaces& places) noexcept override { table_.enable(places); }
  void disable() noexcept override { table_.disable(); }
  void write(const Setpoint& setpoint) noexcept override {
    table_.write(setpoint);
    ++writes_;
  }
  [[nodiscard]] machine::MachineState read() const noexcept override {
    machine::MachineState state = table_.read();
    if (writes_ > kCut) {
      state.inputs.emergency_loop_open = true;
      state.fault = machine::DriveFault::drive_tripped;
      state.axes.fill(writes_ > kCut + kBrakes ? machine::AxisState::off
                                               : machine::AxisState::stopping);
    }
    return state;
  }

 private:
  static constexpr int kCut = 200;
  static constexpr int kBrakes = 300;

  machine::SimulatedTable table_;
  int writes_ = 0;
};

// A table that knows where it was switched off.
class SwitchedOffSomewhere final : public machine::Machine {
 public:
  explicit SwitchedOffSomewhere(const MachineSettings& settings) : table_(settings.table) {}

  void enable(const machine::AxisPlaces& places) noexcept override { table_.enable(places); }
  void disable() noexcept override {
    table_.disable();
    last_ = latest_;
  }
  void write(const Setpoint& setpoint) noexcept override {
    table_.write(setpoint);
    latest_ = setpoint;
    ++writes_;
  }
  [[nodiscard]] machine::MachineState read() const noexcept override { return table_.read(); }
  [[nodiscard]] int writes() const noexcept { return writes_; }  // any thread
  [[nodiscard]] const Setpoint& last() const noexcept { return last_; }

 private:
  machine::SimulatedTable table_;
  Setpoint latest_{};
  Setpoint last_{};
  std::atomic<int> writes_ = 0;
};

// Once the tool is in motion memory is used up.
class EndsMemoryInMotion final : public TextFeed {
 public:
  EndsMemoryInMotion(std::string text, const SwitchedOffSomewhere& machine)
      : text_(std::move(text)), machine_(&machine) {}
  tl::expected<TextPiece, std::string> read() override {
    if (!std::exchange(was_read_, true)) {
      return TextPiece{.state = TextPiece::State::text, .bytes = text_};
    }
    if (machine_->writes() > kInMotion) {
      throw std::bad_alloc();
    }
    return TextPiece{.state = TextPiece::State::not_yet};
  }
  [[nodiscard]] double share_read() const noexcept override { return 0.5; }

 private:
  static constexpr int kInMotion = 500;

  std::string text_;
  const SwitchedOffSomewhere* machine_;
  bool was_read_ = false;
};

std::vector<ControllerState> states_told(const Controller& controller) {
  std::array<ControllerEvent, ControllerEvent::kKept> events;
  std::vector<ControllerState> states;
  const std::size_t count = controller.events_since(1, events);
  for (std::size_t i = 0; i < count; ++i) {
    if (events[i].kind == ControllerEvent::Kind::state) {
      states.push_back(events[i].state);
    }
  }
  return states;
}

// Found by reading: each tick was an emergency stop, and then a fault again.
TEST(RealTimeLoop, IsInFaultOnceWhereAnEmergencyStopCutsTheDrives) {
  const MachineSettings settings = default_machine();
  Controller controller(settings, {.asks_machine = true});
  Operator by(controller, true);
  ASSERT_TRUE(by.give(kerf::Command::enable));
  ASSERT_TRUE(by.give(kerf::Command::start));
  CutOff machine(settings);
  run_on(machine, controller, by, "G21 G90 G61 G1 F6000 X200\nM2\n");
  const std::vector<ControllerState> states = states_told(controller);
  EXPECT_EQ(controller.status().state, ControllerState::fault);
  EXPECT_EQ(std::ranges::count(states, ControllerState::fault), 1);
  EXPECT_LE(std::ranges::count(states, ControllerState::emergency_stop), 1);
}

// Found with a client: where memory ended in planning the drives were switched off at full speed.
TEST(RealTimeLoop, ComesToRestOnThePathWherePlanningFails) {
  const MachineSettings settings = default_machine();
  Controller controller(settings, {.asks_machine = true});
  Operator by(controller, true);
  ASSERT_TRUE(by.give(kerf::Command::enable));
  ASSERT_TRUE(by.give(kerf::Command::start));
  SwitchedOffSomewhere machine(settings);
  EndsMemoryInMotion text("G21 G90 G61 G1 F6000 X200\n", machine);
  EXPECT_THROW(run_on(machine, controller, by, text), std::bad_alloc);
  EXPECT_GT(machine.writes(), 1500) << "200 mm at 100 mm/s";
  EXPECT_EQ(machine.last().position_mm[0], 200.0);
  EXPECT_EQ(machine.last().v_mm_s, 0.0);
}

TEST(RealTimeLoop, RunsAProgramThatIsStartedBetweenATickAndItsEnd) {
  const MachineSettings settings = default_machine();
  Controller controller(settings, {.asks_machine = true});
  Operator by(controller, true);
  ASSERT_TRUE(by.give(kerf::Command::enable));
  StartedWithinATick machine(settings, by);
  const RunOutcome outcome = run_on(machine, controller, by, "G21 G90 G61 G1 F600 X0.5\nM2\n");
  EXPECT_FALSE(outcome.hung);
  EXPECT_EQ(controller.status().state, ControllerState::idle);
  EXPECT_EQ(controller.status().setpoint.position_mm[0], 0.5);
}

}  // namespace
}  // namespace kerf::program
