// The planned motion over one sequence of cells, from the tool's place to a rest.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "lookahead/optimum/solver/barrier_objective.hpp"
#include "lookahead/optimum/solver/limit_check.hpp"
#include "profiles/cell_law.hpp"

namespace kerf::lookahead {

// A place in a plan: a cell and the distance from its beginning.
struct PlanPlace {
  std::size_t cell = 0;
  double offset_mm = 0.0;
};

// How the end of a block is passed.
struct BlockPassing {
  double t_s = 0.0;  // from the begin of the plan
  double v_mm_s = 0.0;
};

class OptimalPlan {
 public:
  OptimalPlan() = default;
  // Over, before a motion that goes on.
  explicit OptimalPlan(const StartState& end) : sequence_{.begin = end, .cells = {}} {}

  // The fastest plan found that also keeps the limits between the places at which the solver
  // evaluates them: they are checked there, the shares are lowered where they are exceeded, and the
  // search goes on; cells in which that does not help are halved. Where the search diverges, or
  // so many refinements are not enough, a plan from rest is slowed down as a whole until it
  // keeps them (slowed_down() if by more than a percent; cutting the sequence of cells at a rest
  // then loses little); from a begin in motion there is no plan. The cells must be refined for a
  // rest at the end, and for one at the beginning if the sequence begins at rest.
  static constexpr int kRefinements = 40;
  static std::optional<OptimalPlan> find(CellSequence sequence, const PathAt& path,
                                         const PlanLimits& limits, int refinements = kRefinements);

  [[nodiscard]] const std::vector<Cell>& cells() const noexcept { return sequence_.cells; }
  [[nodiscard]] StartState state_at(const PlanPlace& place) const;
  // The law from there on, at the most to the cell's end and for no longer than about longest_s.
  [[nodiscard]] profiles::CellLaw law_from(const PlanPlace& place, double longest_s) const;
  [[nodiscard]] double duration_s() const;
  // Of the blocks that end in it.
  [[nodiscard]] std::vector<BlockPassing> passings() const;
  // The constraint that limits the feedrate on a cell.
  [[nodiscard]] Constraint limit_on(std::size_t cell, const PlanLimits& limits) const;
  // The first of the cells on which the feedrate only falls, down to the rest at the end.
  [[nodiscard]] std::size_t last_braking() const;
  // They are more than a quarter of all.
  [[nodiscard]] bool brakes_long() const;
  // The cells of the plan from a place on, to be planned anew.
  [[nodiscard]] CellSequence rest_from(const PlanPlace& place) const;

  // The largest figures over their limits that the check found, and how the plan was found.
  [[nodiscard]] const Excess& excess() const noexcept { return excess_; }
  [[nodiscard]] int newton_steps() const noexcept { return newton_steps_; }
  [[nodiscard]] bool slowed_down() const noexcept { return slowed_down_; }

 private:
  [[nodiscard]] SquaredFeed feed_at(const PlanPlace& place) const;
  [[nodiscard]] bool is_launch(std::size_t cell) const noexcept {
    return cell == 0 && sequence_.begin.at_rest();
  }
  [[nodiscard]] bool is_landing(std::size_t cell) const noexcept {
    return cell + 1 == sequence_.cells.size();
  }
  [[nodiscard]] SplineRange whole_spline() const noexcept {
    return {.begin = 0, .end = sequence_.spline_cells()};
  }
  // Which limits are exceeded, and by how much; lowers the shares of those cells. found: of each
  // cell of the sequence, renewed in the range and in the launch and landing that it meets.
  void check(const SplineRange& range, const PathAt& path, const PlanLimits& limits,
             std::vector<Excess>& found);
  // Around the cells that exceed a limit, with so many cells beside them.
  [[nodiscard]] std::vector<SplineRange> exceeded_ranges(std::span<const Excess> found,
                                                         std::size_t beside) const;
  // Halves the cells that exceed a limit; the planned motion stays as it is.
  void halve_cells(const PathAt& path, const PlanLimits& limits);
  void slow_down(const PathAt& path, const PlanLimits& limits);

  CellSequence sequence_{};
  std::vector<CellBasis> basis_;
  std::vector<double> coefficients_;
  Excess excess_{};
  double aim_of_feedrate_ = kAim;  // where a check found it exceeded
  int newton_steps_ = 0;
  bool slowed_down_ = false;
};

}  // namespace kerf::lookahead
