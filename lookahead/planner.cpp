#include "lookahead/planner.hpp"

#include <algorithm>
#include <utility>

#include "lookahead/junction.hpp"
#include "lookahead/split.hpp"

namespace kerf::lookahead {

namespace {

// Within a cruise.
struct CruisePoint {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
};

// What is left of a span once its first part has left.
void cut_front(Span& span, const CruisePoint& cut) {
  span.length_mm -= cut.s_mm - span.s_begin_mm;
  span.s_begin_mm = cut.s_mm;
  span.begin_coast_s = 0.0;
  if (!span.rise.empty()) {
    span.rise = Slope({{.distance_mm = 0.0, .v_mm_s = cut.v_mm_s}});
  }
}

}  // namespace

Planner::Planner(const PlannerSettings& settings)
    : settings_(settings), clock_(settings.limits.period_s) {}

bool Planner::wants_block() const noexcept {
  return !draining_ && blocks_.size() < settings_.window_blocks;
}

void Planner::push(Block block) {
  ++pushed_blocks_;
  join_to_last(block);
  append_spans(block);
  blocks_.push_back(std::move(block));
}

void Planner::join_to_last(const Block& block) {
  if (blocks_.empty()) {
    return;
  }
  Span& last = window_.back().span;
  Junction joint = junction({.before = &blocks_.back(), .after = &block}, settings_.limits);
  if (!blocks_.back().ceiling.empty()) {
    joint.feedrate_mm_s = std::min(joint.feedrate_mm_s, blocks_.back().ceiling.back().v_mm_s);
  }
  if (!block.ceiling.empty()) {
    joint.feedrate_mm_s = std::min(joint.feedrate_mm_s, block.ceiling.front().v_mm_s);
  }
  last.end = joint;
}

void Planner::append_spans(const Block& block) {
  const std::size_t first = window_.size();
  if (block.ceiling.empty()) {
    window_.push_back({.span = whole_span(block)});
  } else {
    for (Span& span : split(block)) {
      window_.push_back({.span = std::move(span)});
    }
  }
  window_[first].span.begin_coast_s = first > 0 ? window_[first - 1].span.end.coast_s : 0.0;
}

void Planner::plan_window() {
  backward_pass(window_, settings_.profile);
  if (draining_) {
    ready_spans_ = window_.size();
    return;
  }
  std::size_t blocks_left = std::max<std::size_t>(settings_.window_blocks / 2, 1);
  ready_spans_ = 0;
  while (blocks_left > 0) {
    blocks_left -= window_[ready_spans_].span.ends_block ? 1U : 0U;
    ++ready_spans_;
  }
}

void Planner::drain() {
  draining_ = true;
  ready_spans_ = 0;
}

void Planner::stop() {
  if (rest_.ends_program && !rest_pending_) {
    return;
  }
  backward_pass(window_, settings_.profile);
  double v = v_mm_s_;
  std::size_t kept = 0;
  while (kept < window_.size() && v > 0.0) {
    WindowSpan& item = window_[kept++];
    SpanEnds ends{.v_begin_mm_s = v, .v_end_mm_s = item.v_end_mm_s};
    ends.v_end_mm_s = end_feedrate_mm_s(item.span, ends, item.v_end_before_mm_s, settings_.profile);
    v = brake(item.span, ends, settings_.profile);
    item.v_end_mm_s = v;
  }
  window_.keep_front(kept);
  finish(0);
}

bool Planner::emit(Outbox& outbox) {
  if (window_.empty()) {
    if (rest_pending_) {
      emit_rest(outbox);
      return true;
    }
    draining_ = rest_.ends_program;
    return false;
  }
  if (ready_spans_ == 0) {
    if (wants_block()) {
      return false;
    }
    plan_window();
  }
  emit_span(outbox);
  return true;
}

void Planner::begin_block(Outbox& outbox) {
  ++curve_;
  ++totals_.blocks;
  s_mm_ = 0.0;
  block_begun_ = true;
  emit_switches(outbox);
  const curves::Curve& curve = blocks_.front().curve;
  const curves::ExtraWay& extra = blocks_.front().extra;
  rests_ = extra.alone;
  if (const auto* nurbs = std::get_if<curves::NurbsCurve>(&curve)) {
    for (const curves::NurbsPiece& piece : nurbs->pieces()) {
      outbox.pieces.push_back({.curve = curve_, .geometry = piece, .extra = extra});
    }
  } else if (const auto* line = std::get_if<curves::Line>(&curve)) {
    outbox.pieces.push_back({.curve = curve_, .geometry = *line, .extra = extra});
  } else {
    outbox.pieces.push_back(
        {.curve = curve_, .geometry = std::get<curves::Arc>(curve), .extra = extra});
  }
}

void Planner::emit_span(Outbox& outbox) {
  if (!block_begun_) {
    begin_block(outbox);
  }
  WindowSpan& item = window_.front();
  SpanEnds ends{.v_begin_mm_s = v_mm_s_, .v_end_mm_s = item.v_end_mm_s};
  ends.v_end_mm_s = end_feedrate_mm_s(item.span, ends, item.v_end_before_mm_s, settings_.profile);
  SpanPlan plan = plan_span(item.span, ends, settings_.profile);
  if (plan.cruise.duration_s() > 2.0 * settings_.longest_cruise_s) {
    const double v = plan.cruise.ramp().v_begin_mm_s;
    plan.cruise = profiles::Transition::cruise(v, v * settings_.longest_cruise_s);
    plan.deceleration = {};
    plan.end_coast = {};
    emit_plan(outbox, plan);
    v_mm_s_ = v;
    cut_front(item.span, {.s_mm = s_mm_, .v_mm_s = v});
    return;
  }
  emit_plan(outbox, plan);
  v_mm_s_ = ends.v_end_mm_s;
  leave_span();
  interp::Phase& last = outbox.phases.back();
  last.s_end_mm = s_mm_;
  if (v_mm_s_ == 0.0) {
    last.ends_at_rest = true;
    clock_.align_to_tick();
  }
}

void Planner::emit_plan(Outbox& outbox, const SpanPlan& plan) {
  const Span& span = window_.front().span;
  const double s_end = span.s_begin_mm + span.length_mm;
  for (const profiles::Transition* law :
       {&plan.begin_coast, &plan.acceleration, &plan.cruise, &plan.deceleration, &plan.end_coast}) {
    if (law->duration_s() > 0.0) {
      emit_phase(outbox, *law, std::min(s_mm_ + law->length_mm(), s_end));
    }
  }
}

void Planner::leave_span() {
  const Span& span = window_.front().span;
  ++totals_.spans;
  s_mm_ = span.s_begin_mm + span.length_mm;
  if (span.ends_block) {
    s_mm_ = blocks_.front().length_mm;
    path_begin_mm_ += rests_ ? 0.0 : s_mm_;
    blocks_.pop_front();
    block_begun_ = false;
  }
  totals_.path_length_mm = path_begin_mm_ + (block_begun_ && !rests_ ? s_mm_ : 0.0);
  window_.pop_front();
  --ready_spans_;
}

void Planner::emit_phase(Outbox& outbox, const profiles::Transition& law, double s_end_mm) {
  outbox.phases.push_back({.curve = curve_,
                           .begin = clock_.now(),
                           .s_begin_mm = s_mm_,
                           .s_end_mm = s_end_mm,
                           .path_begin_mm = path_begin_mm_,
                           .law = law,
                           .line = blocks_.front().line,
                           .rapid = blocks_.front().rapid});
  s_mm_ = s_end_mm;
  line_ = blocks_.front().line;
  clock_.advance(law.duration_s());
}

}  // namespace kerf::lookahead
