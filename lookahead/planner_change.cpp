// Goes on with another plan, in motion: overrides, and single block.
#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "lookahead/optimum/optimum_schedule.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/path/remainder.hpp"
#include "lookahead/path/slowing.hpp"
#include "lookahead/planner.hpp"

namespace kerf::lookahead {

namespace {

// The limits of all that waits may change.
constexpr auto kAllItems = std::numeric_limits<std::size_t>::max();
// From ticks so far apart, twice as far each time, a way to rest is sought.
constexpr std::int64_t kMaxSteps = 64;

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

std::optional<Planner::ChangedPlan> Planner::change_plan(const PlanChange& change, Outbox& outbox) {
  assert(settings_.may_hold && !before_ && outbox.phases.empty());
  if (held_ && !is_held_by_feed()) {
    take_modes(change);
    limit_waiting();
    return ChangedPlan{};
  }
  const auto stop = find_our_stop({.tick = change.tick});
  const double wait_s = static_cast<double>(stop ? stop->from.when.tick - change.tick : 0) *
                        settings_.limits.period_s;
  if (!stop || (stop->parts.empty() && wait_s > kFarRest_s)) {
    return std::nullopt;
  }
  if (stop->from.phase.ends_program || emitter_.kept().is_last(stop->from)) {
    if (is_cut_) {
      return std::nullopt;
    }
    change_at_rest(change);
    return ChangedPlan{};
  }
  InMotion from{.stop = &*stop};
  if (const Block* before = emitter_.kept().blocks_from(stop->from).before) {
    from.before = *before;
  }
  take_back(stop->from, kAllItems);
  take_modes(change);
  ChangedPlan changed;
  if (!stop->parts.empty()) {
    const std::size_t slowed = let_slow_down(motion_of(*stop));
    limit_waiting(slowed);
    changed.slows_to_curve = emitter_.next_curve() + slowed - 1;
    step_behind(stop->parts.back().block);
    if (go_on_in_motion(std::move(from), change, changed, outbox)) {
      return changed;
    }
  } else {
    last_ = place_emitted();
    limit_waiting();
  }
  go_on_from_rest(stop->parts, change, changed, outbox);
  return changed;
}

// Of what was emitted nothing is left.
void Planner::change_at_rest(const PlanChange& change) {
  empty_window();
  last_ = place_emitted();
  take_modes(change);
  limit_waiting();
  if (!held_) {
    begin_rest_of_block();
  }
}

void Planner::go_on_from_rest(const std::vector<BrakingPart>& parts, const PlanChange& change,
                              ChangedPlan& changed, Outbox& outbox) {
  emit_stop(parts, waiting_, emitter_, outbox);
  emitter_.keep(outbox, outbox.phases.size() - 1);
  held_ = Held{};
  resume();
  if (change.needs_stop && !parts.empty()) {
    return;  // there is time to plan
  }
  const Emitter emitter = emitter_;
  const std::deque<Item> waiting = waiting_;
  const Outbox to_rest = outbox;
  if (!emit_first_part(change, changed, outbox)) {
    go_back(emitter, waiting);
    outbox = to_rest;
  }
}

// What was planned after it is dropped.
void Planner::go_back(const Emitter& emitter, const std::deque<Item>& waiting) {
  empty_window();
  emitter_ = emitter;
  waiting_ = waiting;
}

void Planner::take_modes(const PlanChange& change) {
  by_ = change.by;
  single_block_ = change.single_block;
  forget_steps();
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
  go_back(emitter, waiting);
  return false;
}

bool Planner::emit_first_part(const PlanChange& change, ChangedPlan& changed, Outbox& outbox) {
  for (std::int64_t until = change.until_tick, step = 1; step <= kMaxSteps; until += step *= 2) {
    while (!waits_ && !held_ && emitter_.now().tick < until && emit_next(outbox)) {
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

// Ticks see a jump of direction or curvature after the motion as long as it is near: what is left
// of a block is planned with a little of the way after, or the whole block with the one before it.
// Where the way to rest goes over more blocks than there may be cells, the motion rests.
bool Planner::begin_in_motion(InMotion from) {
  if (waiting_.empty() || !std::holds_alternative<Block>(waiting_.front()) ||
      from.stop->parts.back().block >= kMaxCellsInMotion) {
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
  stand_in();
  if (begin.has_before) {
    blocks_.push_back(last_part_of(*std::move(from.before), zone_mm));
    optimum.push_in_motion(blocks_);
  }
  last_ = place_of(waiting_.front());
  blocks_.push_back(std::move(std::get<Block>(waiting_.front())));
  waiting_.pop_front();
  optimum.push_in_motion(blocks_, begin.has_before ? begin.state.v_mm_s : 0.0);
  return take_blocks_in_motion(blocks_.size()) && optimum.begin(begin, to_rest_, blocks_);
}

// As many of those that wait as there is room for, up to a rest. False: the motion slows down on
// one for which there is no room.
bool Planner::take_blocks_in_motion(std::size_t taken) {
  const auto block_waits = [this] {
    return !waiting_.empty() && std::holds_alternative<Block>(waiting_.front());
  };
  while (has_room() && block_waits()) {
    take(std::move(std::get<Block>(waiting_.front())));
    waiting_.pop_front();
  }
  if (block_waits()) {
    return !std::get<Block>(waiting_.front()).slows;
  }
  to_rest_ = !waiting_.empty() || blocks_.size() == taken;
  if (!waiting_.empty()) {
    end_with(std::get<Rest>(waiting_.front()));
    waiting_.pop_front();
  }
  return true;
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

}  // namespace kerf::lookahead
