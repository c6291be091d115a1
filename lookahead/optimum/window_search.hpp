// The search for the time optimum over the cells that wait.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "lookahead/optimum/fallback.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"
#include "lookahead/path/plan_observer.hpp"

namespace kerf::lookahead {

// What a plan takes, so that it is found soon; more where it would brake for its end for long
// (OptimalPlan::brakes_long).
inline constexpr std::size_t kCellsOfPlan = 1000;

struct FoundPlan {
  std::size_t count = 0;  // of the waiting cells that it takes
  std::optional<OptimalPlan> plan{};
  bool is_shorter = false;  // a search over more did not end well

  [[nodiscard]] bool ended_well() const { return plan && !plan->slowed_down(); }
};

class WindowSearch {
 public:
  struct Settings {
    const PlanLimits* limits = nullptr;
    std::size_t max_cells = 0;               // of a plan
    const PlanObserver* observer = nullptr;  // null: nobody is told
  };
  // The waiting cells follow the rest of a plan, from the place on.
  struct Cells {
    const WaitingCells* waiting = nullptr;
    const OptimalPlan* plan = nullptr;
    PlanPlace place{};
    PathAt path{};
  };

  // What they point to is to outlive it.
  WindowSearch(const Settings& settings, Cells cells)
      : settings_(settings), cells_(std::move(cells)) {}

  // Over the rest of the plan and what waits after it, from a rest over kCellsOfPlan first, or over
  // a first block that is to be compared (kFewCells); fewer of them where that does not end well.
  [[nodiscard]] FoundPlan over_all() const;
  struct Indices {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  // Over these of the waiting cells, up to a rest, refined for the rests at their ends. From 0 on
  // the rest of the plan comes first, others begin after a rest.
  [[nodiscard]] FoundPlan over(const Indices& waiting) const;
  // What was found from a rest in front of a block; where it comes to rest within one, with what
  // follows up to its end.
  [[nodiscard]] PlannedCells planned_to_block_end(const FoundPlan& found) const;

 private:
  // Of the waiting cells, that are tried first.
  [[nodiscard]] std::size_t first_count() const;

  Settings settings_;
  Cells cells_;
};

}  // namespace kerf::lookahead
