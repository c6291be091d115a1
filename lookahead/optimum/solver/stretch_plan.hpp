// The planned motion over one stretch: from where the tool is to a rest.
#pragma once

#include <optional>
#include <vector>

#include "lookahead/optimum/solver/barrier_objective.hpp"
#include "lookahead/optimum/solver/limit_check.hpp"
#include "profiles/cell_law.hpp"

namespace kerf::lookahead {

// A place in a plan: on a cell, so far from its beginning.
struct PlanPlace {
  std::size_t cell = 0;
  double offset_mm = 0.0;
};

class StretchPlan {
 public:
  StretchPlan() = default;

  // The fastest plan found whose limits hold between the places at which the solver looks, too:
  // they are checked there, shares are taken off where they are passed, and the search goes on, in
  // at most kMaxRefinements rounds. Where that is not enough, a plan from rest is slowed down as a
  // whole until it holds (slowed_down where that is by more than a percent; cut the stretch at a
  // rest, and little is lost); from a begin in motion there is none. The cells must be refined for
  // a rest at the end and for one at the beginning if the stretch begins at rest.
  static std::optional<StretchPlan> find(Stretch stretch, const PathAt& path,
                                         const PlanLimits& limits);

  [[nodiscard]] const std::vector<Cell>& cells() const noexcept { return stretch_.cells; }
  [[nodiscard]] StretchBegin state_at(const PlanPlace& place) const;
  // From there on, at the most to the cell's end and for no longer than about the duration.
  [[nodiscard]] profiles::CellLaw law_from(const PlanPlace& place, double longest_s) const;
  [[nodiscard]] double duration_s() const;
  // What holds the feed down on a cell.
  [[nodiscard]] Constraint limit_on(std::size_t cell, const PlanLimits& limits) const;
  // The first cell of those on which the feedrate only falls, to the rest at the end.
  [[nodiscard]] std::size_t last_braking() const;
  // What is left of the plan from a place up to a cell, to be planned anew.
  [[nodiscard]] Stretch rest_from(const PlanPlace& place, std::size_t end_cell) const;

  // The largest figure over its limit that the check found, and how it was found.
  [[nodiscard]] const Excess& excess() const noexcept { return excess_; }
  [[nodiscard]] int newton_steps() const noexcept { return newton_steps_; }
  [[nodiscard]] bool slowed_down() const noexcept { return slowed_down_; }

 private:
  [[nodiscard]] SquaredFeed feed_at(const PlanPlace& place) const;
  [[nodiscard]] bool is_launch(std::size_t cell) const noexcept {
    return cell == 0 && stretch_.begin.at_rest();
  }
  [[nodiscard]] bool is_landing(std::size_t cell) const noexcept {
    return cell + 1 == stretch_.cells.size();
  }
  // What is passed, and by how much; shares are taken off the cells where it is.
  Excess check(const PathAt& path, const PlanLimits& limits);
  void slow_down(const PathAt& path, const PlanLimits& limits);

  Stretch stretch_{};
  std::vector<CellBasis> basis_;
  std::vector<double> coefficients_;
  Excess excess_{};
  int newton_steps_ = 0;
  bool slowed_down_ = false;
};

}  // namespace kerf::lookahead
