// What takes back the plan that was emitted: hold, stop, override, and what follows them.
#include <algorithm>
#include <cassert>
#include <utility>

#include "lookahead/optimum/optimum_schedule.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/path/remainder.hpp"
#include "lookahead/path/slowing.hpp"
#include "lookahead/planner.hpp"

namespace kerf::lookahead {

namespace {

// ahead: the items behind those that are emitted; those that end on the way go. No parts: it is at
// rest already. Keeps all phases but the last, which may change yet. The outbox is empty before.
void emit_stop(const std::vector<BrakingPart>& parts, std::deque<Item>& ahead, Emitter& emitter,
               Outbox& outbox) {
  for (const BrakingPart& part : parts) {
    auto& block = std::get<Block>(ahead.front());
    emitter.emit(block, part.law, part.s_end_mm, outbox);
    outbox.phases.back().active_constraint = interp::active_constraint(part.limit);
    if (outbox.phases.size() < parts.size()) {
      emitter.keep(outbox, outbox.phases.size() - 1);
    }
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

constexpr double kFarRest_s = 0.02;
// From ticks so far apart, twice as far each time, a way to rest is sought.
constexpr std::int64_t kMostSteps = 64;

OptimumSchedule::Begin motion_of(const PlanStop& stop) {
  constexpr int kPointsOfPart = 4;
  OptimumSchedule::Begin begin{.state = {.v_mm_s = stop.from.v_mm_s, .a_mm_s2 = stop.from.a_mm_s2}};
  begin.to_rest.push_back({.way_mm = 0.0, .v_mm_s = stop.from.v_mm_s});
  double way_mm = 0.0;
  for (const BrakingPart& part : stop.parts) {
    for (int i = 1; i <= kPointsOfPart; ++i) {
      const profiles::PathMotion at = part.law.at(part.law.duration_s() * i / kPointsOfPart);
      begin.to_rest.push_back({.way_mm = way_mm + at.s_mm, .v_mm_s = at.v_mm_s});
    }
    way_mm += part.law.length_mm();
  }
  return begin;
}

// A curve may be long, and only its end matters.
Block last_part_of(Block block, double length_mm) {
  if (std::holds_alternative<curves::NurbsCurve>(block.curve) &&
      2.0 * length_mm < block.length_mm) {
    if (auto end = stretch_of(
            block, {.begin_mm = block.length_mm - length_mm, .end_mm = block.length_mm})) {
      return *std::move(end);
    }
  }
  return block;
}

}  // namespace

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
  assert(settings_.may_hold && !held_ && !before_ && outbox.phases.empty());
  const auto stop = find_stop(emitter_, blocks_ahead(), {.tick = tick}, settings_.limits);
  if (!stop) {
    return false;
  }
  if (stop->from.phase.ends_program) {
    return true;
  }
  take_back(stop->from);
  held_ = true;
  emit_stop(stop->parts, waiting_, emitter_, outbox);
  outbox.phases.back().holds = true;
  emitter_.keep(outbox, outbox.phases.size() - 1);
  return true;
}

void Planner::take_back(const EmittedItems::Motion& from) {
  empty_window();
  before_.emplace(Before{emitter_, waiting_, waits_, by_, single_block_});
  waits_ = is_cut_ = false;
  last_.reset();
  emitter_.take_back(from, waiting_);
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
  waits_ = is_cut_ = false;
  last_.reset();
  emitter_.take_back(taken.stop.from, waiting_);
  emitter_.repeat_plan(taken.plan);
  Outbox outbox;
  emit_stop(taken.stop.parts, waiting_, emitter_, outbox);
  emitter_.keep(outbox, outbox.phases.size() - 1);
  held_ = true;
  resume();
  return outbox;
}

std::optional<Planner::ChangedPlan> Planner::change_plan(const PlanChange& change, Outbox& outbox) {
  assert(settings_.may_hold && !before_ && outbox.phases.empty());
  if (held_) {
    by_ = change.by;
    single_block_ = change.single_block;
    forget_steps();
    limit_waiting();
    return ChangedPlan{};
  }
  const auto stop = find_stop(emitter_, blocks_ahead(), {.tick = change.tick}, settings_.limits);
  // Behind a rest that is far nothing else could be asked for before the tool has come to it.
  const double wait_s = static_cast<double>(stop ? stop->from.when.tick - change.tick : 0) *
                        settings_.limits.period_s;
  if (!stop || (stop->parts.empty() && wait_s > kFarRest_s)) {
    return std::nullopt;
  }
  if (stop->from.phase.ends_program || emitter_.kept().is_last(stop->from)) {
    by_ = change.by;
    single_block_ = change.single_block;
    empty_window();
    forget_steps();
    limit_waiting();
    begin_rest_of_block();
    return ChangedPlan{};
  }
  InMotion from{.stop = &*stop};
  if (const Block* before = emitter_.kept().blocks_from(stop->from).before) {
    from.before = *before;
  }
  take_back(stop->from);
  by_ = change.by;
  single_block_ = change.single_block;
  forget_steps();
  ChangedPlan changed;
  if (stop->parts.empty()) {
    limit_waiting();
  } else {
    const std::size_t slowed = let_slow_down(motion_of(*stop));
    limit_waiting(slowed);
    changed.slows_to_curve = emitter_.next_curve() + slowed - 1;
  }
  if (single_block_ && !stop->parts.empty()) {
    step_behind(stop->parts.back().block);
  }
  if (!stop->parts.empty() && go_on_in_motion(std::move(from), change, changed, outbox)) {
    return changed;
  }
  emit_stop(stop->parts, waiting_, emitter_, outbox);
  emitter_.keep(outbox, outbox.phases.size() - 1);
  held_ = true;
  resume();
  if (stop->parts.empty() || !change.needs_stop) {  // it may be over at once
    emit_first_part(change, changed, outbox);
  }
  return changed;
}

Planner::ProgramPlace Planner::place_of(const Item& item) {
  if (const auto* rest = std::get_if<Rest>(&item)) {
    return {.line = rest->line, .end_line = rest->line};
  }
  const Block& block = std::get<Block>(item);
  return {.line = block.line,
          .run_block = block.run_block,
          .end_line = block.mark_at(block.length_mm).line};
}

bool Planner::is_same_block(const ProgramPlace& before, const ProgramPlace& after) {
  return before.line == after.line &&
         (before.run_block == after.run_block || before.run_block == 0 || after.run_block == 0);
}

bool Planner::steps_before(const Item& next) const {
  return single_block_ && last_ && !is_same_block(*last_, place_of(next));
}

void Planner::end_with_step() {
  end_with({.line = last_->end_line, .waits = true, .steps = true});
}

void Planner::step_behind(std::size_t item) {
  for (; item + 1 < waiting_.size(); ++item) {
    const ProgramPlace place = place_of(waiting_[item]);
    if (!is_same_block(place, place_of(waiting_[item + 1]))) {
      waiting_.insert(waiting_.begin() + static_cast<std::ptrdiff_t>(item) + 1,
                      Rest{.line = place.end_line, .waits = true, .steps = true});
      return;
    }
  }
}

void Planner::forget_steps() {
  std::erase_if(waiting_, [](const Item& item) {
    const auto* rest = std::get_if<Rest>(&item);
    return rest != nullptr && rest->steps;
  });
}

void Planner::limit_waiting(std::size_t first) {
  for (std::size_t i = first; i < waiting_.size(); ++i) {
    if (auto* block = std::get_if<Block>(&waiting_[i])) {
      set_limits(by_, settings_.limits, scan_for_, *block);
    }
  }
}

bool Planner::go_on_in_motion(InMotion from, const PlanChange& change, ChangedPlan& changed,
                              Outbox& outbox) {
  const Emitter emitter = emitter_;
  const std::deque<Item> waiting = waiting_;
  if (begin_in_motion(std::move(from)) && emit_first_part(change, changed, outbox)) {
    return true;
  }
  outbox.clear();
  changed.stop.reset();
  empty_window();
  emitter_ = emitter;
  waiting_ = waiting;
  return false;
}

bool Planner::emit_first_part(const PlanChange& change, ChangedPlan& changed, Outbox& outbox) {
  for (std::int64_t until = change.until_tick, step = 1; step <= kMostSteps; until += step *= 2) {
    while (!waits_ && emitter_.now().tick < until && emit_next(outbox)) {
    }
    if (outbox.phases.empty()) {
      return false;
    }
    if (!change.needs_stop || emitter_.ends_at_rest()) {
      return true;
    }
    changed.stop = stop_ahead(emitter_.now().tick);
    if (changed.stop) {
      return true;
    }
  }
  return false;
}

// Ticks see a jump of direction or curvature behind the motion as long as it is near: what is left
// of a block is planned with a little of the way behind, or the whole block with the one before it.
bool Planner::begin_in_motion(InMotion from) {
  if (waiting_.empty() || !std::holds_alternative<Block>(waiting_.front())) {
    return false;
  }
  OptimumSchedule::Begin begin = motion_of(*from.stop);
  const double zone_mm = junction_zone_mm(begin.state, settings_.limits);
  const double length_mm = std::get<Block>(waiting_.front()).length_mm;
  begin.s_mm = emitter_.is_on_block() ? emitter_.curve_mm() : 0.0;
  begin.has_before = from.before && begin.s_mm < zone_mm;
  if (begin.s_mm > length_mm - kAtBlockEnd_mm) {
    return false;
  }
  if (emitter_.is_on_block() && !begin.has_before) {
    begin.s_mm = std::min(zone_mm, begin.s_mm);
    begin_rest_of_block(begin.s_mm);
  }
  auto schedule = std::make_unique<OptimumSchedule>(optimum_settings());
  OptimumSchedule& optimum = *schedule;
  schedule_ = std::move(schedule);
  stands_in_ = settings_.profile.kind() != profiles::ProfileKind::time_optimal;
  if (begin.has_before) {
    blocks_.push_back(last_part_of(*std::move(from.before), zone_mm));
    optimum.push_in_motion(blocks_);
  }
  blocks_.push_back(std::move(std::get<Block>(waiting_.front())));
  waiting_.pop_front();
  optimum.push_in_motion(blocks_);
  while (!waiting_.empty() && has_room() && std::holds_alternative<Block>(waiting_.front())) {
    take(std::move(std::get<Block>(waiting_.front())));
    waiting_.pop_front();
  }
  const bool is_cut = !waiting_.empty() && std::holds_alternative<Block>(waiting_.front());
  if (is_cut && std::get<Block>(waiting_.front()).slows) {
    return false;
  }
  to_rest_ = !is_cut && (!waiting_.empty() || blocks_.size() == (begin.has_before ? 2U : 1U));
  if (to_rest_ && !waiting_.empty()) {
    end_with(std::get<Rest>(waiting_.front()));
    waiting_.pop_front();
  }
  return optimum.begin(begin, to_rest_, blocks_);
}

std::size_t Planner::let_slow_down(const OptimumSchedule::Begin& from) {
  std::vector<Block*> ahead;
  for (Item& item : waiting_) {
    auto* block = std::get_if<Block>(&item);
    if (block == nullptr) {
      break;
    }
    ahead.push_back(block);
  }
  return lookahead::let_slow_down(
      {.motion = {.s_mm = emitter_.is_on_block() ? emitter_.curve_mm() : 0.0,
                  .v_mm_s = from.state.v_mm_s,
                  .a_mm_s2 = from.state.a_mm_s2},
       .to_rest_mm = from.to_rest.back().way_mm,
       .by = by_,
       .plan = scan_for_},
      settings_.limits, ahead);
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
  if (!blocks_.empty() || rest_pending_) {
    last_.reset();
  }
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
  schedule_ = new_schedule();
  stands_in_ = false;
  rest_ = {};
  rest_pending_ = to_rest_ = false;
}

void Planner::settle(bool accepted) {
  if (!accepted) {
    empty_window();
    emitter_.restore(std::move(before_->emitter));
    waiting_ = std::move(before_->waiting);
    waits_ = before_->waits;
    by_ = before_->by;
    single_block_ = before_->single_block;
    held_ = false;
    is_cut_ = !emitter_.ends_at_rest();
    if (!is_cut_) {
      begin_rest_of_block();
    }
  } else if (stops_) {
    waiting_.clear();
    held_ = false;
    to_rest_ = true;
  }
  stops_ = false;
  before_.reset();
}

void Planner::resume() {
  waits_ = false;
  if (!held_) {
    return;
  }
  held_ = false;
  if (emitter_.is_on_block() && std::get<Block>(waiting_.front()).slows) {
    set_limits(by_, settings_.limits, scan_for_, std::get<Block>(waiting_.front()));
  }
  begin_rest_of_block();
}

// On the block that waits first. Hardly a way: the block is over.
void Planner::begin_rest_of_block(double before_mm) {
  if (!emitter_.is_on_block()) {
    return;
  }
  const auto whole = std::make_shared<const Block>(std::move(std::get<Block>(waiting_.front())));
  if (auto remainder = remainder_of(whole, emitter_.curve_mm() - before_mm)) {
    waiting_.front() = std::move(*remainder);
    emitter_.begin_remainder(before_mm);
  } else {
    emitter_.end_block(Block(*whole));
    waiting_.pop_front();
  }
}

}  // namespace kerf::lookahead
