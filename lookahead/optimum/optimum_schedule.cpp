#include "lookahead/optimum/optimum_schedule.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lookahead/optimum/fallback.hpp"
#include "lookahead/optimum/grid/grid.hpp"

namespace kerf::lookahead {

namespace {

constexpr int kCuts = 5;  // of what a plan covers
// Where no plan is found from a place in motion: of the cells that are left, how far on it is tried
// again.
constexpr std::size_t kTriesOfRest = 8;
constexpr std::size_t kMinBetweenTries = 8;
constexpr std::size_t kCutCells = 16;
// A search over fewer cells, half as many each time, may end well where one over all does not.
constexpr int kShorterSearches = 3;
constexpr std::size_t kMinShorter = 200;
// That are planned at once from a motion: the answer is urgent, and what follows is added later.
constexpr std::size_t kCellsInMotion = 600;
constexpr std::size_t kFewestInMotion = 3;
// On the way that it would take to rest.
constexpr double kCellsToRest = 40.0;
// Of a plan's cells, before those on which it brakes for what is not known yet: they feel its end.
// Where it is to rest at a junction it brakes later than it may if it passes that in motion.
constexpr std::size_t kMarginOfWindow = 8;

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
  waiting_.begin_at({.block = from.has_before ? 1U : 0U, .s_mm = from.s_mm}, blocks);
  if (from.has_before) {
    blocks.pop_front();
    waiting_.block_done();
  }
  waiting_.refine_begin(from.to_rest.back().way_mm / kCellsToRest, blocks);
  if (waiting_.size() < kFewestInMotion) {
    return false;
  }
  plan_ = OptimalPlan(from.state);
  const std::size_t count = std::min(waiting_.size(), kCellsInMotion);
  double way_mm = 0.0;
  auto after = from.to_rest.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const double middle_mm = way_mm + 0.5 * waiting_[i].length_mm;
    while (after != from.to_rest.end() && after->way_mm < middle_mm) {
      ++after;
    }
    if (after == from.to_rest.begin() || after == from.to_rest.end()) {
      break;
    }
    const Begin::Feed& before = *std::prev(after);
    const double share = (middle_mm - before.way_mm) / (after->way_mm - before.way_mm);
    const double v = before.v_mm_s + share * (after->v_mm_s - before.v_mm_s);
    waiting_.plan_at(i, v * v);
    way_mm += waiting_[i].length_mm;
  }
  Found found = find_over({.begin = 0, .end = count}, waiting_.path_of(blocks));
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
  return waiting_.size() < settings_.window_cells;
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

OptimumSchedule::Found OptimumSchedule::find(const PathAt& path) const {
  Found all = find_over({.begin = 0, .end = waiting_.size()}, path);
  std::size_t count = all.count;
  for (int i = 0; i < kShorterSearches && !all.ended_well() && count >= kMinShorter; ++i) {
    count /= 2;
    if (Found shorter = find_over({.begin = 0, .end = count}, path); shorter.ended_well()) {
      shorter.is_shorter = true;
      return shorter;
    }
  }
  return all;
}

OptimumSchedule::Found OptimumSchedule::find_over(const Indices& waiting,
                                                  const PathAt& path) const {
  CellSequence sequence;
  if (waiting.begin == 0) {
    sequence = plan_.rest_from(place_);
  }
  std::vector<Cell>& cells = sequence.cells;
  std::size_t count = 0;
  bool stops = false;
  while (waiting.begin + count < waiting.end && cells.size() < settings_.window_cells && !stops) {
    cells.push_back(waiting_[waiting.begin + count]);
    stops = cells.back().rest_after;
    ++count;
  }
  if (sequence.begin.at_rest()) {
    relax_beside_rest(cells, BlockSide::begin);
    refine_to_rest(cells, RestAt::begin, path, settings_.limits);
  }
  if (cells.back().ends_block) {
    relax_beside_rest(cells, BlockSide::end);
  }
  refine_to_rest(cells, RestAt::end, path, settings_.limits);
  PlanSearch search{.cells = cells.size(), .from_rest = sequence.begin.at_rest()};
  Found found{.count = count,
              .plan = OptimalPlan::find(std::move(sequence), path, settings_.limits)};
  if (settings_.observer) {
    search.has_plan = found.plan.has_value();
    if (found.plan) {
      search.slowed_down = found.plan->slowed_down();
      search.newton_steps = found.plan->newton_steps();
      search.duration_s = found.plan->duration_s();
    }
    settings_.observer->searched(search);
  }
  return found;
}

PlannedCells OptimumSchedule::planned_to_block_end(const Found& found, const PathAt& path) const {
  PlannedCells planned{.cells = &waiting_,
                       .count = found.count,
                       .duration_s = found.plan->duration_s(),
                       .failed = found.is_shorter || found.plan->slowed_down()};
  while (planned.count < waiting_.size() && !waiting_[planned.count - 1].ends_block &&
         waiting_[planned.count - 1].rest_after) {
    const Found next = find_over({.begin = planned.count, .end = waiting_.size()}, path);
    planned.count += next.count;
    planned.duration_s += next.plan->duration_s();
    planned.failed |= next.plan->slowed_down();
  }
  return planned;
}

void OptimumSchedule::plan(Window<Block>& blocks, Emitter& emitter) {
  if (waiting_.front().whole_line) {
    follow_classical(blocks);
    return;
  }
  const PathAt path = waiting_.path_of(blocks);
  const bool from_rest = cells_left() == 0;
  Found found = find(path);
  if (from_rest && waiting_.front().cell.s_begin_mm == 0.0) {
    const auto faster =
        faster_fallback(planned_to_block_end(found, path), blocks, classical_.settings());
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
    found = find_over({.begin = 0, .end = waiting_.size()}, path);
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

void OptimumSchedule::adopt(Found found) {
  plan_ends_at_stop_ = waiting_[found.count - 1].rest_after;
  waiting_.drop(found.count);
  plan_ = std::move(*found.plan);
  place_ = {};
  const std::size_t count = plan_.cells().size();
  window_brake_ = plan_ends_at_stop_ ? count : plan_.last_braking();
  const auto relaxed = static_cast<std::size_t>(
      std::ranges::count_if(plan_.cells(), [](const Cell& cell) { return cell.relaxed; }));
  const std::size_t margin = count / kMarginOfWindow + relaxed;
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
