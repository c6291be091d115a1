#include "programs/kerf/run/real_time_loop.hpp"

#include <chrono>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

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

// A table under which the program is started within a tick, behind its setpoint.
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
    by_->ask([this] { EXPECT_TRUE(by_->give(kerf::Command::start)); });
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

TEST(RealTimeLoop, RunsAProgramThatIsStartedBetweenATickAndItsEnd) {
  const MachineSettings settings = default_machine();
  Controller controller(settings, {.asks_machine = true});
  Operator by(controller, true);
  ASSERT_TRUE(by.give(kerf::Command::enable));
  StartedWithinATick machine(settings, by);
  TickStage ticks({.settings = settings}, machine);
  ticks.enable({});
  WholeText text("G21 G90 G61 G1 F600 X0.5\nM2\n");
  Progress progress;
  ControllerPlanning planning(controller);
  Feeder feeder(planning, text, progress);
  Recorder recorder;
  const RunOutcome outcome =
      run_in_real_time({.controller = controller, .by = by, .period_s = settings.limits.period_s},
                       {feeder, ticks, recorder, progress});
  EXPECT_FALSE(outcome.hung);
  EXPECT_EQ(controller.status().state, ControllerState::idle);
  EXPECT_EQ(controller.status().setpoint.position_mm[0], 0.5);
}

}  // namespace
}  // namespace kerf::program
