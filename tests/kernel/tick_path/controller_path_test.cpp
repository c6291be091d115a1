// The same of a controller's tick, while an operator gives commands.
#include <array>
#include <cstddef>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_path/trap.hpp"

namespace kerf::test {
namespace {

// A message, the way back after a program that was stopped, a wait, and all that the mixed program
// has.
std::string text_with_waits() {
  return "(MSG, begins)\nG21 G90 G0 X0 Y0 Z0\nM0\n" + mixed_program();
}

// One command every 70 ticks, over and over: braking and after it, in waits and in motion.
void command(Controller& controller, int i) {
  constexpr int kBetween = 70;
  if (i % kBetween != 0) {
    return;
  }
  switch (i / kBetween % 10) {
    case 1:
      static_cast<void>(controller.set_overrides({.feed = 0.3, .rapid = 0.5, .spindle = 1.2}));
      break;
    case 2:
    case 6:
      static_cast<void>(controller.give(Command::hold));
      break;
    case 3:
    case 4:
    case 8:
      static_cast<void>(controller.give(Command::resume));
      break;
    case 5:
      static_cast<void>(controller.set_overrides({.feed = 2.0}));
      break;
    case 7:
    case 9:
      static_cast<void>(controller.set_single_block(i / kBetween % 10 == 7));
      break;
    default:
      static_cast<void>(controller.set_overrides({}));
  }
}

TEST(ControllerTickPath, IsQuietUnderAnOperatorsCommands) {
  if (KERF_TRAP_WORKS == 0) {
    GTEST_SKIP() << "a sanitizer has a malloc of its own, which cannot be trapped";
  }
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    SCOPED_TRACE(name_of(kind));
    Controller controller(mill(), {.profile = {.kind = kind}});
    ASSERT_TRUE(controller.give(Command::enable));
    std::set<ControllerState> seen;
    Setpoint setpoint;
    // The second program is stopped, the third ends in an emergency stop.
    for (const Command end : {Command::start, Command::stop, Command::emergency_stop}) {
      ASSERT_TRUE(controller.give(Command::start));
      controller.feed(text_with_waits());
      controller.finish();
      ControllerState state = ControllerState::running;
      const auto tick = [&] {
        controller.plan();
        {
          const Trap trap;
          state = controller.tick(setpoint);
        }
        ASSERT_EQ(Trap::counts().total(), 0) << "tick " << setpoint.tick;
        seen.insert(state);
      };
      for (int i = 0; i < 60'000 && (i < 100 || state != ControllerState::idle); ++i) {
        command(controller, i);
        if (i == 2500 && end != Command::start) {
          static_cast<void>(controller.give(Command::resume));
          ASSERT_TRUE(controller.give(end));
        }
        tick();
        ASSERT_FALSE(HasFatalFailure());
        if (state == ControllerState::emergency_stop && setpoint.v_mm_s == 0.0) {
          break;
        }
      }
    }
    for (const auto state :
         {ControllerState::running, ControllerState::waiting, ControllerState::holding,
          ControllerState::held, ControllerState::stopping, ControllerState::idle,
          ControllerState::emergency_stop}) {
      EXPECT_TRUE(seen.contains(state)) << name_of(state);
    }
  }
}

}  // namespace
}  // namespace kerf::test
