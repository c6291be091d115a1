// The way to rest by the search for the time optimum.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lookahead/optimum/braking.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

// The search over the cells ahead, to a rest at any distance.
class StopSearch {
 public:
  StopSearch(const BrakingFrom& from, const PlanLimits& limits);

  [[nodiscard]] std::optional<std::vector<BrakingPart>> shortest() const;
  [[nodiscard]] std::optional<std::vector<BrakingPart>> any() const;

 private:
  void take_blocks();
  void take_cells();
  void cut_at_ends(const PathAt& path);
  [[nodiscard]] std::optional<profiles::SCurveStop> s_curve(double share) const;
  [[nodiscard]] std::optional<std::vector<BrakingPart>> in_closed_form() const;
  [[nodiscard]] bool keeps_limits(const profiles::SCurveStop& stop) const;
  void take_s_curve();
  void begin_with_s_curve(double distance_mm, std::vector<Cell>& cells) const;
  // is_end: the distance reaches to the end of what is known, and the rest is there.
  [[nodiscard]] std::optional<OptimalPlan> to_rest_at(double distance_mm, bool& is_end) const;
  [[nodiscard]] std::vector<BrakingPart> parts(const OptimalPlan& plan) const;

  const BrakingFrom* from_;
  const PlanLimits* limits_;
  WaitingCells waiting_;
  Window<Block> blocks_;
  std::uint64_t first_ = 0;  // of blocks_: the one that the motion is on
  double first_begin_mm_ = 0.0;
  bool last_is_cut_ = false;
  std::vector<Cell> cells_;
  // The search begins with it.
  struct SCurvePoint {
    double s_mm = 0.0;  // from the begin
    double v_squared = 0.0;
  };
  std::vector<SCurvePoint> s_curve_;
};

}  // namespace kerf::lookahead
