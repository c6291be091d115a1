#include "lookahead/optimum/optimum_schedule.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/optimum/fallback.hpp"

namespace kerf::lookahead {

namespace {

constexpr int kCuts = 5;  // of what a plan covers
// Where no plan is found from a place in motion: of the cells that are left, how far on it is tried
// again.
constexpr std::size_t kTriesOfRest = 8;
constexpr std::size_t kMinBetweenTries = 8;
constexpr std::size_t kCutCells = 16;
// Of a plan's cells, before those on which it brakes for what is not known yet: they feel its end.
// Where it is to rest at a junction it brakes later than it may if it passes that in motion.
constexpr std::size_t kMarginOfWindow = 8;
constexpr std::size_t kMinMargin = 200;
// What a plan in motion takes, unless the one before it brakes for its end over more than a
// quarter.
constexpr std::size_t kCellsInMotion = 1000;
constexpr std::size_t kLongBraking = 4;

PlanDegradation degradation_on(const Block& block, double s_mm) {
  const LineMark mark = block.mark_at(s_mm);
  return {.line = mark.line, .s_mm = s_mm - mark.s_mm};
}

ClassicalSchedule::Settings classical(const OptimumSchedule::Settings& settings) {
  return {.limits = settings.limits,
          .profile = profiles::Profile(profiles::ProfileKind::s_curve),
          .ready_blocks = settings.ready_blocks,
          .longest_cruise_s = settings.longest_phase_s,
          .observer = settings.observer};
}

}  // namespace

OptimumSchedule::OptimumSchedule(const Settings& settings)
    : settings_(settings), classical_(classical(settings)), waiting_(settings.limits) {}

void OptimumSchedule::push(const Window<Block>& blocks) {
  if (classical_.push(blocks)) {
    waiting_.skip_next();
  } else {
    waiting_.push(blocks);
  }
}

void OptimumSchedule::push_in_motion(const Window<Block>& blocks) {
  waiting_.push_as_cells(blocks);
}

bool OptimumSchedule::begin(const Begin& from, bool closed, Window<Block>& blocks) {
  if (closed) {
    waiting_.close(blocks);
  }
  const std::size_t count = prepare_to_begin(from, waiting_, blocks);
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
  const std::size_t count = plan_.cells().size();
  const bool brakes_long = window_brake_ < count - count / kLongBraking;
  return cells_left() == 0 || brakes_long ? settings_.window_cells
                                          : std::min(settings_.window_cells, kCellsInMotion);
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
    follow_classical(blocks);
    return;
  }
  const WindowSearch search = this->search(blocks);
  const bool from_rest = cells_left() == 0;
  FoundPlan found = search.over_all();
  if (from_rest && settings_.takes_classical && waiting_.front().cell.s_begin_mm == 0.0) {
    const auto faster =
        faster_fallback(tried_to_block_end(found, search, blocks), blocks, classical_.settings());
    if (faster && !found.ended_well()) {
      fall_back(*faster, blocks, emitter);
      return;
    }
    if (faster) {
      follow_classical(blocks);
      return;
    }
  }
  for (int i = 0; i < kCuts && from_rest && !found.ended_well() && found.count >= kCutCells; ++i) {
    cut(found.count, blocks, emitter);
    found = search.over({.begin = 0, .end = waiting_.size()});
  }
  if (!found.plan) {
    try_again_later(blocks, emitter);
    return;
  }
  if (found.plan->slowed_down()) {
    const Cell& first = waiting_.front().cell;
    emitter.note(degradation_on(waiting_.block_of(first, blocks), first.s_begin_mm));
  }
  adopt(std::move(found));
}

PlannedCells OptimumSchedule::tried_to_block_end(const FoundPlan& found, const WindowSearch& search,
                                                 const Window<Block>& blocks) const {
  PlannedCells planned = search.planned_to_block_end(found);
  std::size_t first_block = 1;  // its cells
  while (first_block < waiting_.size() && !waiting_[first_block - 1].ends_block) {
    ++first_block;
  }
  if (!found.is_shorter || planned.count >= first_block || first_block > kFewCells) {
    return planned;
  }
  Settings settings = settings_;
  settings.observer = nullptr;  // nothing of it is run
  settings.takes_classical = false;
  OptimumSchedule schedule(settings);
  planned.count = first_block;
  planned.duration_s =
      duration_from_rest_s(schedule, {.blocks = &blocks, .count = 1}, settings_.limits);
  planned.failed = false;
  planned.tried = true;
  return planned;
}

void OptimumSchedule::adopt(FoundPlan found) {
  plan_ends_at_stop_ = waiting_[found.count - 1].rest_after;
  waiting_.drop(found.count);
  plan_ = std::move(*found.plan);
  place_ = {};
  const std::size_t count = plan_.cells().size();
  window_brake_ = plan_ends_at_stop_ ? count : plan_.last_braking();
  const auto relaxed = static_cast<std::size_t>(
      std::ranges::count_if(plan_.cells(), [](const Cell& cell) { return cell.relaxed; }));
  const std::size_t margin = std::max(count / kMarginOfWindow, kMinMargin) + relaxed;
  renew_ = std::max(count / 2, window_brake_ - std::min(window_brake_, margin));
}

void OptimumSchedule::follow_classical(const Window<Block>& blocks) {
  assert(cells_left() == 0);
  waiting_.drop_blocks(classical_.follow(blocks, waiting_.has_open_block()));
  if (classical_.goes_on()) {
    waiting_.drop_open();
  }
}

// From another place the search may well end; what the plan still holds ends at rest if not.
void OptimumSchedule::try_again_later(const Window<Block>& blocks, Emitter& emitter) {
  const std::size_t next = place_.cell + std::max(cells_left() / kTriesOfRest, kMinBetweenTries);
  if (next + kMinBetweenTries < plan_.cells().size()) {
    renew_ = next;
    return;
  }
  renew_ = plan_.cells().size();
  note_stop(plan_.cells().back(), blocks, emitter);
}

void OptimumSchedule::fall_back(const Fallback& fallback, const Window<Block>& blocks,
                                Emitter& emitter) {
  const Cell& first = waiting_.front().cell;
  PlanDegradation degradation = degradation_on(waiting_.block_of(first, blocks), first.s_begin_mm);
  degradation.kind = PlanDegradation::Kind::classical;
  emitter.note(degradation);
  const Cell& last = waiting_[fallback.cells - 1];
  if (!last.rest_after) {
    note_stop(last, blocks, emitter);
  }
  if (settings_.observer) {
    settings_.observer->took_classical(fallback.blocks);
  }
  classical_.take(blocks, fallback.blocks);
  waiting_.drop(fallback.cells);
}

void OptimumSchedule::cut(std::size_t count, const Window<Block>& blocks, Emitter& emitter) {
  const std::size_t margin = count / 4;
  std::size_t sharpest = margin;
  double most = 0.0;
  for (std::size_t i = margin; i < count - margin; ++i) {
    const double curvature = curves::vec(waiting_[i].end.second_per_mm).norm();
    if (curvature > most) {
      most = curvature;
      sharpest = i;
    }
  }
  waiting_.rest_after(sharpest);
  note_stop(waiting_[sharpest], blocks, emitter);
}

void OptimumSchedule::note_stop(const Cell& cell, const Window<Block>& blocks,
                                Emitter& emitter) const {
  PlanDegradation stop = degradation_on(waiting_.block_of(cell, blocks), cell.s_end_mm());
  stop.kind = PlanDegradation::Kind::stop;
  emitter.note(stop);
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
