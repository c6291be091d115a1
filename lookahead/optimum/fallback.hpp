// The classical plan over blocks on which no time optimum, or a slower one, was found.
#pragma once

#include <cstddef>
#include <optional>

#include "lookahead/classical/classical_schedule.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"

namespace kerf::lookahead {

// The first waiting cells, as many as a plan covers.
struct PlannedCells {
  const WaitingCells* cells = nullptr;
  std::size_t count = 0;
};

// The whole blocks at their front that follow the classical plan.
struct Fallback {
  std::size_t blocks = 0;
  std::size_t cells = 0;
};

// The blocks over which the classical schedule, from rest to rest, is faster than the plan found
// from there. Nothing: it is slower, or would cost too much to find out: where the search ended
// well it is not asked for curves under limits of axes. Where it did not, the blocks are at least
// two: on a single curve, the optimum with a rest inside is faster than the classical plan.
std::optional<Fallback> faster_fallback(const PlannedCells& planned, const OptimalPlan& found,
                                        const Window<Block>& blocks,
                                        const ClassicalSchedule::Settings& settings);

}  // namespace kerf::lookahead
