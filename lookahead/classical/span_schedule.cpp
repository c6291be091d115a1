#include "lookahead/classical/span_schedule.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "lookahead/classical/span_binding.hpp"
#include "lookahead/classical/span_joint.hpp"
#include "lookahead/classical/split.hpp"
#include "lookahead/classical/turn_scan.hpp"
#include "lookahead/path/block_limits.hpp"

namespace kerf::lookahead {

using profiles::ProfileKind;

namespace {

// Within a cruise.
struct CruisePoint {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
};

// What is left of a span once its first part has left.
void cut_front(Span& span, const CruisePoint& cut) {
  const double way_mm = cut.s_mm - span.s_begin_mm;
  span.length_mm -= way_mm;
  span.s_begin_mm = cut.s_mm;
  span.begin_coast_s = 0.0;
  if (!span.rise.empty()) {
    const bool falls = way_mm >= span.rise.allowed_from_mm(kUnbounded);
    span.rise =
        falls ? Slope({{.distance_mm = 0.0, .v_mm_s = cut.v_mm_s}}) : span.rise.from(way_mm);
  }
}

// A span that was cut ends where its rounded sums say, but not beyond its block.
double end_mm(const Span& span, const Block& block) {
  return span.ends_block ? block.length_mm
                         : std::min(span.s_begin_mm + span.length_mm, block.length_mm);
}

}  // namespace

void SpanSchedule::push(const Window<Block>& blocks) {
  const std::size_t last = blocks.size() - 1;
  push(blocks[last], last > 0 ? &blocks[last - 1] : nullptr);
}

void SpanSchedule::push(const Block& block, const Block* before) {
  std::vector<Span> spans = spans_of(block);
  if (before != nullptr) {
    const SpanJoint joint = span_joint({.blocks = {.before = before, .after = &block},
                                        .before = &window_.back().span,
                                        .after = &spans.front()},
                                       {settings_.limits, settings_.profile});
    window_.back().span.end = joint.end;
    spans.front().begin_coast_s = joint.begin_coast_s;
  }
  for (Span& span : spans) {
    window_.push_back({.span = std::move(span)});
  }
}

std::vector<Span> SpanSchedule::spans_of(const Block& block) const {
  std::vector<Span> spans;
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block.curve);
  Turning turning;
  PlanLimits limits = settings_.limits;
  if (nurbs != nullptr) {
    if (settings_.profile.kind() == ProfileKind::trapezoid) {
      for (MotionLimits& axis : limits.axes) {
        axis.jerk_mm_s3 = kUnbounded;
      }
    }
    turning = scan_turning(*nurbs, block.limits.feedrate_mm_s, limits);
  }
  spans = turning.empty() ? split(block, settings_.limits.period_s) : split(block, turning, limits);
  const double passing = passing_feedrate_mm_s(block, settings_.limits);
  for (Span& span : spans) {
    bind_feedrate(span.limits, {passing, Constraint::chord_error});
    if (!span.ends_block) {
      span.end.feedrate_mm_s = std::min(
          passing,
          valley_mm_s(span.end.feedrate_mm_s, span, {settings_.limits, settings_.profile}));
    }
  }
  return spans;
}

void SpanSchedule::plan_window(Supply supply) {
  backward_pass(window_, settings_.profile);
  if (supply == Supply::to_rest) {
    ready_spans_ = window_.size();
    return;
  }
  std::size_t blocks_left = settings_.ready_blocks;
  ready_spans_ = 0;
  while (blocks_left > 0) {
    blocks_left -= window_[ready_spans_].span.ends_block ? 1U : 0U;
    ++ready_spans_;
  }
}

bool SpanSchedule::emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox) {
  const bool to_rest = supply == Supply::to_rest;
  if (to_rest && !to_rest_) {
    ready_spans_ = 0;  // more is known now than when they were planned
  }
  to_rest_ = to_rest;
  if (ready_spans_ == 0) {
    if (supply == Supply::wanted) {
      return false;
    }
    plan_window(supply);
  }
  WindowSpan& item = window_.front();
  SpanEnds ends{.v_begin_mm_s = v_mm_s_, .v_end_mm_s = item.v_end_mm_s};
  SpanPlan plan = plan_front(ends);
  if (plan.cruise.duration_s() > 2.0 * settings_.longest_cruise_s) {
    emit_cruise(blocks.front(), plan, emitter, outbox);
    cut_front(item.span, {.s_mm = emitter.s_mm(), .v_mm_s = v_mm_s_});
    item.sure = {.v_begin_mm_s = v_mm_s_, .v_end_mm_s = ends.v_end_mm_s};
    left_end_mm_s_ = item.v_end_mm_s = ends.v_end_mm_s;
    return true;
  }
  left_.reset();
  emit_plan(blocks.front(), plan, emitter, outbox);
  v_mm_s_ = ends.v_end_mm_s;
  outbox.phases.back().s_end_mm = end_mm(item.span, blocks.front());
  leave_span(blocks, emitter);
  if (v_mm_s_ == 0.0) {
    emitter.come_to_rest(outbox);
  }
  return true;
}

