#include "lookahead/optimum/optimum_schedule.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "lookahead/optimum/fallback.hpp"

namespace kerf::lookahead {

namespace {

// Of a plan's cells, before those on which it brakes for what is not known yet: they feel its end.
// Where it is to rest at a junction it brakes later than it may if it passes that in motion.
constexpr std::size_t kMarginOfWindow = 8;
constexpr std::size_t kMinMargin = 200;

ClassicalSchedule::Settings classical(const OptimumSchedule::Settings& settings) {
  return {.limits = settings.limits,
          .profile = profiles::Profile(profiles::ProfileKind::s_curve),
          .ready_blocks = settings.ready_blocks,
          .longest_cruise_s = settings.longest_phase_s,
          .observer = settings.observer};
}

}  // namespace

OptimumSchedule::OptimumSchedule(const Settings& settings)
    : settings_(settings),
      classical_(classical(settings)),
      waiting_(settings.limits, settings.ready_blocks) {}

void OptimumSchedule::push(const Window<Block>& blocks) {
  if (classical_.push(blocks)) {
    waiting_.skip_next();
  } else {
    waiting_.push(blocks);
  }
}

void OptimumSchedule::push_in_motion(const Window<Block>& blocks, double passed_mm_s) {
  waiting_.push_as_cells(blocks, passed_mm_s);
}

bool OptimumSchedule::begin(const Begin& from, bool closed, Window<Block>& blocks) {
  if (closed) {
    waiting_.close(blocks);
  }
  const std::size_t count = prepare_to_begin(from, settings_.limits, waiting_, blocks);
  if (count == 0) {
    return false;
  }
  plan_ = OptimalPlan(from.state);
  FoundPlan found = search(blocks).over({.begin = 0, .end = count});
  if (!found.plan) {
    return false;
  }
  adopt(std::move(found));
  return true;
}

bool OptimumSchedule::empty() const {
  return classical_.empty() && cells_left() == 0 && waiting_.empty() && !waiting_.has_open_block();
}

bool OptimumSchedule::has_room() const {
  return waiting_.size() < max_cells();
}

std::size_t OptimumSchedule::max_cells() const {
  return cells_left() == 0 || brakes_long_ ? settings_.window_cells
                                           : std::min(settings_.window_cells, kCellsOfPlan);
}

bool OptimumSchedule::is_to_be_renewed() const {
  return classical_.empty() &&
         (cells_left() == 0 || (place_.cell >= renew_ && !plan_ends_at_stop_));
}

bool OptimumSchedule::emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox) {
  assert(!empty());
  if (supply == Supply::to_rest) {
    waiting_.close(blocks);
  }
  if (is_to_be_renewed()) {
    if (supply == Supply::wanted) {
      return false;
    }
    if (!waiting_.empty()) {
      plan(blocks, emitter);
    }
  }
  if (!classical_.empty()) {
    const std::uint64_t blocks_before = blocks.size();
    if (!classical_.emit(blocks, supply, emitter, outbox)) {
      return false;
    }
    for (std::uint64_t left = blocks.size(); left < blocks_before; ++left) {
      waiting_.block_done();
    }
    return true;
  }
  emit_cell(blocks, emitter, outbox);
  return true;
}

WindowSearch OptimumSchedule::search(const Window<Block>& blocks) const {
  return {
      {.limits = &settings_.limits, .max_cells = max_cells(), .observer = settings_.observer.get()},
      {.waiting = &waiting_, .plan = &plan_, .place = place_, .path = waiting_.path_of(blocks)}};
}

void OptimumSchedule::plan(Window<Block>& blocks, Emitter& emitter) {
  if (waiting_.front().whole_line) {
    follow_classical(blocks, profiles::ProfileKind::s_curve);
    return;
  }
  const WindowSearch search = this->search(blocks);
  const bool from_rest = cells_left() == 0;
  FoundPlan found = search.over_all();
  if (from_rest && settings_.takes_classical && waiting_.front().cell.s_begin_mm == 0.0) {
    const auto faster = faster_fallback(tried_to_block_end(found, search, blocks),
                                        {.blocks = &blocks, .count = classical_.run_length(blocks)},
                                        classical_.settings());
    if (faster && !found.ended_well()) {
      fall_back(*faster, blocks, emitter);
      return;
    }
    if (faster) {
      follow_classical(blocks, faster->profile);
      return;
    }
  }
  if (from_rest && !found.ended_well()) {
    found = search_with_cut(std::move(found), search, blocks, emitter);
  }
  if (!found.plan) {
    try_again_later(blocks, emitter);
    return;
  }
  if (found.plan->slowed_down()) {
    note_slow_plan(blocks, emitter);
  }
  adopt(std::move(found));
}

void OptimumSchedule::adopt(FoundPlan found) {
  plan_ends_at_stop_ = waiting_[found.count - 1].rest_after;
  waiting_.drop(found.count);
  plan_ = std::move(*found.plan);
  place_ = {};
  const std::size_t count = plan_.cells().size();
  window_brake_ = plan_ends_at_stop_ ? count : plan_.last_braking();
  brakes_long_ = !plan_ends_at_stop_ && plan_.brakes_long();
  const auto relaxed = static_cast<std::size_t>(
      std::ranges::count_if(plan_.cells(), [](const Cell& cell) { return cell.relaxed; }));
  const std::size_t margin = std::max(count / kMarginOfWindow, kMinMargin) + relaxed;
  renew_ = std::max(count / 2, window_brake_ - std::min(window_brake_, margin));
}

void OptimumSchedule::follow_classical(const Window<Block>& blocks, profiles::ProfileKind profile) {
  assert(cells_left() == 0);
  classical_.use(profile);
  waiting_.drop_blocks(classical_.follow(blocks, waiting_.has_open_block()));
  if (classical_.goes_on()) {
    waiting_.drop_open();
  }
}

void OptimumSchedule::emit_cell(Window<Block>& blocks, Emitter& emitter, Outbox& outbox) {
  const Cell& cell = plan_.cells()[place_.cell];
  const Block& block = blocks.front();
  const profiles::CellLaw law = plan_.law_from(place_, settings_.longest_phase_s);
  const double end = place_.offset_mm + law.length_mm();
  const bool whole = end >= cell.length_mm;
  const bool ends_block = whole && cell.ends_block;
  const double s_end = ends_block ? block.length_mm : cell.s_begin_mm + end;
  emitter.emit(block, law, s_end, outbox);
  const bool brakes = place_.cell >= window_brake_ && !plan_ends_at_stop_;
  outbox.phases.back().active_constraint = interp::active_constraint(
      brakes ? Constraint::window_end : plan_.limit_on(place_.cell, settings_.limits));
  if (!whole) {
    place_.offset_mm = end;
    return;
  }
  place_ = {.cell = place_.cell + 1};
  if (ends_block) {
    emitter.end_block(std::move(blocks.front()));
    blocks.pop_front();
    waiting_.block_done();
  } else {
    emitter.end_segment(block, s_end);
  }
  if (cells_left() == 0) {
    emitter.come_to_rest(outbox);
  }
}

}  // namespace kerf::lookahead
