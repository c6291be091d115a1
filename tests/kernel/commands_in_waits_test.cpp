// Waits under commands, while ticks go on within the planning, so that plans that are to take over
// are refused now and then.
#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

// Ticks go on at every eighth look that the planning takes at them.
class Ticks {
 public:
  explicit Ticks(unsigned seed) : random_(seed) {}

  [[nodiscard]] int one_of(int count) { return static_cast<int>(random_() >> 1U) % count; }
  // Precondition of what ticks: a kernel.
  void of(Kernel& kernel) { kernel_ = &kernel; }
  TickStatus tick() {
    status_ = kernel_->tick(setpoint_);
    EXPECT_TRUE(kernel_->fault() == std::nullopt);
    return status_;
  }
  [[nodiscard]] KernelOptions options() {
    KernelOptions options{.waits = true};
    options.plan_clock = [this](std::int64_t /*ticks*/) {
      for (int i = kernel_ != nullptr && one_of(8) == 0 ? one_of(40) : 0;
           i > 0 && status_ == TickStatus::running; --i) {
        tick();
      }
      return true;
    };
    return options;
  }
  [[nodiscard]] TickStatus status() const { return status_; }
  [[nodiscard]] const Setpoint& setpoint() const { return setpoint_; }

 private:
  std::mt19937 random_;
  Kernel* kernel_ = nullptr;
  Setpoint setpoint_;
  TickStatus status_ = TickStatus::running;
};

// The lines that were waited behind. Overrides come in motion, at the most `most` of them.
std::vector<std::uint32_t> waits_under_overrides(const std::string& text, Ticks& ticks) {
  Kernel kernel(mill(), ticks.options());
  kernel.set_single_block(true);
  kernel.feed(text);
  kernel.finish();
  kernel.plan();
  ticks.of(kernel);
  std::vector<std::uint32_t> lines;
  int waited = 0;
  for (std::int64_t call = 0; call < kMaxTicks && ticks.status() != TickStatus::finished; ++call) {
    kernel.plan();
    waited = ticks.status() == TickStatus::waiting ? waited + 1 : 0;
    if (waited == 1) {
      lines.push_back(ticks.setpoint().line);
    } else if (waited == 5) {
      kernel.resume();
    } else if (waited == 0 && ticks.one_of(6) == 0) {
      kernel.set_overrides({.feed = 0.5 + 0.5 * ticks.one_of(3)});
    }
    ticks.tick();
  }
  EXPECT_EQ(ticks.status(), TickStatus::finished);
  return lines;
}

// Found with a client: an override in the last milliseconds before a block's end took its wait
// away.
TEST(CommandsInWaits, OverridesLeaveTheWaitBehindEachBlockInSingleBlock) {
  for (unsigned seed = 105; seed <= 140; ++seed) {
    Ticks ticks(seed);
    EXPECT_EQ(waits_under_overrides(
                  "G21 G90 G61 F3000\nG2 X10 R6\nG1 X14\nG3 X20 R4\nG2 X24 R3\nG1 Y3\nM2\n", ticks),
              (std::vector<std::uint32_t>{2, 3, 4, 5, 6}))
        << "seed " << seed;
  }
}

// Found with a client: where a plan that had the wait in it was refused, its number was another one
// than that of the tick side, and the hold was never said to be there.
TEST(CommandsInWaits, AHoldAtAWaitIsHeldWhateverWasRefusedBefore) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Ticks ticks(seed);
    Kernel kernel(mill(), ticks.options());
    kernel.feed("G21 G90 G61 F3000\nG1 X10\nM0\nG1 X14\nM2\n");
    kernel.finish();
    kernel.plan();
    ticks.of(kernel);
    int waited = 0;
    for (; waited < 80; waited = ticks.tick() == TickStatus::waiting ? waited + 1 : 0) {
      kernel.plan();
      if (waited == 0 && ticks.one_of(8) == 0) {
        kernel.set_overrides({.feed = 0.5 + 0.5 * ticks.one_of(3)});
      }
    }
    kernel.hold();
    for (int i = 0; i < 10; ++i) {
      kernel.plan();
      ticks.tick();
    }
    EXPECT_EQ(ticks.status(), TickStatus::held);
    kernel.resume();
    EXPECT_EQ(ticks.tick(), TickStatus::waiting);
    kernel.resume();
    for (int i = 0; i < 5000 && ticks.status() != TickStatus::finished; ++i) {
      kernel.plan();
      ticks.tick();
    }
    EXPECT_EQ(ticks.status(), TickStatus::finished);
    EXPECT_EQ(ticks.setpoint().position_mm[0], 14.0);
  }
}

