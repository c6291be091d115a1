#include "bench/starts.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/acceleration_bound.hpp"
#include "bench/curve_run.hpp"
#include "lookahead/optimum/grid/block_path.hpp"
#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"
#include "tests/kernel/random_machine.hpp"

namespace kerf::bench {

using lookahead::Cell;
using lookahead::CellSequence;
using lookahead::OptimalPlan;
using lookahead::PlanLimits;

namespace {

constexpr std::array kCurves{"butterfly", "circle", "mazatrol", "rational4",
                             "scroll",    "star",   "trident7", "wm"};
constexpr std::size_t kSettings = 200;
constexpr double kMostRatio = 1.01;
constexpr double kMostMedian = 1.003;

// 0: the search did not end well.
double duration_s(CellSequence sequence, const lookahead::PathAt& path, const PlanLimits& limits) {
  const auto plan = OptimalPlan::find(std::move(sequence), path, limits);
  return plan && !plan->slowed_down() ? plan->duration_s() : 0.0;
}

}  // namespace

TwoStarts two_starts(const lookahead::Block& block, const PlanLimits& limits) {
  const lookahead::BlockPath path(block, limits);
  const lookahead::PathAt at = [&path](const Cell&, double s_mm) { return path.at(s_mm); };
  CellSequence sequence{.begin = {}, .cells = grid_of(path, {}, limits)};
  std::vector<Cell>& cells = sequence.cells;
  const auto rest = std::ranges::find_if(cells, &Cell::rest_after);
  cells.erase(rest == cells.end() ? rest : rest + 1, cells.end());
  refine_to_rest(cells, lookahead::RestAt::begin, at, limits);
  refine_to_rest(cells, lookahead::RestAt::end, at, limits);
  TwoStarts times{.own_s = duration_s(sequence, at, limits)};
  const AnyJerkMotion motion = any_jerk_motion(block, limits);
  for (Cell& cell : cells) {
    cell.planned_squared = motion.v_squared_at(cell.s_begin_mm + 0.5 * cell.length_mm);
  }
  times.any_jerk_s = duration_s(std::move(sequence), at, limits);
  return times;
}

int starts(std::size_t every) {
  std::vector<double> ratios;
  bool met = true;
  for (std::size_t i = 0; i < kCurves.size() * kSettings; i += every) {
    const std::size_t seed = i / kCurves.size();
    const PlanLimits limits = test::random_machine(seed, test::Spread::common).limits;
    const std::string name = kCurves[i % kCurves.size()];
    const TwoStarts times = two_starts(curve_block(name + ".ngc", limits), limits);
    const double ratio = times.own_s / times.any_jerk_s;
    ratios.push_back(ratio);
    const bool is_near = times.own_s > 0.0 && ratio <= kMostRatio;
    if (!is_near) {
      std::printf("%s, limits %zu: %.6f and %.6f s\n", name.c_str(), seed, times.own_s,
                  times.any_jerk_s);
    }
    met = met && is_near;
  }
  std::ranges::sort(ratios);
  const double median = ratios[ratios.size() / 2];
  met = met && median <= kMostMedian;
  std::printf(
      "| curves | time from its own start over that from the motion with any jerk | median | |\n"
      "| --- | --- | --- | --- |\n"
      "| %zu | %.6f to %.6f | %.6f | %s |\n",
      ratios.size(), ratios.front(), ratios.back(), median, met ? "met" : "MISSED");
  return met ? 0 : 1;
}

}  // namespace kerf::bench
