#include "lookahead/planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/path/block_builder.hpp"

namespace kerf::lookahead {

namespace {

// The first of them runs, the last one's end is open, and between them something must be planned.
constexpr std::size_t kOptimumBlocks = 4;

bool is_optimum(const PlannerSettings& settings) {
  return settings.profile.kind() == profiles::ProfileKind::time_optimal;
}

ScanFor scan_for_plan(const PlannerSettings& settings) {
  if (is_optimum(settings)) {
    return ScanFor::time_optimum;
  }
  return settings.profile.kind() == profiles::ProfileKind::trapezoid ? ScanFor::trapezoid
                                                                     : ScanFor::bounded_jerk;
}

// Of whole ticks, so that parts do not move what follows.
double rest_part_s(const PlannerSettings& settings) {
  const double period = settings.limits.period_s;
  return std::max(std::floor(settings.longest_phase_s / period), 1.0) * period;
}

}  // namespace

Planner::Planner(const PlannerSettings& settings)
    : settings_(settings),
      window_blocks_(is_optimum(settings) ? std::max(settings.window_blocks, kOptimumBlocks)
                                          : settings.window_blocks),
      scan_for_(scan_for_plan(settings)),
      schedule_(new_schedule()),
      rest_part_s_(rest_part_s(settings)),
      event_time_(settings.event_time),
      emitter_(settings.limits.period_s, settings.may_hold) {
  assert(settings.window_blocks >= 2 && settings.window_cells >= 100);
}

std::size_t Planner::ready_blocks() const {
  return std::max<std::size_t>(settings_.window_blocks / 2, 1);
}

OptimumSchedule::Settings Planner::optimum_settings() const {
  return {.limits = settings_.limits,
          .window_cells = settings_.window_cells,
          .ready_blocks = ready_blocks(),
          .longest_phase_s = settings_.longest_phase_s,
          .observer = settings_.observer};
}

ClassicalSchedule::Settings Planner::classical_settings() const {
  return {.limits = settings_.limits,
          .profile = settings_.profile,
          .ready_blocks = ready_blocks(),
          .longest_cruise_s = settings_.longest_phase_s,
          .observer = settings_.observer};
}

std::unique_ptr<Schedule> Planner::new_schedule() const {
  if (is_optimum(settings_)) {
    return std::make_unique<OptimumSchedule>(optimum_settings());
  }
  return std::make_unique<ClassicalSchedule>(classical_settings());
}

bool Planner::has_room() const noexcept {
  return !to_rest_ && blocks_.size() < window_blocks_ && schedule_->has_room();
}

bool Planner::wants_block() const noexcept {
  return !held_ && !waits_ && !is_cut_ && waiting_.empty() && has_room();
}

void Planner::push(Block block) {
  ++pushed_blocks_;
  for (const interp::OutputChange& change : std::exchange(changes_for_next_, {})) {
    emitter_.change_at_block(pushed_blocks_, change);
  }
  if (by_ != FeedOverride{}) {
    set_limits(by_, settings_.limits, scan_for_, block);
  }
  accept(std::move(block));
}

void Planner::accept_rest(Rest rest) {
  rest.changes_before = std::exchange(changes_for_next_, {});
  accept(std::move(rest));
}

void Planner::accept(Item item) {
  if (!waiting_.empty()) {
    waiting_.push_back(std::move(item));
  } else if (steps_before(item)) {
    waiting_.push_back(std::move(item));
    end_with_step();
  } else if (auto* block = std::get_if<Block>(&item)) {
    take(std::move(*block));
  } else {
    end_with(std::get<Rest>(item));
  }
}

void Planner::take(Block block) {
  assert(!rest_pending_ && block.length_mm > 0.0);
  if (settings_.observer) {
    settings_.observer->pushed(block);
  }
  last_ = place_of(block);
  blocks_.push_back(std::move(block));
  schedule_->push(blocks_);
}

void Planner::take_waiting() {
  while (!waiting_.empty() && has_room()) {
    if (steps_before(waiting_.front())) {
      end_with_step();
      return;
    }
    if (auto* block = std::get_if<Block>(&waiting_.front())) {
      if (block->slows) {
        set_limits(by_, settings_.limits, scan_for_, *block);
      }
      take(std::move(*block));
    } else {
      end_with(std::get<Rest>(waiting_.front()));
    }
    waiting_.pop_front();
  }
}

void Planner::push_rest(double duration_s, const RestPlace& at) {
  assert(duration_s >= 0.0 && wants_block());
  accept_rest(Rest{
      .duration_s = duration_s, .line = at.line, .run_block = at.run_block, .follows = at.follows});
}

void Planner::push_wait(const std::optional<interp::OutputChange>& change, WaitCause cause,
                        const RestPlace& at) {
  assert(settings_.may_hold && wants_block());
  accept_rest(Rest{
      .line = at.line, .run_block = at.run_block, .waits = true, .cause = cause, .change = change});
}

void Planner::push_machine_wait(const RestPlace& at) {
  assert(settings_.may_hold && !rest_pending_);
  accept_rest(
      Rest{.line = at.line, .run_block = at.run_block, .waits = true, .asks_machine = true});
}

bool Planner::waits_at(parser::EventKind kind) const noexcept {
  return settings_.waits && parser::waits_for_answer(kind, settings_.optional_stop);
}

void Planner::push_change_at_rest(const interp::OutputChange& change, const RestPlace& at,
                                  double duration_s) {
  assert(wants_block());
  accept_rest(Rest{.duration_s = duration_s,
                   .line = at.line,
                   .run_block = at.run_block,
                   .follows = at.follows,
                   .change = change});
}

RestTime Planner::rest_time(const parser::EventMove& event) noexcept {
  const double time_s = event_time_.next_s(event);
  return {.planned_s = waits_at(event.kind) ? 0.0 : time_s, .expected_s = time_s};
}

void Planner::note_wait(const PlanWait& wait) noexcept {
  if (waits_pushed_.count < waits_pushed_.first.size()) {
    waits_pushed_.first[static_cast<std::size_t>(waits_pushed_.count)] = wait;
  }
  ++waits_pushed_.count;
  waits_pushed_.duration_s += wait.duration_s;
}

void Planner::push_change_at_motion(const interp::OutputChange& change) {
  emitter_.change_at_block(pushed_blocks_ + 1, change);
}

void Planner::push_change_at_next(const interp::OutputChange& change) {
  changes_for_next_.push_back(change);
}

void Planner::finish(std::uint32_t line) {
  assert(wants_block());
  accept(Rest{.line = line, .ends_program = true});
}

void Planner::end_with(const Rest& rest) {
  last_ = place_behind(rest);
  rest_ = rest;
  rest_pending_ = true;
  to_rest_ = true;
}

void Planner::plan_to_rest() {
  to_rest_ = true;
}

bool Planner::emit(Outbox& outbox) {
  return !held_ && !waits_ && !awaits_answer() && emit_next(outbox);
}

bool Planner::emit_next(Outbox& outbox) {
  take_waiting();
  const std::size_t first = outbox.phases.size();
  if (!schedule_->empty()) {
    if (is_stopped_by_feed()) {
      hold_by_feed(outbox);
      return true;
    }
    const Supply supply =
        to_rest_ ? Supply::to_rest : (wants_block() ? Supply::wanted : Supply::full);
    const bool emitted = schedule_->emit(blocks_, supply, emitter_, outbox);
    emitter_.keep(outbox, first);
    if (stands_in_ && !emitter_.is_on_block() && emitter_.ends_at_rest()) {
      empty_window();
    } else if (stands_in_ && outbox.phases.size() > first) {
      return_to_profile(outbox.phases.back());
    }
    return emitted;
  }
  if (rest_pending_) {
    emit_rest(outbox);
    emitter_.keep(outbox, first);
    return true;
  }
  to_rest_ = rest_.ends_program;
  return false;
}

void Planner::emit_rest(Outbox& outbox) {
  if (rest_.duration_s > 2.0 * rest_part_s_) {
    emitter_.emit_rest({.duration_s = rest_part_s_,
                        .line = rest_.line,
                        .run_block = rest_.run_block,
                        .follows = rest_.follows,
                        .changes_before = std::exchange(rest_.changes_before, {}),
                        .change = std::exchange(rest_.change, std::nullopt)},
                       outbox);
    rest_.duration_s -= rest_part_s_;
    return;
  }
  emitter_.emit_rest(rest_, outbox);
  waits_ = rest_.waits;
  asks_machine_ = rest_.asks_machine;
  outbox.phases.back().wait = waits_ ? ++waits_emitted_ : 0;
  outbox.phases.back().wait_cause = rest_.cause;
  rest_pending_ = false;
  to_rest_ = rest_.ends_program;
}

}  // namespace kerf::lookahead