// Found with a client: the rest of a curve that stands for several lines has the line of where it
// begins, and was taken for another block.
TEST(CommandsInWaits, AHoldInSingleBlockIsNoEndOfACurveThatStandsForSeveralLines) {
  const std::string text =
      "G21 G90 G64 P0.02 Q0.02 F3000\nG1 X1 Y0.01\nX2 Y0\nX3 Y0.01\nX4 Y0\nX5 Y0.01\nX6 Y0\n"
      "X7 Y0\nX8 Y0.01\nG1 X20\nM2\n";
  for (std::int64_t hold = 40; hold < 240; hold += 10) {
    for (const bool is_early : {true, false}) {
      SCOPED_TRACE("hold at " + std::to_string(hold) + (is_early ? ", on before" : ", on in it"));
      int waits = 0;
      const WatchedRun run =
          run_ticks({.text = text, .options = {.waits = true}},
                    [&](Kernel& kernel, const WatchedRun& ran, Setpoint& setpoint) {
                      kernel.plan();
                      if (ran.next() == (is_early ? 30 : hold + 100)) {
                        kernel.set_single_block(true);
                      } else if (ran.next() == hold) {
                        kernel.hold();
                      } else if (ran.next() == hold + 200) {
                        kernel.resume();
                      } else if (ran.next() > hold + 200 && ran.next() % 50 == 0 &&
                                 ran.statuses.back() == TickStatus::waiting) {
                        ++waits;
                        kernel.resume();
                      }
                      return kernel.tick(setpoint);
                    });
      ASSERT_EQ(run.complaint, "");
      EXPECT_GE(waits, 1);
    }
  }
}

// Forty ticks come at one of the looks that the planning takes at them. After the second one a
// plan for the command is made, which is handed over at the fourth: it is refused.
class LateCommand {
 public:
  explicit LateCommand(int look) : looks_(look) {}

  [[nodiscard]] KernelOptions options() {
    KernelOptions options;
    options.plan_clock = [this](std::int64_t /*ticks*/) {
      if (is_late_ && looks_-- == 0) {
        for (int i = 0; i < 40; ++i) {
          kernel_->tick(setpoint_);
        }
      }
      return true;
    };
    return options;
  }
  void give(Kernel& kernel, const std::function<void()>& command) {
    kernel_ = &kernel;
    is_late_ = true;
    command();
    is_late_ = false;
  }

 private:
  Kernel* kernel_ = nullptr;
  Setpoint setpoint_{};
  int looks_ = 0;
  bool is_late_ = false;
};

// Found by reading: what was emitted before the plan that was refused was cut, and nobody asked for
// another plan.
TEST(CommandsInWaits, AHoldThatIsLateAndTakenBackLeavesNoRest) {
  using Commands = std::function<void(Kernel&, bool begins)>;
  const std::vector<Commands> commands{
      [](Kernel& kernel, bool begins) { begins ? kernel.hold() : kernel.resume(); },
      [](Kernel& kernel, bool begins) { kernel.set_overrides({.feed = begins ? 0.0 : 1.0}); },
  };
  for (std::size_t i = 0; i < commands.size(); ++i) {
    for (const int look : {2, 3}) {
      SCOPED_TRACE(std::to_string(i) + ", look " + std::to_string(look));
      constexpr std::int64_t kAt = 400;
      LateCommand late(look);
      const WatchedRun run =
          run_ticks({.text = "G21 G90 G61 F6000\nG1 X200\nM2\n", .options = late.options()},
                    [&](Kernel& kernel, const WatchedRun& ran, Setpoint& setpoint) {
                      kernel.plan();
                      if (ran.next() == kAt) {
                        late.give(kernel, [&] { commands[i](kernel, true); });
                        commands[i](kernel, false);
                      }
                      return kernel.tick(setpoint);
                    });
      EXPECT_EQ(run.ticks.back().position_mm[0], 200.0);
      for (const Setpoint& at : run.ticks) {
        if (at.s_mm > 1.0 && at.s_mm < 199.0) {
          ASSERT_GT(at.v_mm_s, 0.0) << at.s_mm;
        }
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
