// What takes back the plan that was emitted: hold, stop, a stop ahead, and what follows them.
#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "lookahead/path/block_builder.hpp"
#include "lookahead/path/remainder.hpp"
#include "lookahead/planner.hpp"

namespace kerf::lookahead {

namespace {

// The blocks that a way to rest is on, at the most.
std::size_t needed_for(const std::vector<BrakingPart>& parts) {
  return parts.empty() ? 1 : parts.back().block + 1;
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

bool Planner::hold(const StopOrder& order, Outbox& outbox) {
  assert(settings_.may_hold && !before_ && outbox.phases.empty());
  const auto stop = find_our_stop(order);
  if (stop && waits_ && emitter_.kept().is_last(stop->from)) {
    return !asks_machine_;
  }
  return stop && may_hold_at(stop->from) && hold_at(*stop, outbox);
}

// After a tap the tool may rest at the end of its last motion.
bool Planner::may_hold_at(const EmittedItems::Motion& motion) const {
  if (motion.phase.follows_hold) {
    return true;
  }
  const bool is_tap_left =
      !blocks_.empty() ? !blocks_[0].follows.hold
      : rest_pending_  ? !rest_.follows.hold
      : !waiting_.empty()
          ? std::visit([](const auto& item) { return !item.follows.hold; }, waiting_.front())
          : false;
  return emitter_.kept().is_last(motion) && !is_tap_left;
}

std::optional<PlanStop> Planner::find_our_stop(const StopOrder& order) const {
  return find_stop(emitter_, blocks_ahead(), order, settings_.limits);
}

bool Planner::hold_at(const PlanStop& stop, Outbox& outbox) {
  assert(!held_ || is_held_by_feed());
  if (stop.from.phase.ends_program) {
    return !is_cut_;
  }
  take_back(stop.from, needed_for(stop.parts));
  held_ = Held{};
  emit_stop(stop.parts, waiting_, emitter_, outbox);
  outbox.phases.back().holds = true;
  emitter_.keep(outbox, outbox.phases.size() - 1);
  return true;
}

void Planner::take_back(const EmittedItems::Motion& from, std::size_t changing) {
  std::unique_ptr<Schedule> schedule = std::exchange(schedule_, nullptr);
  empty_window();
  const std::size_t first = std::min(changing, waiting_.size());
  before_.emplace(
      Before{.emitter = emitter_,
             .changing = {waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first)},
             .others = waiting_.size() - first,
             .schedule = std::move(schedule),
             .waits = waits_,
             .waits_emitted = waits_emitted_,
             .asks_machine = asks_machine_,
             .by = by_,
             .single_block = single_block_,
             .last = last_,
             .is_cut = is_cut_});
  waits_ = is_cut_ = false;
  held_.reset();
  last_.reset();
  emitter_.take_back(from, waiting_);
}

std::optional<Planner::PlannedStopAhead> Planner::stop_ahead(std::int64_t tick) {
  assert(settings_.may_hold && (!held_ || is_held_by_feed()));
  const std::vector<const Block*> blocks = blocks_ahead();
  auto stop =
      find_stop(emitter_, blocks, {.tick = tick, .effort = StopEffort::any}, settings_.limits);
  if (!stop) {
    return std::nullopt;
  }
  PlannedStopAhead ahead{.stop = std::move(*stop)};
  const std::vector<BrakingPart>& parts = ahead.stop.parts;
  std::deque<Item> items;
  for (std::size_t i = 0; i < std::min(needed_for(parts), blocks.size()); ++i) {
    items.emplace_back(*blocks[i]);
  }
  Emitter emitter = emitter_;
  emitter.take_back(ahead.stop.from, items);
  emit_stop(parts, items, emitter, ahead.outbox);
  ahead.plan = emitter.plan();
  emitter_.note_sent_by(emitter);
  return ahead;
}

Outbox Planner::follow_stop_ahead(const PlannedStopAhead& taken) {
  empty_window();
  waits_ = is_cut_ = false;
  last_.reset();
  emitter_.take_back(taken.stop.from, waiting_);
  emitter_.repeat_plan(taken.plan);
  Outbox outbox;
  emit_stop(taken.stop.parts, waiting_, emitter_, outbox);
  emitter_.keep(outbox, outbox.phases.size() - 1);
  held_ = Held{};
  resume();
  return outbox;
}

Outbox Planner::follow_probe(const ProbeStop& stop) {
  empty_window();
  waits_ = is_cut_ = false;
  held_.reset();
  last_.reset();
  emitter_.take_back(emitter_.motion_at(stop.tick), waiting_);
  emitter_.repeat_plan(stop.plan);
  std::vector<BrakingPart> parts;
  double s_mm = emitter_.s_mm();
  for (const profiles::CellLaw& law : stop.laws) {
    s_mm += law.length_mm();
    parts.push_back({.law = law, .s_end_mm = s_mm, .limit = Constraint::path_jerk});
  }
  Outbox outbox;
  const auto* not_begun =
      emitter_.is_on_block() || waiting_.empty() ? nullptr : std::get_if<Block>(&waiting_.front());
  if (not_begun != nullptr) {  // the tick side is on it, at its begin
    emitter_.emit(*not_begun, profiles::Transition::rest(0.0), 0.0, outbox);
    emitter_.come_to_rest(outbox);
  } else {
    emit_stop(parts, waiting_, emitter_, outbox);
  }
  emitter_.keep(outbox, outbox.phases.size() - 1);
  const Rest rest = drop_to_machine_wait(s_mm);
  emitter_.go_on_at(stop.rest_tick);
  Outbox of_rest;
  emitter_.emit_rest({.line = rest.line, .run_block = rest.run_block}, of_rest);
  emitter_.keep(of_rest, 0);
  last_ = place_of(rest);
  return outbox;
}

Rest Planner::drop_to_machine_wait(double s_mm) {
  Rest rest;
  for (; !rest.asks_machine && !waiting_.empty(); waiting_.pop_front()) {
    auto* const block = std::get_if<Block>(&waiting_.front());
    if (block == nullptr) {
      rest = std::get<Rest>(waiting_.front());
    } else if (emitter_.is_on_block()) {
      auto run = s_mm > 0.0 ? stretch_of(*block, {.begin_mm = 0.0, .end_mm = s_mm}) : std::nullopt;
      emitter_.end_block_here(run ? *std::move(run) : std::move(*block));
    }
  }
  return rest;
}

bool Planner::stop(const StopOrder& order, Outbox& outbox) {
  assert(settings_.may_hold && !before_ && outbox.phases.empty());
  const auto stop = find_our_stop(order);
  if (!stop || !may_hold_at(stop->from) || !hold_at(*stop, outbox)) {
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
  held_.reset();
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

void Planner::wait_as_before() {
  assert(waiting_.size() >= before_->others);
  const auto first = static_cast<std::ptrdiff_t>(waiting_.size() - before_->others);
  waiting_.erase(waiting_.begin(), waiting_.begin() + first);
  waiting_.insert(waiting_.begin(), std::make_move_iterator(before_->changing.begin()),
                  std::make_move_iterator(before_->changing.end()));
}

void Planner::settle(bool accepted) {
  if (!accepted) {
    empty_window();
    emitter_.restore(std::move(before_->emitter));
    wait_as_before();
    waits_ = before_->waits;
    waits_emitted_ = before_->waits_emitted;
    asks_machine_ = before_->asks_machine;
    by_ = before_->by;
    single_block_ = before_->single_block;
    last_ = before_->last;
    held_.reset();
    is_cut_ = before_->is_cut || !emitter_.ends_at_rest();
    if (!is_cut_) {
      begin_rest_of_block();
    }
  } else if (stops_) {
    waiting_.clear();
    held_.reset();
    to_rest_ = true;
  }
  stops_ = false;
  before_.reset();
}

void Planner::resume() {
  waits_ = false;
  if (!std::exchange(held_, std::nullopt)) {
    return;
  }
  if (!emitter_.is_on_block()) {
    last_ = place_emitted();
  } else if (std::get<Block>(waiting_.front()).slows) {
    set_limits(by_, settings_.limits, scan_for_, std::get<Block>(waiting_.front()));
  }
  begin_rest_of_block();
}

// On the block that waits first. Hardly a way: the block is over.
void Planner::begin_rest_of_block(double before_mm) {
  if (!emitter_.is_on_block()) {
    return;
  }
  last_ = place_of(waiting_.front());
  const auto whole = std::make_shared<const Block>(std::move(std::get<Block>(waiting_.front())));
  if (auto remainder = remainder_of(whole, emitter_.curve_mm() - before_mm)) {
    waiting_.front() = std::move(*remainder);
    last_ = place_of(waiting_.front());  // of a curve for several lines: farther
    emitter_.begin_remainder(before_mm);
  } else {
    emitter_.end_block(Block(*whole));
    waiting_.pop_front();
  }
}

}  // namespace kerf::lookahead
