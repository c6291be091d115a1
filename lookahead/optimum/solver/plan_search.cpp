// The search for a plan: the optimum, the check between the ends of cells, and what is mended.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/optimum/solver/optimal_feed.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"

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
// What a limit that is lowered changes ends within so many cells. The rest of the plan stays as it
// is, in later rounds less of it.
constexpr std::size_t kCellsBeside = 32;
constexpr std::size_t kMoreCellsBeside = 8;
constexpr double kMinHalved_mm = 1e-6;
constexpr double kSlight = 1.01;  // slowing down by it is no loss to speak of
// Of a limit, at the places where it is looked at; what is between two of them is a little more.
constexpr double kHolds = 0.9999;
constexpr double kRounded = 1.0 + 1e-9;
// A relaxed barrier lets a limit be exceeded by some times the share that weighs it.
constexpr double kOfShare = 5.0;
constexpr double kSlower = 0.999;
constexpr double kMinFactor = 1e-6;
constexpr int kSlowings = 3;

void take_off(double excess, double& share) {
  if (excess > kHolds) {
    share *= kAim / excess;
  }
}

void take_off_feedrate(double excess, double aim, double& share) {
  if (excess > 1.0) {
    share *= aim / excess;
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
  plan.aim_of_feedrate_ = 1.0 - kOfShare * feed.last_share;
  std::vector<Excess> found(plan.sequence_.cells.size());
  plan.check(plan.whole_spline(), path, limits, found);
  double least = plan.excess_.largest();
  int judged_from = kRoundsToJudge;
  for (int i = 0; i < refinements && !holds(plan.excess_); ++i) {
    std::vector<SplineRange> ranges =
        plan.exceeded_ranges(found, kCellsBeside + kMoreCellsBeside * static_cast<std::size_t>(i));
    if (i >= kPatience && (i - kPatience) % kBetweenHalvings == 0) {
      plan.halve_cells(path, limits);
      feed.coefficients = plan.coefficients_;
      found.assign(plan.sequence_.cells.size(), {});
      ranges = {plan.whole_spline()};
      least = kUnbounded;
      judged_from = i + kRoundsToJudge;
    }
    int steps = 0;
    for (const SplineRange& range : ranges) {
      steps = std::max(steps, refine_optimal_feed(plan.sequence_, limits, range, feed));
    }
    feed.newton_steps += steps;
    plan.coefficients_ = feed.coefficients;
    for (const SplineRange& range : ranges) {
      plan.check(range, path, limits, found);
    }
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

std::vector<SplineRange> OptimalPlan::exceeded_ranges(std::span<const Excess> found,
                                                      std::size_t beside) const {
  const std::size_t first = sequence_.first_spline_cell();
  const std::size_t count = sequence_.spline_cells();
  std::vector<SplineRange> ranges;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (holds(found[i])) {
      continue;
    }
    const std::size_t at = std::min(std::max(i, first) - first, count - 1);
    const SplineRange around{.begin = at - std::min(at, beside),
                             .end = std::min(at + beside + 1, count)};
    if (ranges.empty() || around.begin > ranges.back().end) {
      ranges.push_back({.begin = around.begin, .end = around.begin});
    }
    cells += around.end - ranges.back().end;
    ranges.back().end = around.end;
  }
  const bool is_most = cells > count - count / 4;
  return is_most ? std::vector{whole_spline()} : ranges;
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
  std::vector<Excess> found(sequence_.cells.size());
  slowed_down_ = !(excess_.largest() <= kSlight);
  if (!(excess_.largest() < kUnbounded)) {
    for (Cell& cell : sequence_.cells) {
      cell.shares = {};
      cell.planned_squared = 0.0;
    }
    coefficients_ = first_feed(sequence_, limits);
    check(whole_spline(), path, limits, found);
  }
  for (int i = 0; i < kSlowings && !holds(excess_); ++i) {
    const double factor = std::min({1.0 / (excess_.feedrate * excess_.feedrate),
                                    1.0 / excess_.acceleration, 1.0 / excess_.jerk});
    for (double& c : coefficients_) {
      c *= std::clamp(kSlower * factor, kMinFactor, kSlower);
    }
    check(whole_spline(), path, limits, found);
  }
}

void OptimalPlan::check(const SplineRange& range, const PathAt& path, const PlanLimits& limits,
                        std::vector<Excess>& found) {
  const std::size_t first = sequence_.first_spline_cell();
  const std::size_t begin = range.begin > 0 ? first + range.begin : 0;
  const std::size_t end = range.end < sequence_.spline_cells() ? first + range.end : found.size();
  for (std::size_t i = begin; i < end; ++i) {
    Cell& cell = sequence_.cells[i];
    Excess& excess = found[i];
    if (is_launch(i)) {
      excess = excess_of_rest(cell, state_at({.cell = 1}).v_mm_s, true, path, limits);
    } else if (is_landing(i)) {
      excess = excess_of_rest(cell, state_at({.cell = i}).v_mm_s, false, path, limits);
    } else {
      excess = excess_of(cell, feed_at({.cell = i}), path, limits);
    }
    // A motion that a classical plan has brought there may begin at the limit itself.
    if (i == 0 && !sequence_.begin.at_rest() && excess.acceleration <= kRounded) {
      excess.acceleration = std::min(excess.acceleration, kHolds);
    }
    take_off_feedrate(excess.feedrate, aim_of_feedrate_, cell.shares.feedrate);
    take_off(excess.acceleration, cell.shares.acceleration);
    take_off(excess.jerk, cell.shares.jerk);
  }
  excess_ = {};
  for (const Excess& excess : found) {
    widen(excess, excess_);
  }
}

}  // namespace kerf::lookahead
