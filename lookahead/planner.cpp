#include "lookahead/planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/classical/classical_schedule.hpp"
#include "lookahead/optimum/optimum_schedule.hpp"

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

std::unique_ptr<Schedule> schedule_for(const PlannerSettings& settings) {
  const std::size_t ready_blocks = std::max<std::size_t>(settings.window_blocks / 2, 1);
  if (is_optimum(settings)) {
    return std::make_unique<OptimumSchedule>(
        OptimumSchedule::Settings{.limits = settings.limits,
                                  .window_cells = settings.window_cells,
                                  .ready_blocks = ready_blocks,
                                  .longest_phase_s = settings.longest_phase_s});
  }
  return std::make_unique<ClassicalSchedule>(
      ClassicalSchedule::Settings{.limits = settings.limits,
                                  .profile = settings.profile,
                                  .ready_blocks = ready_blocks,
                                  .longest_cruise_s = settings.longest_phase_s});
}

// Of whole ticks, so that parts do not move what follows.
double rest_part_s(const PlannerSettings& settings) {
  const double period = settings.limits.period_s;
  return std::max(std::floor(settings.longest_phase_s / period), 1.0) * period;
}

}  // namespace

Planner::Planner(const PlannerSettings& settings)
    : window_blocks_(is_optimum(settings) ? std::max(settings.window_blocks, kOptimumBlocks)
                                          : settings.window_blocks),
      scan_for_(scan_for_plan(settings)),
      schedule_(schedule_for(settings)),
      rest_part_s_(rest_part_s(settings)),
      emitter_(settings.limits.period_s) {
  assert(settings.window_blocks >= 2 && settings.window_cells >= 100);
}

bool Planner::wants_block() const noexcept {
  return !to_rest_ && blocks_.size() < window_blocks_ && schedule_->has_room();
}

void Planner::push(Block block) {
  assert(!rest_pending_ && block.length_mm > 0.0);
  ++pushed_blocks_;
  blocks_.push_back(std::move(block));
  schedule_->push(blocks_);
}

void Planner::push_rest(double duration_s, std::uint32_t line) {
  assert(duration_s >= 0.0 && wants_block());
  end_with({.duration_s = duration_s, .line = line});
}

void Planner::push_change_at_rest(const interp::OutputChange& change, std::uint32_t line) {
  assert(wants_block());
  end_with({.line = line, .change = change});
}

void Planner::push_change_at_motion(const interp::OutputChange& change) {
  emitter_.change_at_block(pushed_blocks_ + 1, change);
}

void Planner::finish(std::uint32_t line) {
  assert(wants_block());
  end_with({.line = line, .ends_program = true});
}

void Planner::end_with(const Rest& rest) {
  rest_ = rest;
  rest_pending_ = true;
  to_rest_ = true;
}

void Planner::plan_to_rest() {
  to_rest_ = true;
}

void Planner::stop() {
  if (rest_.ends_program && !rest_pending_) {
    return;
  }
  schedule_->stop(blocks_, emitter_);
  end_with({.ends_program = true});
}

bool Planner::emit(Outbox& outbox) {
  if (!schedule_->empty()) {
    const Supply supply =
        to_rest_ ? Supply::to_rest : (wants_block() ? Supply::wanted : Supply::full);
    return schedule_->emit(blocks_, supply, emitter_, outbox);
  }
  if (rest_pending_) {
    emit_rest(outbox);
    return true;
  }
  to_rest_ = rest_.ends_program;
  return false;
}

void Planner::emit_rest(Outbox& outbox) {
  if (rest_.duration_s > 2.0 * rest_part_s_) {
    emitter_.emit_rest({.duration_s = rest_part_s_, .line = rest_.line}, outbox);
    rest_.duration_s -= rest_part_s_;
    return;
  }
  emitter_.emit_rest(rest_, outbox);
  rest_pending_ = false;
  to_rest_ = rest_.ends_program;
}

}  // namespace kerf::lookahead
