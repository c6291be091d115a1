// What may cross to the tick side, and when: lines of the program with the motion on them.
#include "kernel/delivery.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "curves/line.hpp"
#include "interp/interpolator.hpp"

namespace kerf {
namespace {

using interp::LineChange;
using interp::MotionQueue;

constexpr double kPeriod_s = 0.001;
constexpr std::int64_t kFar = 1'000'000'000;

interp::CurvePiece piece(double length_mm) {
  return {.curve = 1, .geometry = curves::Line::between({0, 0, 0}, {length_mm, 0, 0}).value()};
}

interp::Phase cruise_phase(double s_begin_mm, double length_mm) {
  return {.curve = 1,
          .begin = {.tick = static_cast<std::int64_t>(s_begin_mm * 10.0 + 0.5)},
          .s_begin_mm = s_begin_mm,
          .s_end_mm = s_begin_mm + length_mm,
          .law = profiles::Transition::cruise(100.0, length_mm),
          .run_block = 1,
          .has_changes = true};
}

LineChange change(std::size_t i, double step_mm) {
  return {
      .curve = 1, .s_mm = static_cast<double>(i) * step_mm, .line = static_cast<std::uint32_t>(i)};
}

TEST(Delivery, APhaseWaitsForTheLinesUpToItsBegin) {
  const auto queue = std::make_unique<MotionQueue>();
  Delivery delivery(*queue, [] {});
  lookahead::Outbox& outbox = delivery.outbox();
  outbox.pieces.push_back(piece(10.0));
  // One more than the ring holds lies before the second phase.
  for (std::size_t i = 0; i <= MotionQueue::kLineChanges; ++i) {
    outbox.line_changes.push_back(change(i, 1e-4));
  }
  outbox.phases = {cruise_phase(0.0, 5.0), cruise_phase(5.0, 5.0)};
  EXPECT_FALSE(delivery.deliver(kFar));
  EXPECT_EQ(queue->phases_free(), MotionQueue::kPhases - 1);
  queue->pop_line_change();
  EXPECT_TRUE(delivery.deliver(kFar));
  EXPECT_EQ(queue->phases_free(), MotionQueue::kPhases - 2);
}

TEST(Delivery, MoreLinesThanTheRingHoldsReachTheirTicks) {
  constexpr double kStep_mm = 0.002;
  constexpr std::size_t kLines = 50'000;
  constexpr double kLength_mm = kStep_mm * kLines;
  const auto queue = std::make_unique<MotionQueue>();
  Delivery delivery(*queue, [] {});
  interp::Interpolator interpolator(*queue, kPeriod_s, {});
  lookahead::Outbox& outbox = delivery.outbox();
  outbox.pieces.push_back(piece(kLength_mm));
  for (std::size_t i = 0; i < kLines; ++i) {
    outbox.line_changes.push_back(change(i, kStep_mm));
  }
  for (double s = 0.0; s < kLength_mm - 5.0; s += 10.0) {
    outbox.phases.push_back(cruise_phase(s, 10.0));
  }
  interp::Setpoint setpoint;
  std::int64_t ticks = 0;
  for (auto status = interp::TickStatus::running; status == interp::TickStatus::running; ++ticks) {
    delivery.deliver(interpolator.plan_tick() + 50);
    delivery.commit();
    status = interpolator.next(setpoint);
    const double in_steps = setpoint.s_mm / kStep_mm;
    if (status == interp::TickStatus::running) {
      ASSERT_NEAR(static_cast<double>(setpoint.line) + 0.5, in_steps, 0.5 + 1e-9) << in_steps;
    }
  }
  EXPECT_GE(ticks, 1000);
}

interp::Phase of_plan(std::uint32_t plan, interp::Phase phase) {
  phase.plan = plan;
  return phase;
}

// Begins at tick 50, in the middle of a cruise that begins at tick 0.
lookahead::Outbox plan_that_takes_over() {
  lookahead::Outbox plan;
  plan.phases = {of_plan(1, cruise_phase(5.0, 5.0))};
  return plan;
}

TEST(Delivery, SaysWhetherThePlanBeforeATakeoverWasHandedOverToItsEnd) {
  for (const std::int64_t horizon : {std::int64_t{10}, kFar}) {
    const auto queue = std::make_unique<MotionQueue>();
    Delivery delivery(*queue, [] {});
    delivery.outbox().pieces.push_back(piece(30.0));
    delivery.outbox().phases = {cruise_phase(0.0, 10.0), cruise_phase(10.0, 10.0)};
    delivery.deliver(horizon);
    EXPECT_EQ(delivery.take_over(plan_that_takes_over(), 0),
              horizon == kFar ? Delivery::HandedOver::whole : Delivery::HandedOver::for_good);
    EXPECT_TRUE(delivery.outbox().phases.empty());
    const interp::Takeover* takeover = queue->next_takeover();
    ASSERT_NE(takeover, nullptr);
    EXPECT_EQ(takeover->tick, 50);
    EXPECT_TRUE(queue->is_committed(takeover->phases_end));
  }
}

// To a rest behind one more piece, of a millimetre each, than the ring has room for.
lookahead::Planner::PlannedStopAhead way_over_more_pieces_than_the_ring_holds(
    const interp::Phase& last) {
  lookahead::Planner::PlannedStopAhead ahead;
  ahead.plan = 2;
  for (std::size_t i = 0; i <= MotionQueue::kPieces; ++i) {
    ahead.outbox.pieces.push_back(piece(1.0));
    ahead.outbox.pieces.back().curve = i + 2;
  }
  ahead.outbox.phases = {of_plan(2, last)};
  ahead.outbox.phases.back().curve = MotionQueue::kPieces + 2;
  return ahead;
}

// The ring has no room for the path of the way to rest.
TEST(Delivery, HandsOverNoPlanWhoseWayToRestDoesNotFit) {
  const auto queue = std::make_unique<MotionQueue>();
  Delivery delivery(*queue, [] {});
  delivery.outbox().pieces.push_back(piece(30.0));
  delivery.outbox().phases = {cruise_phase(0.0, 10.0), cruise_phase(10.0, 10.0)};
  delivery.deliver(10);
  lookahead::Planner::PlannedStopAhead ahead =
      way_over_more_pieces_than_the_ring_holds(cruise_phase(10.0, 10.0));
  const std::uint32_t pushed = queue->phases_pushed();
  EXPECT_EQ(delivery.take_over(plan_that_takes_over(), 0, &ahead), Delivery::HandedOver::no);
  EXPECT_EQ(queue->next_takeover(), nullptr);
  EXPECT_EQ(queue->phases_pushed(), pushed);
  EXPECT_EQ(delivery.outbox().phases.size(), 2);
  ahead.outbox.phases.back().curve = 2;
  ahead.outbox.pieces.clear();
  EXPECT_EQ(delivery.take_over(plan_that_takes_over(), 0, &ahead), Delivery::HandedOver::for_good);
}

// Found by reading: the phases went without a way to rest, and where planning was late the motion
// ended with them.
TEST(Delivery, CommitsNothingWhoseWayToRestDoesNotFit) {
  const auto queue = std::make_unique<MotionQueue>();
  Delivery delivery(*queue, [] {});
  delivery.outbox().pieces.push_back(piece(30.0));
  delivery.outbox().phases = {cruise_phase(0.0, 10.0)};
  EXPECT_TRUE(delivery.deliver(kFar));
  EXPECT_TRUE(delivery.is_whole());
  lookahead::Planner::PlannedStopAhead ahead =
      way_over_more_pieces_than_the_ring_holds(cruise_phase(0.0, 0.5));
  EXPECT_EQ(delivery.commit(ahead, 0), Delivery::Committed::no_room);
  EXPECT_EQ(queue->next_phase(), nullptr);
  EXPECT_FALSE(queue->has_stop());
  EXPECT_EQ(delivery.missing_mm(ahead), 1.0 + 0.5);  // two pieces

  queue->pop_piece();
  queue->pop_piece();
  ahead.outbox.pieces.clear();
  EXPECT_EQ(delivery.commit(ahead, 0), Delivery::Committed::yes);
  EXPECT_NE(queue->next_phase(), nullptr);
  EXPECT_TRUE(queue->has_stop());
}

// A phase may lead over more pieces than the ring holds.
TEST(Delivery, IsWholeWithThePathToItsEnd) {
  const auto queue = std::make_unique<MotionQueue>();
  Delivery delivery(*queue, [] {});
  constexpr std::size_t kPieces = MotionQueue::kPieces + 1;
  for (std::size_t i = 0; i < kPieces; ++i) {
    interp::CurvePiece part = piece(1.0);
    part.curve = i + 1;
    delivery.outbox().pieces.push_back(part);
  }
  delivery.outbox().phases = {cruise_phase(0.0, 1.0), cruise_phase(0.0, 1.0)};
  delivery.outbox().phases.back().curve = kPieces - 1;
  EXPECT_TRUE(delivery.deliver(kFar));
  EXPECT_TRUE(delivery.is_whole());
  delivery.outbox().phases = {cruise_phase(0.0, 1.0)};
  delivery.outbox().phases.back().curve = kPieces;
  EXPECT_FALSE(delivery.deliver(kFar));
  EXPECT_FALSE(delivery.is_whole());
  queue->pop_piece();
  EXPECT_TRUE(delivery.deliver(kFar));
  EXPECT_TRUE(delivery.is_whole());
}

// It has been made, and is not made again.
TEST(Delivery, KeepsThePathOfAWayToRestWhosePlanDoesNotFit) {
  const auto queue = std::make_unique<MotionQueue>();
  Delivery delivery(*queue, [] {});
  lookahead::Planner::PlannedStopAhead ahead;
  ahead.plan = 2;
  ahead.outbox.pieces = {piece(1.0)};
  ahead.outbox.phases = {of_plan(2, cruise_phase(10.0, 10.0))};
  lookahead::Outbox plan = plan_that_takes_over();
  plan.phases.back().output_changes = MotionQueue::kOutputChanges + 1;
  plan.output_changes.resize(MotionQueue::kOutputChanges + 1);
  EXPECT_EQ(delivery.take_over(std::move(plan), 0, &ahead), Delivery::HandedOver::no);
  delivery.deliver(kFar);
  EXPECT_NE(queue->next_piece(), nullptr);
}

}  // namespace
}  // namespace kerf
