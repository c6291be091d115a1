// The classical plan over blocks on which no time optimum, or a slower one, was found.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lookahead/classical/classical_schedule.hpp"
#include "lookahead/emit/schedule.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"

namespace kerf::lookahead {

// What is planned twice, to take the better plan, holds no more.
inline constexpr std::size_t kFewCells = 3000;

struct FirstBlocks {
  const Window<Block>* blocks = nullptr;
  std::size_t count = 0;
};
// How the schedule passes the ends of the first blocks, from rest to rest at the end of the last. A
// rest within lasts until the next tick.
std::vector<BlockPassing> passings_from_rest(Schedule& schedule, const FirstBlocks& first,
                                             const PlanLimits& limits);

// The first waiting cells, from a rest at the begin of a block on, as many as plans cover.
struct PlannedCells {
  const WaitingCells* cells = nullptr;
  std::size_t count = 0;
  std::vector<BlockPassing> passings{};  // of the whole blocks; the last in motion, if more follows
  bool failed = false;                   // a search did not end well, over these cells or more
  bool tried = false;                    // and the passings are those of what would be run instead
};

// The whole blocks at their front that follow the classical plan.
struct Fallback {
  std::size_t blocks = 0;
  std::size_t cells = 0;
  profiles::ProfileKind profile = profiles::ProfileKind::s_curve;
};

// The blocks over which the classical schedule, from rest to rest, is faster than the plans found,
// which may pass the end of the last one in motion. Nothing: it is slower, or would cost too much
// to find out. Where the searches ended well it is asked for lines and arcs, for curves without
// limits of axes, and for short curves that come to rest within or whose curvature jumps: the
// others are planned in less time than it takes. Where they did not, the blocks are at least two,
// or what would be run instead was tried. Curves under limits of axes that end at a rest are asked
// for by the smoother profiles too: what the S-curve gains in jerk it may lose where it is kept
// below a limit curve.
//
// On lines the S-curve need not be faster up to its rest, if it leads before.
//
// run: up to the next rest. Where the searches ended well the classical schedule takes all of it,
// so it is not asked for where the cells end before an arc or a curve under limits of axes.
std::optional<Fallback> faster_fallback(const PlannedCells& planned, const FirstBlocks& run,
                                        const ClassicalSchedule::Settings& settings);

}  // namespace kerf::lookahead
