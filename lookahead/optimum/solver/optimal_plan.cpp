#include "lookahead/optimum/solver/optimal_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/optimum/solver/limit_check.hpp"
#include "lookahead/optimum/solver/optimal_feed.hpp"

namespace kerf::lookahead {

namespace {

// A search that has not ended well spoils more with each share that is taken off. The first rounds
// are not judged, nor those after cells were halved.
constexpr int kRoundsToJudge = 2;
constexpr double kDiverges = 1.2;  // over the least excess of the rounds before
// Between the ends of a cell no barrier stands. Where an excess does not follow the shares in so
// many rounds, the path changes too much over the cell; in every eighth it is halved.
constexpr int kPatience = 12;
constexpr int kBetweenHalvings = 8;
constexpr double kMinHalved_mm = 1e-6;
constexpr double kSlight = 1.01;  // slowing down by it is no loss to speak of
// Of a limit, at the places where it is looked at; what is between two of them is a little more.
constexpr double kHolds = 0.9999;
constexpr double kSlower = 0.999;
constexpr double kMinFactor = 1e-6;
constexpr int kSlowings = 3;

void take_off(double excess, double& share) {
  if (excess > kHolds) {
    share *= kAim / excess;
  }
}

void take_off_feedrate(double excess, double& share) {
  if (excess > 1.0) {
    share *= kAim / excess;
  }
}

bool holds(const Excess& excess) {
  return excess.feedrate <= 1.0 && std::max(excess.acceleration, excess.jerk) <= kHolds;
}

void widen(const Excess& excess, Excess& worst) {
  worst.feedrate = std::max(worst.feedrate, excess.feedrate);
  worst.acceleration = std::max(worst.acceleration, excess.acceleration);
  worst.jerk = std::max(worst.jerk, excess.jerk);
}

}  // namespace

std::optional<OptimalPlan> OptimalPlan::find(CellSequence sequence, const PathAt& path,
                                             const PlanLimits& limits, int refinements) {
  OptimalPlan plan;
  plan.sequence_ = std::move(sequence);
  plan.basis_ = feed_basis(plan.sequence_.spline_lengths_mm());
  OptimalFeed feed = find_optimal_feed(plan.sequence_, limits);
  plan.coefficients_ = feed.coefficients;
  plan.excess_ = plan.check(path, limits);
  double least = plan.excess_.largest();
  int judged_from = kRoundsToJudge;
  for (int i = 0; i < refinements && !holds(plan.excess_); ++i) {
    if (i >= kPatience && (i - kPatience) % kBetweenHalvings == 0) {
      plan.halve_cells(path, limits);
      feed.coefficients = plan.coefficients_;
      least = kUnbounded;
      judged_from = i + kRoundsToJudge;
    }
    refine_optimal_feed(plan.sequence_, limits, feed);
    plan.coefficients_ = feed.coefficients;
    plan.excess_ = plan.check(path, limits);
    if (i >= judged_from && plan.excess_.largest() > kDiverges * least) {
      break;
    }
    least = std::min(least, plan.excess_.largest());
  }
  plan.newton_steps_ = feed.newton_steps;
  if (holds(plan.excess_)) {
    return plan;
  }
  if (!plan.sequence_.begin.at_rest()) {
    return std::nullopt;
  }
  plan.slow_down(path, limits);
  return plan;
}

void OptimalPlan::halve_cells(const PathAt& path, const PlanLimits& limits) {
  std::vector<Cell> cells;
  std::vector<double> coefficients{coefficients_.front()};
  const std::size_t first = sequence_.first_spline_cell();
  for (std::size_t i = 0; i < sequence_.cells.size(); ++i) {
    const Cell& cell = sequence_.cells[i];
    if (is_launch(i) || is_landing(i)) {
      cells.push_back(cell);
      continue;
    }
    const SquaredFeed begin = feed_at({.cell = i});
    if (cell.length_mm < kMinHalved_mm || holds(excess_of(cell, begin, path, limits))) {
      cells.push_back(cell);
      coefficients.push_back(coefficients_[i - first + 1]);
      continue;
    }
    const double half = 0.5 * cell.length_mm;
    for (Cell& part : parts_of(cell, {half, half}, path)) {
      part.continues &= part.s_begin_mm == cell.s_begin_mm;
      cells.push_back(part);
    }
    for (const double c : coefficients_of_halves(begin, cell.length_mm)) {
      coefficients.push_back(c);
    }
  }
  coefficients.push_back(coefficients_.back());
  sequence_.cells = std::move(cells);
  coefficients_ = std::move(coefficients);
  basis_ = feed_basis(sequence_.spline_lengths_mm());
}

// v^2 times a factor: accelerations and the jerk of jumps by the same, other jerks by more. Where
// the search ended in what is no number, from its begin.
void OptimalPlan::slow_down(const PathAt& path, const PlanLimits& limits) {
  slowed_down_ = !(excess_.largest() <= kSlight);
  if (!(excess_.largest() < kUnbounded)) {
    for (Cell& cell : sequence_.cells) {
      cell.shares = {};
      cell.planned_squared = 0.0;
    }
    coefficients_ = first_feed(sequence_, limits);
    excess_ = check(path, limits);
  }
  for (int i = 0; i < kSlowings && !holds(excess_); ++i) {
    const double factor = std::min({1.0 / (excess_.feedrate * excess_.feedrate),
                                    1.0 / excess_.acceleration, 1.0 / excess_.jerk});
    for (double& c : coefficients_) {
      c *= std::clamp(kSlower * factor, kMinFactor, kSlower);
    }
    excess_ = check(path, limits);
  }
}

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

double OptimalPlan::duration_s() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < sequence_.cells.size(); ++i) {
    sum += law_from({.cell = i}, kUnbounded).duration_s();
  }
  return sum;
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

Excess OptimalPlan::check(const PathAt& path, const PlanLimits& limits) {
  Excess worst;
  for (std::size_t i = 0; i < sequence_.cells.size(); ++i) {
    Cell& cell = sequence_.cells[i];
    Excess excess;
    if (is_launch(i)) {
      excess = excess_of_rest(cell, state_at({.cell = 1}).v_mm_s, true, path, limits);
    } else if (is_landing(i)) {
      excess = excess_of_rest(cell, state_at({.cell = i}).v_mm_s, false, path, limits);
    } else {
      excess = excess_of(cell, feed_at({.cell = i}), path, limits);
    }
    take_off_feedrate(excess.feedrate, cell.shares.feedrate);
    take_off(excess.acceleration, cell.shares.acceleration);
    take_off(excess.jerk, cell.shares.jerk);
    widen(excess, worst);
  }
  return worst;
}

}  // namespace kerf::lookahead
