// The classical plan over blocks on which the time optimum is not found.
#pragma once

#include <cstddef>
#include <optional>

#include "lookahead/classical/classical_schedule.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"

namespace kerf::lookahead {

// The first cells that wait, as many as a plan covers.
struct PlannedCells {
  const WaitingCells* cells = nullptr;
  std::size_t count = 0;
};

// The whole blocks at the front of them that follow the classical plan.
struct Fallback {
  std::size_t blocks = 0;
  std::size_t cells = 0;
};

// The blocks over which the classical schedule, from rest to rest, is faster than the plan found
// from there. Nothing: it is not, or they are less than two: on one curve alone a rest within it
// leaves more of the optimum than the classical plan has.
std::optional<Fallback> faster_fallback(const PlannedCells& planned, const OptimalPlan& found,
                                        const Window<Block>& blocks,
                                        const ClassicalSchedule::Settings& settings);

}  // namespace kerf::lookahead
