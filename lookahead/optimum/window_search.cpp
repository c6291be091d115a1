#include "lookahead/optimum/window_search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "lookahead/optimum/grid/grid.hpp"

namespace kerf::lookahead {

namespace {

// A search over fewer cells, half as many each time, may end well where one over all does not.
constexpr int kShorterSearches = 3;
constexpr std::size_t kMinShorter = 200;
// A plan takes so many times the cells that are left of the one before at the least.
constexpr std::size_t kMinOfRest = 2;

}  // namespace

std::size_t WindowSearch::first_count() const {
  const WaitingCells& waiting = *cells_.waiting;
  if (cells_.place.cell < cells_.plan->cells().size()) {
    return waiting.size();
  }
  const std::size_t first_block = waiting.blocks_of_first(1).cells;
  return std::min(waiting.size(),
                  first_block > kFewCells ? kCellsOfPlan : std::max(kCellsOfPlan, first_block));
}

FoundPlan WindowSearch::over_all() const {
  const WaitingCells& waiting = *cells_.waiting;
  const std::size_t first = first_count();
  FoundPlan all = over({.begin = 0, .end = first});
  if (first < waiting.size() && all.count == first && !waiting[first - 1].rest_after &&
      all.ended_well() && all.plan->brakes_long()) {
    all = over({.begin = 0, .end = waiting.size()});
  }
  std::size_t count = all.count;
  for (int i = 0; i < kShorterSearches && !all.ended_well() && count >= kMinShorter; ++i) {
    count /= 2;
    if (FoundPlan shorter = over({.begin = 0, .end = count}); shorter.ended_well()) {
      shorter.is_shorter = true;
      return shorter;
    }
  }
  return all;
}

FoundPlan WindowSearch::over(const Indices& waiting) const {
  CellSequence sequence;
  if (waiting.begin == 0) {
    sequence = cells_.plan->rest_from(cells_.place);
  }
  std::vector<Cell>& cells = sequence.cells;
  const std::size_t max_cells = std::max(settings_.max_cells, kMinOfRest * cells.size());
  std::size_t count = 0;
  bool stops = false;
  while (waiting.begin + count < waiting.end && cells.size() < max_cells && !stops) {
    cells.push_back((*cells_.waiting)[waiting.begin + count]);
    stops = cells.back().rest_after;
    ++count;
  }
  if (sequence.begin.at_rest()) {
    relax_beside_rest(cells, BlockSide::begin);
    refine_to_rest(cells, RestAt::begin, cells_.path, *settings_.limits);
  }
  if (cells.back().ends_block) {
    relax_beside_rest(cells, BlockSide::end);
  }
  refine_to_rest(cells, RestAt::end, cells_.path, *settings_.limits);
  PlanSearch search{.cells = cells.size(), .from_rest = sequence.begin.at_rest()};
  FoundPlan found{.count = count,
                  .plan = OptimalPlan::find(std::move(sequence), cells_.path, *settings_.limits)};
  if (settings_.observer != nullptr) {
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

PlannedCells WindowSearch::planned_to_block_end(const FoundPlan& found) const {
  const WaitingCells& waiting = *cells_.waiting;
  PlanClock clock(settings_.limits->period_s);
  PlannedCells planned{.cells = &waiting,
                       .count = found.count,
                       .failed = found.is_shorter || found.plan->slowed_down()};
  const auto add = [&](const OptimalPlan& plan) {
    for (const BlockPassing& passing : plan.passings()) {
      planned.passings.push_back({clock.now_s() + passing.t_s, passing.v_mm_s});
    }
    clock.advance(plan.duration_s());
  };
  add(*found.plan);
  while (planned.count < waiting.size() && !waiting[planned.count - 1].ends_block &&
         waiting[planned.count - 1].rest_after) {
    const FoundPlan next = over({.begin = planned.count, .end = waiting.size()});
    planned.count += next.count;
    clock.align_to_tick();
    add(*next.plan);
    planned.failed |= next.plan->slowed_down();
  }
  return planned;
}

}  // namespace kerf::lookahead
