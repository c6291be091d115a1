#include "lookahead/planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/classical/classical_schedule.hpp"
#include "lookahead/optimum/optimum_schedule.hpp"
#include "lookahead/path/remainder.hpp"

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

// ahead: the items behind those that are emitted; those that end on the way go. No parts: it is at
// rest already.
void emit_stop(const std::vector<BrakingPart>& parts, std::deque<Item>& ahead, Emitter& emitter,
               Outbox& outbox) {
  for (const BrakingPart& part : parts) {
    auto& block = std::get<Block>(ahead.front());
    emitter.emit(block, part.law, part.s_end_mm, outbox);
    outbox.phases.back().active_constraint = interp::active_constraint(part.limit);
    if (part.ends_block) {
      emitter.end_block(std::move(block));
      ahead.pop_front();
    } else {
      emitter.end_segment(block, part.s_end_mm);
    }
  }
  if (parts.empty()) {
    emitter.emit_rest_here(outbox);
  } else {
    emitter.come_to_rest(outbox);
  }
}

}  // namespace

Planner::Planner(const PlannerSettings& settings)
    : settings_(settings),
      window_blocks_(is_optimum(settings) ? std::max(settings.window_blocks, kOptimumBlocks)
                                          : settings.window_blocks),
      scan_for_(scan_for_plan(settings)),
      schedule_(schedule_for(settings)),
      rest_part_s_(rest_part_s(settings)),
      emitter_(settings.limits.period_s, settings.may_hold) {
  assert(settings.window_blocks >= 2 && settings.window_cells >= 100);
}

bool Planner::has_room() const noexcept {
  return !to_rest_ && blocks_.size() < window_blocks_ && schedule_->has_room();
}

bool Planner::wants_block() const noexcept {
  return !held_ && !waits_ && waiting_.empty() && has_room();
}

void Planner::push(Block block) {
  ++pushed_blocks_;
  take(std::move(block));
}

void Planner::take(Block block) {
  assert(!rest_pending_ && block.length_mm > 0.0);
  blocks_.push_back(std::move(block));
  schedule_->push(blocks_);
}

void Planner::take_waiting() {
  while (!waiting_.empty() && has_room()) {
    if (auto* block = std::get_if<Block>(&waiting_.front())) {
      take(std::move(*block));
    } else {
      end_with(std::get<Rest>(waiting_.front()));
    }
    waiting_.pop_front();
  }
}

void Planner::push_rest(double duration_s, std::uint32_t line) {
  assert(duration_s >= 0.0 && wants_block());
  end_with({.duration_s = duration_s, .line = line});
}

void Planner::push_wait(const std::optional<interp::OutputChange>& change, std::uint32_t line) {
  assert(settings_.may_hold && wants_block());
  end_with({.line = line, .waits = true, .change = change});
}

