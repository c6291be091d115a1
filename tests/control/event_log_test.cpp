// Events of several threads, read by others, without a lock.
#include "control/event_log.hpp"

#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "control/messages.hpp"

namespace kerf::control {
namespace {

using Kind = ControllerEvent::Kind;

TEST(EventLog, GivesEventsBackInTheirOrder) {
  const auto log = std::make_unique<EventLog>();
  log->note({.state = ControllerState::held, .line = 4'000'000'000});
  log->note({.state = ControllerState::waiting, .waits_for = WaitsFor::planning, .line = 7});
  log->note({.kind = Kind::message, .state = ControllerState::running, .message = 12});
  log->note({.state = ControllerState::waiting,
             .waits_for = WaitsFor::answer,
             .wait_cause = WaitCause::block_end,
             .line = 8});
  EXPECT_EQ(log->next_number(), 5);
  std::array<ControllerEvent, 8> events;
  ASSERT_EQ(log->since(0, events), 4);
  EXPECT_EQ(events[0].number, 1);
  EXPECT_EQ(events[0].state, ControllerState::held);
  EXPECT_EQ(events[0].line, 4'000'000'000);
  EXPECT_EQ(events[1].waits_for, WaitsFor::planning);
  EXPECT_EQ(events[2].kind, Kind::message);
  EXPECT_EQ(events[1].wait_cause, WaitCause::none);
  EXPECT_EQ(events[2].message, 12);
  EXPECT_EQ(events[3].kind, Kind::state);
  EXPECT_EQ(events[3].waits_for, WaitsFor::answer);
  EXPECT_EQ(events[3].wait_cause, WaitCause::block_end);
  EXPECT_EQ(events[3].line, 8);
  ASSERT_EQ(log->since(3, events), 2);
  EXPECT_EQ(events[0].number, 3);
  EXPECT_EQ(log->since(5, events), 0);
}

TEST(EventLog, ForgetsTheOldestAndGivesNoMoreThanThereIsRoomFor) {
  const auto log = std::make_unique<EventLog>();
  constexpr std::uint32_t kEvents = 5000;
  for (std::uint32_t i = 1; i <= kEvents; ++i) {
    log->note({.line = i});
  }
  std::vector<ControllerEvent> events(ControllerEvent::kKept + 44);
  ASSERT_EQ(log->since(1, events), ControllerEvent::kKept);
  EXPECT_EQ(events[0].line, kEvents + 1 - ControllerEvent::kKept);
  ASSERT_EQ(log->since(kEvents - 10, std::span(events).first(4)), 4);
  EXPECT_EQ(events[3].line, kEvents - 7);
}

TEST(EventLog, IsNeverReadTorn) {
  constexpr std::uint32_t kEvents = 50'000;
  const auto log = std::make_unique<EventLog>();
  std::vector<std::thread> writers;
  for (const ControllerState state : {ControllerState::held, ControllerState::running}) {
    writers.emplace_back([&log, state] {
      for (std::uint32_t i = 0; i < kEvents; ++i) {
        log->note({.state = state, .line = 2 * i + (state == ControllerState::held ? 1U : 0U)});
      }
    });
  }
  std::uint64_t next = 1;
  std::uint64_t read = 0;
  while (next <= 2 * kEvents) {
    std::array<ControllerEvent, 64> events;
    const std::size_t found = log->since(next, events);
    for (std::size_t i = 0; i < found; ++i) {
      ASSERT_GE(events[i].number, next);
      next = events[i].number + 1;
      ASSERT_EQ(events[i].line % 2 == 1, events[i].state == ControllerState::held);
      ++read;
    }
  }
  for (std::thread& writer : writers) {
    writer.join();
  }
  EXPECT_GE(read, ControllerEvent::kKept);
}

TEST(Messages, AreKeptForAWhileAndCutWhereTheyAreLong) {
  const auto messages = std::make_unique<Messages>();
  const std::uint32_t first = messages->add(
      {.kind = ProgramMessage::Kind::debug, .line = 3, .text = std::string(1000, 'x')});
  ASSERT_TRUE(messages->find(first));
  EXPECT_EQ(messages->find(first)->text, std::string(500, 'x'));
  EXPECT_EQ(messages->find(first)->line, 3);
  EXPECT_EQ(messages->find(first)->kind, ProgramMessage::Kind::debug);
  EXPECT_FALSE(messages->find(first + 1));
  EXPECT_FALSE(messages->find(0));
  constexpr std::uint32_t kKept = 1024;  // more than a program says between two moves
  for (std::uint32_t i = 1; i < kKept; ++i) {
    messages->add({.text = "later"});
  }
  EXPECT_TRUE(messages->find(first));
  messages->add({.text = "the last"});
  EXPECT_FALSE(messages->find(first));
  EXPECT_EQ(messages->find(first + kKept)->text, "the last");
}

}  // namespace
}  // namespace kerf::control
