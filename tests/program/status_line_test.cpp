#include "programs/kerf/control/status_line.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

ControllerStatus waiting(WaitsFor what, WaitCause cause = WaitCause::none) {
  ControllerStatus status{.state = ControllerState::waiting, .waits_for = what};
  status.wait_cause = cause;
  status.setpoint.line = 3;
  status.setpoint.outputs.tool = 12;
  return status;
}

TEST(StatusLine, SaysStateLineFeedrateAndOverride) {
  ControllerStatus status{.state = ControllerState::running};
  status.setpoint.line = 12;
  status.setpoint.v_mm_s = 20.0;
  EXPECT_EQ(status_line(status), "running   line 12     F1200   100 %");
  status.overrides.feed = 0.5;
  status.single_block = true;
  EXPECT_EQ(status_line(status), "running   line 12     F1200    50 % single block");
}

TEST(StatusLine, SaysWhatItWaitsFor) {
  EXPECT_EQ(status_line(waiting(WaitsFor::answer, WaitCause::tool_change)),
            "waiting   line 3      for tool 12 (M6): Enter goes on 100 %");
  EXPECT_EQ(status_line(waiting(WaitsFor::text)), "waiting   line 3      for text 100 %");
  EXPECT_EQ(status_line(waiting(WaitsFor::planning)), "waiting   line 3      for planning 100 %");
  EXPECT_EQ(status_line(waiting(WaitsFor::machine)), "waiting   line 3      for the machine 100 %");
}

TEST(StatusLine, SaysWhyARunningProgramStands) {
  ControllerStatus status{.state = ControllerState::running};
  status.is_held_by_feed = true;
  status.overrides.feed = 0.0;
  EXPECT_EQ(status_line(status), "running   line 0      stands: the feed is at 0 %   0 %");
  status.overrides.feed = 1.0;
  status.feed_inputs.adaptive = 0.0;
  status.setpoint.outputs.follows_adaptive_feed = true;
  EXPECT_EQ(status_line(status),
            "running   line 0      stands: the machine's feed is at 0 % 100 %");
  status.feed_inputs.stop = true;
  EXPECT_EQ(status_line(status), "running   line 0      stands: the machine stops the feed 100 %");
}

TEST(StatusLine, BlamesNoInputThatDoesNotCountHere) {
  ControllerStatus status{.state = ControllerState::running};
  status.is_held_by_feed = true;
  status.overrides.feed = 0.0;
  status.feed_inputs = {.adaptive = 0.0, .stop = true};
  status.setpoint.outputs.heeds_feed_stop = false;
  EXPECT_EQ(status_line(status), "running   line 0      stands: the feed is at 0 %   0 %");
}

TEST(StatusLine, NamesTheOpenDoorInPlaceOfAKeyThatDoesNothing) {
  ControllerStatus at_stop = waiting(WaitsFor::answer, WaitCause::program_stop);
  at_stop.door_open = true;
  EXPECT_EQ(status_line(at_stop),
            "waiting   line 3      for an operator (program stop, M0): the door is open 100 %");
  ControllerStatus held{.state = ControllerState::held};
  held.door_open = true;
  EXPECT_EQ(status_line(held), "held      line 0      the door is open 100 %");
}

TEST(StatusLine, CallsForAnAnswerByWhatAsksForIt) {
  const auto call = [](WaitCause cause) {
    return call_for_answer(waiting(WaitsFor::answer, cause));
  };
  EXPECT_EQ(call(WaitCause::program_stop),
            "waiting at line 3 for an operator (program stop, M0): Enter goes on");
  EXPECT_EQ(call(WaitCause::optional_stop),
            "waiting at line 3 for an operator (optional stop, M1): Enter goes on");
  EXPECT_EQ(call(WaitCause::pallet_change),
            "waiting at line 3 for the pallet change (M60): Enter goes on");
  EXPECT_EQ(call(WaitCause::tool_change), "waiting at line 3 for tool 12 (M6): Enter goes on");
  EXPECT_EQ(call(WaitCause::block_end),
            "waiting at line 3 after a block (single block): Enter goes on");
  EXPECT_EQ(call(WaitCause::none), "waiting at line 3 for an operator: Enter goes on");
}

}  // namespace
}  // namespace kerf::program
