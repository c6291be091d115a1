// What OptimumSchedule does where a search does not end well.
#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "lookahead/optimum/optimum_schedule.hpp"

namespace kerf::lookahead {

namespace {

// Where no plan is found from a place in motion: of the cells that are left, how far on it is tried
// again.
constexpr std::size_t kTriesOfRest = 8;
constexpr std::size_t kMinBetweenTries = 8;
constexpr int kCuts = 5;  // of what a plan covers
constexpr std::size_t kCutCells = 16;

PlanDegradation degradation_on(const Block& block, double s_mm) {
  const LineMark mark = block.mark_at(s_mm);
  return {.line = mark.line, .s_mm = s_mm - mark.s_mm};
}

// Few cells; of one block, or of more that end at a rest and were not planned to the end.
bool is_worth_a_trial(const FrontBlocks& front, const PlannedCells& planned) {
  if (front.cells > kFewCells) {
    return false;
  }
  const Cell& last = (*planned.cells)[front.cells - 1];
  return front.blocks <= 1 || (planned.count < front.cells && last.rest_after);
}

}  // namespace

PlannedCells OptimumSchedule::tried_to_block_end(const FoundPlan& found, const WindowSearch& search,
                                                 const Window<Block>& blocks) const {
  PlannedCells planned = search.planned_to_block_end(found);
  const FrontBlocks front = waiting_.blocks_of_first(planned.count);
  if (!planned.failed || !is_worth_a_trial(front, planned)) {
    return planned;
  }
  Settings settings = settings_;
  settings.observer = nullptr;  // nothing of it is run
  settings.takes_classical = false;
  OptimumSchedule schedule(settings);
  planned.count = front.cells;
  planned.passings =
      passings_from_rest(schedule, {.blocks = &blocks, .count = front.blocks}, settings_.limits);
  planned.failed = false;
  planned.tried = true;
  return planned;
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
  classical_.use(fallback.profile);
  classical_.take(blocks, fallback.blocks);
  waiting_.drop(fallback.cells);
}

// The search may fail on a few cells close to the rest where it begins. The cuts come nearer to
// them, and after the last one the motion goes on to where it would have gone.
FoundPlan OptimumSchedule::search_with_cut(FoundPlan found, const WindowSearch& search,
                                           const Window<Block>& blocks, Emitter& emitter) {
  std::optional<std::size_t> rest;
  for (int i = 0; i < kCuts && !found.ended_well() && found.count >= kCutCells; ++i) {
    if (rest) {
      waiting_.go_on_after(*rest);
    }
    rest = sharpest(found.count);
    waiting_.rest_after(*rest);
    found = search.over({.begin = 0, .end = waiting_.size()});
  }
  if (rest) {
    note_stop(waiting_[*rest], blocks, emitter);
  }
  return found;
}

std::size_t OptimumSchedule::sharpest(std::size_t count) const {
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
  return sharpest;
}

void OptimumSchedule::note_slow_plan(const Window<Block>& blocks, Emitter& emitter) const {
  const Cell& first = waiting_.front().cell;
  emitter.note(degradation_on(waiting_.block_of(first, blocks), first.s_begin_mm));
}

void OptimumSchedule::note_stop(const Cell& cell, const Window<Block>& blocks,
                                Emitter& emitter) const {
  PlanDegradation stop = degradation_on(waiting_.block_of(cell, blocks), cell.s_end_mm());
  stop.kind = PlanDegradation::Kind::stop;
  emitter.note(stop);
}

}  // namespace kerf::lookahead
