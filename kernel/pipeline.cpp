#include "kernel/pipeline.hpp"

#include <cassert>
#include <memory>
#include <utility>
#include <variant>

#include "diagnostics/errors/pages.hpp"
#include "kernel/plan_notes.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

Pipeline::Pipeline(const Order& order)
    : observer_(order.path.observer),
      limits_(order.settings.limits),
      path_(order.settings, order.options, order.path),
      planner_({.limits = order.settings.limits,
                .profile = profiles::Profile(order.options.profile),
                .window_blocks = order.options.window_blocks,
                .longest_phase_s = order.longest_phase_s,
                .waits = order.options.waits && order.may_hold,
                .optional_stop = order.options.optional_stop,
                .tool_change_s = order.settings.program.tool_change_s,
                .spindle_start_s = order.settings.program.spindle_start_s,
                .may_hold = order.may_hold,
                .observer = order.options.plan_log
                                ? std::make_shared<const PlanNotes>(order.options.plan_log)
                                : nullptr}) {}

Pipeline::Step Pipeline::step(lookahead::Outbox& outbox) {
  assert(outbox.phases.empty());
  if (planner_.emit(outbox)) {
    check_.emitted(outbox);
    if (observer_ != nullptr) {
      observer_->planned(outbox);
    }
    return Step::planned;
  }
  if (planner_.is_held() || planner_.waits() || planner_.awaits_answer()) {
    return Step::held;
  }
  if (finished_) {
    return Step::ended;
  }
  return take_next() ? Step::took : Step::wants_text;
}

bool Pipeline::take_next() {
  ProgramPath::Output output;
  switch (path_.next(output)) {
    case ProgramPath::Next::wants_text:
      return false;
    case ProgramPath::Next::ended:
      check_.judge(path_.deviations().worst);
      planner_.finish(path_.line());
      finished_ = true;
      return true;
    case ProgramPath::Next::output:
      break;
  }
  if (auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
    push_segment(std::move(*segment));
    return true;
  }
  const auto& pause = std::get<parser::Move>(output);
  lookahead::push_pause(pause, planner_);
  if (observer_ != nullptr) {
    const auto* dwell = std::get_if<parser::DwellMove>(&pause.shape);
    observer_->rest(dwell != nullptr ? dwell->duration_s : 0.0);
  }
  return true;
}

void Pipeline::push_segment(smoothing::PathSegment segment) {
  const diagnostics::SourcePosition source = segment.source;
  const std::vector<parser::EventMove> changes = std::move(segment.changes);
  auto block = lookahead::block_of(std::move(segment), limits_, planner_.scan_for());
  if (!block) {
    path_.cut(source, block.error(), errors::kCurveRefused);
    return;
  }
  check_.pushed(*block);
  if (observer_ != nullptr) {
    observer_->pushed(*block);
  }
  lookahead::push_block(std::move(*block), changes, planner_);
}

bool Pipeline::hold(std::int64_t tick, lookahead::Outbox& outbox) {
  return took_over(planner_.hold(tick, outbox), outbox);
}

std::optional<lookahead::Planner::ChangedPlan> Pipeline::change_plan(
    const lookahead::Planner::PlanChange& change, lookahead::Outbox& outbox) {
  auto changed = planner_.change_plan(change, outbox);
  if (changed) {
    const std::uint64_t from_curve = outbox.phases.empty() ? 0 : outbox.phases.front().curve;
    check_.overridden(change.by, {.from_curve = from_curve, .to_curve = changed->slows_to_curve});
    took_over(true, outbox);
  }
  return changed;
}

bool Pipeline::stop(std::int64_t tick, lookahead::Outbox& outbox) {
  if (!planner_.stop(tick, outbox)) {
    return false;
  }
  finished_ = true;
  check_.stop();
  return took_over(true, outbox);
}

void Pipeline::follow_stop_ahead(const lookahead::Planner::PlannedStopAhead& taken) {
  took_over(true, planner_.follow_stop_ahead(taken));
}

void Pipeline::stop_held() {
  finished_ = true;
  check_.stop();
  planner_.stop_held();
}

bool Pipeline::took_over(bool found, const lookahead::Outbox& outbox) {
  if (!outbox.phases.empty()) {
    check_.taken_over();
    check_.emitted(outbox);
  }
  return found;
}

void Pipeline::forget_before(std::int64_t tick) {
  planner_.forget_before(tick);
  check_.forget_before(planner_.oldest_curve());
}

void Pipeline::fail_without_plan(std::uint32_t line) {
  check_.fail(line, "the program is read and nothing is planned");
}

}  // namespace kerf