// Up to a part of the cruise; the rest is kept.
void SpanSchedule::emit_cruise(const Block& block, const SpanPlan& plan, Emitter& emitter,
                               Outbox& outbox) {
  SpanPlan part = plan;
  v_mm_s_ = plan.cruise.ramp().v_begin_mm_s;
  part.cruise = profiles::Transition::cruise(v_mm_s_, v_mm_s_ * settings_.longest_cruise_s);
  part.deceleration = {};
  part.end_coast = {};
  emit_plan(block, part, emitter, outbox);
  left_ = plan;
  left_->begin_coast = {};
  left_->acceleration = {};
  left_->cruise =
      profiles::Transition::cruise(v_mm_s_, plan.cruise.length_mm() - part.cruise.length_mm());
}

// Moves the end to what can be joined.
SpanPlan SpanSchedule::plan_front(SpanEnds& ends) {
  if (left_ && ends.v_end_mm_s == left_end_mm_s_) {
    return *left_;
  }
  const WindowSpan& item = window_.front();
  const Ending ending = ending_of(item, ends, settings_.profile);
  ends.v_end_mm_s = ending.v_end_mm_s;
  return ending.is_slowed ? slowed_plan(item.span, item.sure, ends.v_begin_mm_s, settings_.profile)
                          : plan_span(item.span, ends, settings_.profile);
}

void SpanSchedule::emit_plan(const Block& block, const SpanPlan& plan, Emitter& emitter,
                             Outbox& outbox) const {
  const Span& span = window_[0].span;
  const double s_end = end_mm(span, block);
  const SpanBinding binding({.block = &block,
                             .span = &span,
                             .profile = &settings_.profile,
                             .brakes_for_window = window_[0].brakes_for_window && !to_rest_});
  struct Part {
    SpanPart kind;
    const profiles::Transition* law;
  };
  for (const auto& [kind, law] :
       {Part{SpanPart::begin_coast, &plan.begin_coast},
        Part{SpanPart::acceleration, &plan.acceleration}, Part{SpanPart::cruise, &plan.cruise},
        Part{SpanPart::deceleration, &plan.deceleration},
        Part{SpanPart::end_coast, &plan.end_coast}}) {
    if (law->duration_s() > 0.0) {
      const double s_begin = emitter.s_mm();
      emitter.emit(block, *law, std::min(s_begin + law->length_mm(), s_end), outbox);
      outbox.phases.back().active_constraint = binding.of(kind, *law, s_begin);
    }
  }
}

void SpanSchedule::leave_span(Window<Block>& blocks, Emitter& emitter) {
  const Span& span = window_.front().span;
  if (span.ends_block) {
    emitter.end_block(blocks.front());
    blocks.pop_front();
  } else {
    emitter.end_span(end_mm(span, blocks.front()));
  }
  window_.pop_front();
  --ready_spans_;
}

void SpanSchedule::stop(const Window<Block>& /*blocks*/, const Emitter& /*emitter*/) {
  backward_pass(window_, settings_.profile);
  double v = v_mm_s_;
  std::size_t kept = 0;
  while (kept < window_.size() && v > 0.0) {
    WindowSpan& item = window_[kept++];
    SpanEnds ends{.v_begin_mm_s = v, .v_end_mm_s = item.v_end_mm_s};
    const Ending ending = ending_of(item, ends, settings_.profile);
    if (ending.is_slowed) {
      v = item.v_end_mm_s = ending.v_end_mm_s;
      continue;
    }
    ends.v_end_mm_s = ending.v_end_mm_s;
    item.v_end_mm_s = brake(item.span, ends, settings_.profile);
    item.sure = {.v_begin_mm_s = v, .v_end_mm_s = item.v_end_mm_s};
    v = item.v_end_mm_s;
  }
  window_.keep_front(kept);
  ready_spans_ = 0;
  left_.reset();
}

}  // namespace kerf::lookahead
