#include "lookahead/classical/classical_schedule.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <variant>

#include "lookahead/classical/block_segments.hpp"
#include "lookahead/classical/limit_curve_cuts.hpp"
#include "lookahead/classical/segment_constraint.hpp"
#include "lookahead/classical/segment_junction.hpp"
#include "lookahead/path/block_limits.hpp"

namespace kerf::lookahead {

namespace {

// Within a cruise.
struct CruisePoint {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
};

// What is left of a segment once its first part has left.
void cut_front(VelocitySegment& segment, const CruisePoint& cut) {
  const double way_mm = cut.s_mm - segment.s_begin_mm;
  segment.length_mm = segment.s_begin_mm + segment.length_mm - cut.s_mm;
  segment.s_begin_mm = cut.s_mm;
  segment.begin_constant_velocity_s = 0.0;
  if (!segment.rise.empty()) {
    const bool falls = way_mm >= segment.rise.allowed_from_mm(kUnbounded);
    segment.rise =
        falls ? Slope({{.distance_mm = 0.0, .v_mm_s = cut.v_mm_s}}) : segment.rise.from(way_mm);
  }
}

// A segment that was cut ends where its rounded sums say, but not beyond its block.
double end_mm(const VelocitySegment& segment, const Block& block) {
  return segment.ends_block ? block.length_mm
                            : std::min(segment.s_begin_mm + segment.length_mm, block.length_mm);
}

}  // namespace

void ClassicalSchedule::use(const profiles::Profile& profile) {
  assert(empty());
  settings_.profile = profile;
}

void ClassicalSchedule::push(const Window<Block>& blocks) {
  const std::size_t last = blocks.size() - 1;
  push(blocks[last], last > 0 ? &blocks[last - 1] : nullptr);
}

void ClassicalSchedule::push(const Block& block, const Block* before) {
  std::vector<VelocitySegment> segments =
      segments_of(block, {settings_.limits, settings_.profile}, before == nullptr);
  if (settings_.observer && !block.limit_curve.empty()) {
    settings_.observer->cut({.line = block.line,
                             .breaking_points = breaking_points(block.limit_curve, 0.0).size(),
                             .velocity_segments = segments.size()});
  }
  if (before != nullptr) {
    const SegmentJunction junction =
        segment_junction({.blocks = {.before = before, .after = &block},
                          .before = &window_.back().segment,
                          .after = &segments.front()},
                         {settings_.limits, settings_.profile});
    window_.back().segment.end = junction.end;
    segments.front().begin_constant_velocity_s = junction.begin_constant_velocity_s;
  }
  for (VelocitySegment& segment : segments) {
    window_.push_back({.segment = std::move(segment)});
  }
}

bool ClassicalSchedule::begin(double v_mm_s) {
  backward_pass(window_, settings_.profile);
  v_mm_s_ = v_mm_s;
  return begin_in_motion(window_.front(), v_mm_s, settings_.profile);
}

void ClassicalSchedule::plan_window(Supply supply) {
  backward_pass(window_, settings_.profile);
  if (supply == Supply::to_rest) {
    ready_segments_ = window_.size();
    return;
  }
  std::size_t blocks_left = settings_.ready_blocks;
  ready_segments_ = 0;
  while (blocks_left > 0) {
    blocks_left -= window_[ready_segments_].segment.ends_block ? 1U : 0U;
    ++ready_segments_;
  }
}

bool ClassicalSchedule::emit(Window<Block>& blocks, Supply supply, Emitter& emitter,
                             Outbox& outbox) {
  assert(!empty());
  const bool to_rest = supply == Supply::to_rest;
  if (to_rest && !to_rest_) {
    ready_segments_ = 0;  // more is known now than when they were planned
  }
  to_rest_ = to_rest;
  if (ready_segments_ == 0) {
    if (supply == Supply::wanted) {
      return false;
    }
    plan_window(supply);
  }
  WindowSegment& item = window_.front();
  SegmentEnds ends{.v_begin_mm_s = v_mm_s_, .v_end_mm_s = item.v_end_mm_s};
  const bool goes_on = left_.has_value();
  SegmentPlan plan = plan_front(ends);
  if (settings_.observer && !goes_on) {
    tell_front(ends, plan, blocks.front());
  }
  if (plan.cruise.duration_s() > 2.0 * settings_.longest_cruise_s) {
    emit_cruise(blocks.front(), plan, emitter, outbox);
    cut_front(item.segment, {.s_mm = emitter.s_mm(), .v_mm_s = v_mm_s_});
    item.sure = {.v_begin_mm_s = v_mm_s_, .v_end_mm_s = ends.v_end_mm_s};
    left_end_mm_s_ = item.v_end_mm_s = ends.v_end_mm_s;
    return true;
  }
  left_.reset();
  emit_plan(blocks.front(), plan, emitter, outbox);
  v_mm_s_ = ends.v_end_mm_s;
  outbox.phases.back().s_end_mm = blocks.front().on_whole_mm(end_mm(item.segment, blocks.front()));
  leave_segment(blocks, emitter);
  if (v_mm_s_ == 0.0) {
    emitter.come_to_rest(outbox);
  }
  return true;
}

// Up to a part of the cruise; the rest is kept.
void ClassicalSchedule::emit_cruise(const Block& block, const SegmentPlan& plan, Emitter& emitter,
                                    Outbox& outbox) {
  SegmentPlan part = plan;
  v_mm_s_ = plan.cruise.ramp().v_begin_mm_s;
  part.cruise = profiles::Transition::cruise(v_mm_s_, v_mm_s_ * settings_.longest_cruise_s);
  part.deceleration = {};
  part.end_constant_velocity = {};
  emit_plan(block, part, emitter, outbox);
  left_ = plan;
  left_->begin_constant_velocity = {};
  left_->acceleration = {};
  // By the end, not by what has left: over thousands of parts the rounding of each would add up.
  const double behind_mm = plan.deceleration.length_mm() + plan.end_constant_velocity.length_mm();
  left_->cruise = profiles::Transition::cruise(
      v_mm_s_, end_mm(window_[0].segment, block) - behind_mm - emitter.s_mm());
}

// Moves the end to what can be joined.
SegmentPlan ClassicalSchedule::plan_front(SegmentEnds& ends) {
  if (left_ && ends.v_end_mm_s == left_end_mm_s_) {
    return *left_;
  }
  const Ending ending = ending_of(window_.front(), ends, settings_.profile);
  ends.v_end_mm_s = ending.v_end_mm_s;
  return plan_joined(window_.front(), ending, ends.v_begin_mm_s, settings_.profile);
}

void ClassicalSchedule::tell_front(const SegmentEnds& ends, const SegmentPlan& plan,
                                   const Block& block) const {
  const VelocitySegment& segment = window_[0].segment;
  const double up_mm_s = plan.acceleration.ramp().v_end_mm_s;
  const double down_mm_s = plan.deceleration.ramp().v_begin_mm_s;
  settings_.observer->planned(
      {.line = block.line,
       .kind = kind_of(plan),
       .s_begin_mm = segment.s_begin_mm,
       .length_mm = segment.length_mm,
       .v_begin_mm_s = ends.v_begin_mm_s,
       .v_cruise_mm_s = std::max({up_mm_s, down_mm_s, ends.v_begin_mm_s, ends.v_end_mm_s}),
       .v_end_mm_s = ends.v_end_mm_s,
       .v_end_allowed_mm_s = segment.end.feedrate_mm_s,
       .duration_s = plan.duration_s()});
}

void ClassicalSchedule::emit_plan(const Block& block, const SegmentPlan& plan, Emitter& emitter,
                                  Outbox& outbox) const {
  const VelocitySegment& segment = window_[0].segment;
  const double s_end = end_mm(segment, block);
  const SegmentConstraint constraint(
      {.block = &block,
       .segment = &segment,
       .profile = &settings_.profile,
       .brakes_for_window = window_[0].brakes_for_window && !to_rest_});
  struct Part {
    SegmentPart kind;
    const profiles::Transition* law;
  };
  for (const auto& [kind, law] :
       {Part{SegmentPart::begin_constant_velocity, &plan.begin_constant_velocity},
        Part{SegmentPart::acceleration, &plan.acceleration},
        Part{SegmentPart::cruise, &plan.cruise},
        Part{SegmentPart::deceleration, &plan.deceleration},
        Part{SegmentPart::end_constant_velocity, &plan.end_constant_velocity}}) {
    if (law->duration_s() > 0.0) {
      const double s_begin = emitter.s_mm();
      emitter.emit(block, *law, std::min(s_begin + law->length_mm(), s_end), outbox);
      outbox.phases.back().active_constraint = constraint.of(kind, *law, s_begin);
    }
  }
}

void ClassicalSchedule::leave_segment(Window<Block>& blocks, Emitter& emitter) {
  const VelocitySegment& segment = window_.front().segment;
  if (segment.ends_block) {
    emitter.end_block(std::move(blocks.front()));
    blocks.pop_front();
  } else {
    emitter.end_segment(blocks.front(), end_mm(segment, blocks.front()));
  }
  window_.pop_front();
  --ready_segments_;
}

}  // namespace kerf::lookahead
