// The way to rest by the search for the time optimum.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lookahead/optimum/braking.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"
#include "lookahead/optimum/stop_cells.hpp"
#include "lookahead/optimum/way_ahead.hpp"

namespace kerf::lookahead {

// Of a rest that may be any one, over the way of the S-curve.
enum class StopDistance : std::uint8_t { near, far, farthest };
inline constexpr std::array kStopDistances{StopDistance::near, StopDistance::far,
                                           StopDistance::farthest};

// The search over the cells ahead, to a rest at one distance after the other.
//
// The solver finds the fastest way to a given rest; the nearest rest to which there is a way is
// found by trying. Each try begins with the S-curve of the limits at this place, drawn out to the
// distance: it decelerates less than they allow, so the solver begins within the limits and takes
// some twenty Newton steps. The first cells are shorter than the others: a jerk that the motion
// needs where it begins may be one that it does not bear for a whole cell. An S-curve in closed
// form stands in where it keeps the limits when it is looked at twice a tick.
//
// A way made step by step (steepest_braking) is the bound: no rest farther away is tried, and it is
// the way where the solver finds none, as where the motion needs all of an axis' jerk: the solver
// aims at 0.9995 of the limits.
//
// A try that ends well takes a quarter of the time of one that does not. So the first is of a rest
// to which there is a way in most cases; then the distance is divided down as long as there is
// time.
//
// Weakness: where there are no steps either all tries may fail, which takes ten milliseconds and
// more. The caller tries other places of the plan, of a stop that may be any one first.
class StopSearch {
 public:
  StopSearch(const BrakingFrom& from, const PlanLimits& limits);

  [[nodiscard]] std::optional<std::vector<BrakingPart>> shortest(const IsLate& is_late) const;
  [[nodiscard]] std::optional<std::vector<BrakingPart>> any(StopDistance distance) const;

 private:
  [[nodiscard]] std::optional<profiles::SCurveStop> s_curve(double share) const;
  [[nodiscard]] std::optional<std::vector<BrakingPart>> in_closed_form() const;
  [[nodiscard]] std::optional<std::vector<BrakingPart>> s_curve_parts(double share) const;
  [[nodiscard]] std::optional<std::vector<BrakingPart>> steepest() const;
  // Nothing: they exceed a limit, or cannot stand ready for a late planner.
  [[nodiscard]] std::optional<std::vector<BrakingPart>> parts_along(
      std::span<const BrakingLaw> laws) const;
  void take_s_curve();
  void begin_with_s_curve(double distance_mm, std::vector<Cell>& cells) const;
  // The distance reaches to the end of what is known: a rest at it is there.
  [[nodiscard]] bool reaches_end(double distance_mm) const;
  struct Tried {
    std::optional<std::vector<BrakingPart>> best{};
    double best_mm = 0.0;
    double too_short_mm = 0.0;  // the longest without a way
    bool is_end = false;        // of the last distance: reaches_end()
    StopGrid grid = StopGrid::coarse;
  };
  void divide_down(const IsLate& is_late, Tried& tried) const;
  void try_at(double distance_mm, Tried& tried) const;
  // That far the way is known, over no more cells than a search can have.
  [[nodiscard]] bool is_in_reach(double distance_mm) const;
  struct RestTry {
    std::optional<OptimalPlan> plan{};
    bool is_end = false;  // reaches_end(), where it is in reach
  };
  [[nodiscard]] RestTry to_rest_at(double distance_mm, StopGrid grid) const;
  [[nodiscard]] std::vector<BrakingPart> parts(const OptimalPlan& plan) const;

  const BrakingFrom* from_;
  const PlanLimits* limits_;
  WayAhead way_;
  // The search begins with it.
  struct SCurvePoint {
    double s_mm = 0.0;  // from the begin
    double v_squared = 0.0;
  };
  std::vector<SCurvePoint> s_curve_;
};

}  // namespace kerf::lookahead
