#include "lookahead/optimum/solver/optimal_plan.hpp"

#include <algorithm>
#include <cmath>

#include "lookahead/optimum/grid/junction_share.hpp"

namespace kerf::lookahead {

SquaredFeed OptimalPlan::feed_at(const PlanPlace& place) const {
  const std::size_t i = place.cell - sequence_.first_spline_cell();
  const SquaredFeed begin = basis_[i].begin.at(&coefficients_[i]);
  const double s = place.offset_mm;
  return {.value = begin.value + s * (begin.slope + 0.5 * s * begin.bend),
          .slope = begin.slope + s * begin.bend,
          .bend = begin.bend};
}

StartState OptimalPlan::state_at(const PlanPlace& place) const {
  if (place.cell == 0 && place.offset_mm == 0.0) {
    return sequence_.begin;
  }
  if (place.cell == sequence_.cells.size()) {
    return {};
  }
  if (is_landing(place.cell)) {
    const SquaredFeed feed = basis_.back().end.at(&coefficients_[basis_.size() - 1]);
    return {.v_mm_s = std::sqrt(feed.value), .a_mm_s2 = 0.5 * feed.slope};
  }
  const SquaredFeed feed = feed_at(place);
  return {.v_mm_s = std::sqrt(feed.value), .a_mm_s2 = 0.5 * feed.slope};
}

profiles::CellLaw OptimalPlan::law_from(const PlanPlace& place, double longest_s) const {
  const double length = sequence_.cells[place.cell].length_mm;
  if (is_launch(place.cell)) {
    return profiles::CellLaw::launch(state_at({.cell = place.cell + 1}).v_mm_s, length);
  }
  if (is_landing(place.cell)) {
    return profiles::CellLaw::landing(state_at(place).v_mm_s, length);
  }
  const SquaredFeed feed = feed_at(place);
  const profiles::CellLaw::Begin begin{
      .v_mm_s = std::sqrt(feed.value), .a_mm_s2 = 0.5 * feed.slope, .bend_per_s2 = 0.5 * feed.bend};
  const double left = length - place.offset_mm;
  const profiles::CellLaw law = profiles::CellLaw::between(begin, left);
  return law.duration_s() <= 2.0 * longest_s
             ? law
             : profiles::CellLaw::between(begin, law.at(longest_s).s_mm);
}

Constraint OptimalPlan::limit_on(std::size_t cell, const PlanLimits& limits) const {
  const Cell& at = sequence_.cells[cell];
  if (is_launch(cell)) {
    return tightest_constraint_at_rest(at, state_at({.cell = cell + 1}).v_mm_s, true, limits);
  }
  if (is_landing(cell)) {
    return tightest_constraint_at_rest(at, state_at({.cell = cell}).v_mm_s, false, limits);
  }
  const std::size_t i = cell - sequence_.first_spline_cell();
  return tightest_constraint(at,
                             {.begin = basis_[i].begin.at(&coefficients_[i]),
                              .end = basis_[i].end.at(&coefficients_[i]),
                              .coefficient = coefficients_[i + 1]},
                             limits);
}

std::size_t OptimalPlan::last_braking() const {
  std::size_t first = sequence_.cells.size();
  while (first > 0 && state_at({.cell = first - 1}).v_mm_s > state_at({.cell = first}).v_mm_s) {
    --first;
  }
  return first;
}

bool OptimalPlan::brakes_long() const {
  return last_braking() < cells().size() - cells().size() / 4;
}

double OptimalPlan::duration_s() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < sequence_.cells.size(); ++i) {
    sum += law_from({.cell = i}, kUnbounded).duration_s();
  }
  return sum;
}

std::vector<BlockPassing> OptimalPlan::passings() const {
  std::vector<BlockPassing> passings;
  double t_s = 0.0;
  for (std::size_t i = 0; i < sequence_.cells.size(); ++i) {
    t_s += law_from({.cell = i}, kUnbounded).duration_s();
    if (sequence_.cells[i].ends_block) {
      passings.push_back({.t_s = t_s, .v_mm_s = state_at({.cell = i + 1}).v_mm_s});
    }
  }
  return passings;
}

CellSequence OptimalPlan::rest_from(const PlanPlace& place) const {
  CellSequence sequence{.begin = state_at(place), .cells = {}};
  for (std::size_t i = place.cell; i < sequence_.cells.size(); ++i) {
    if (sequence_.cells[i].continues && i > place.cell) {
      Cell& whole = sequence.cells.back();
      whole.length_mm = sequence_.cells[i].s_end_mm() - whole.s_begin_mm;
      whole.end = sequence_.cells[i].end;
      whole.ends_block = sequence_.cells[i].ends_block;
      whole.rest_after = sequence_.cells[i].rest_after;
      continue;
    }
    Cell& cell = sequence.cells.emplace_back(sequence_.cells[i]);
    bind_beside_junction(cell);
    if (!is_launch(i) && !is_landing(i)) {
      cell.planned_squared = feed_at({.cell = i, .offset_mm = 0.5 * cell.length_mm}).value;
    }
  }
  if (!sequence.cells.empty()) {
    sequence.cells.front().s_begin_mm += place.offset_mm;
    sequence.cells.front().length_mm -= place.offset_mm;
  }
  return sequence;
}

}  // namespace kerf::lookahead
