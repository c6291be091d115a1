#include "control/state_word.hpp"

#include <gtest/gtest.h>

namespace kerf::control {
namespace {

// Found by reading: the fault was written after its state. A reset between the two was forgotten,
// and the next emergency stop cut the drives of a tool in motion.
TEST(StateWord, HasAFaultAtOnceAndUntilItIsReset) {
  StateWord word;
  StateWord::Seen seen = word.load();
  ASSERT_TRUE(word.change(seen, ControllerState::fault));
  EXPECT_TRUE(word.load().has_failed());

  seen = word.load();
  ASSERT_TRUE(word.change(seen, ControllerState::emergency_stop));
  EXPECT_EQ(word.state(), ControllerState::emergency_stop);
  EXPECT_TRUE(word.load().has_failed());

  seen = word.load();
  ASSERT_TRUE(word.change(seen, ControllerState::off));
  EXPECT_FALSE(word.load().has_failed());
}

TEST(StateWord, IsNotChangedByWhoSawAnEarlierState) {
  StateWord word;
  StateWord::Seen early = word.load();
  for (const ControllerState state : {ControllerState::idle, ControllerState::off}) {
    StateWord::Seen seen = word.load();
    ASSERT_TRUE(word.change(seen, state));
  }
  EXPECT_FALSE(word.change(early, ControllerState::fault));
  EXPECT_EQ(word.state(), ControllerState::off);
  EXPECT_FALSE(word.load().has_failed());
  EXPECT_TRUE(word.change(early, ControllerState::fault));
}

}  // namespace
}  // namespace kerf::control