bool Planner::waits_at(parser::EventKind kind) const noexcept {
  using parser::EventKind;
  return settings_.waits && (kind == EventKind::program_stop || kind == EventKind::pallet_change ||
                             kind == EventKind::tool_change ||
                             (kind == EventKind::optional_stop && settings_.optional_stop));
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

bool Planner::emit(Outbox& outbox) {
  if (held_ || waits_) {
    return false;
  }
  take_waiting();
  const std::size_t first = outbox.phases.size();
  if (!schedule_->empty()) {
    const Supply supply =
        to_rest_ ? Supply::to_rest : (wants_block() ? Supply::wanted : Supply::full);
    const bool emitted = schedule_->emit(blocks_, supply, emitter_, outbox);
    emitter_.keep(outbox, first);
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

std::vector<const Block*> Planner::blocks_ahead() const {
  std::vector<const Block*> ahead;
  const auto add = [&ahead](const Block& block) {
    ahead.push_back(block.whole ? block.whole.get() : &block);
  };
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    add(blocks_[i]);
  }
  for (std::size_t i = 0; i < waiting_.size() && !rest_pending_; ++i) {
    const auto* block = std::get_if<Block>(&waiting_[i]);
    if (block == nullptr) {
      break;
    }
    add(*block);
  }
  return ahead;
}

bool Planner::hold(std::int64_t tick, Outbox& outbox) {
  assert(settings_.may_hold && !held_ && outbox.phases.empty());
  const auto stop = find_stop(emitter_, blocks_ahead(), {.tick = tick}, settings_.limits);
  if (!stop) {
    return false;
  }
  if (stop->from.phase.ends_program) {
    return true;
  }
  empty_window();
  held_ = true;
  before_hold_.emplace(Before{emitter_, waiting_, waits_});
  waits_ = false;
  emitter_.take_back(stop->from, waiting_);
  emit_stop(stop->parts, waiting_, emitter_, outbox);
  outbox.phases.back().holds = true;
  emitter_.keep(outbox, 0);
  return true;
}

std::optional<Planner::StopAhead> Planner::stop_ahead(std::int64_t tick) {
  assert(settings_.may_hold && !held_);
  const std::vector<const Block*> blocks = blocks_ahead();
  auto stop =
      find_stop(emitter_, blocks, {.tick = tick, .effort = StopEffort::any}, settings_.limits);
  if (!stop) {
    return std::nullopt;
  }
  StopAhead ahead{.stop = std::move(*stop)};
  const std::vector<BrakingPart>& parts = ahead.stop.parts;
  const std::size_t needed = parts.empty() ? 1 : parts.back().block + 1;
  std::deque<Item> items;
  for (std::size_t i = 0; i < std::min(needed, blocks.size()); ++i) {
    items.emplace_back(*blocks[i]);
  }
  Emitter emitter = emitter_;
  emitter.take_back(ahead.stop.from, items);
  emit_stop(parts, items, emitter, ahead.outbox);
  ahead.plan = emitter.plan();
  emitter_.note_sent_by(emitter);
  return ahead;
}

Outbox Planner::follow_stop_ahead(const StopAhead& taken) {
  empty_window();
  waits_ = false;
  emitter_.take_back(taken.stop.from, waiting_);
  emitter_.repeat_plan(taken.plan);
  Outbox outbox;
  emit_stop(taken.stop.parts, waiting_, emitter_, outbox);
  emitter_.keep(outbox, 0);
  held_ = true;
  resume();
  return outbox;
}

bool Planner::stop(std::int64_t tick, Outbox& outbox) {
  if (!hold(tick, outbox)) {
    return false;
  }
  if (held_) {
    const std::size_t end = outbox.phases.size();
    emitter_.emit_rest({.ends_program = true}, outbox);
    emitter_.keep(outbox, end);
    stops_ = true;
  }
  return true;
}

void Planner::stop_held() {
  assert(held_);
  held_ = false;
  waiting_.clear();
  end_with({.ends_program = true});
}

void Planner::empty_window() {
  if (!waiting_.empty() && std::holds_alternative<Block>(waiting_.front())) {
    auto& block = std::get<Block>(waiting_.front());
    block = whole_of(std::move(block));
  }
  if (rest_pending_) {
    waiting_.push_front(rest_);
  }
  for (std::size_t i = blocks_.size(); i > 0; --i) {
    waiting_.push_front(whole_of(std::move(blocks_[i - 1])));
  }
  blocks_.keep_front(0);
  schedule_ = schedule_for(settings_);
  rest_ = {};
  rest_pending_ = to_rest_ = false;
}

void Planner::settle(bool accepted) {
  if (!accepted) {
    emitter_.restore(std::move(before_hold_->emitter));
    waiting_ = std::move(before_hold_->waiting);
    waits_ = before_hold_->waits;
    held_ = false;
  } else if (stops_) {
    waiting_.clear();
    held_ = false;
    to_rest_ = true;
  }
  stops_ = false;
  before_hold_.reset();
}

void Planner::resume() {
  waits_ = false;
  if (!held_) {
    return;
  }
  held_ = false;
  if (!emitter_.is_on_block()) {
    return;
  }
  const auto whole = std::make_shared<const Block>(std::move(std::get<Block>(waiting_.front())));
  if (auto remainder = remainder_of(whole, emitter_.curve_mm())) {
    waiting_.front() = std::move(*remainder);
    emitter_.begin_remainder();
  } else {
    emitter_.end_block(Block(*whole));
    waiting_.pop_front();
  }
}

void Planner::emit_rest(Outbox& outbox) {
  if (rest_.duration_s > 2.0 * rest_part_s_) {
    emitter_.emit_rest({.duration_s = rest_part_s_, .line = rest_.line}, outbox);
    rest_.duration_s -= rest_part_s_;
    return;
  }
  emitter_.emit_rest(rest_, outbox);
  outbox.phases.back().waits = waits_ = rest_.waits;
  rest_pending_ = false;
  to_rest_ = rest_.ends_program;
}

}  // namespace kerf::lookahead
