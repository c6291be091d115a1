// The objective of the time optimum: the time, and a barrier for every limit.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/solver/band_system.hpp"
#include "lookahead/optimum/solver/barrier.hpp"
#include "lookahead/optimum/solver/feed_spline.hpp"
#include "lookahead/optimum/solver/limit_rows.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

// Cells that are planned at once. If they begin at rest the first one is a launch; the last one
// is a landing; between them the feedrate squared is a spline.
struct CellSequence {
  StartState begin{};
  std::vector<Cell> cells;

  [[nodiscard]] std::size_t first_spline_cell() const noexcept { return begin.at_rest() ? 1 : 0; }
  [[nodiscard]] std::size_t spline_cells() const noexcept {
    return cells.size() - 1 - first_spline_cell();
  }
  [[nodiscard]] std::vector<double> spline_lengths_mm() const {
    std::vector<double> lengths(spline_cells());
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      lengths[i] = cells[i + first_spline_cell()].length_mm;
    }
    return lengths;
  }
};

// Cells of the spline of a sequence, counted from its first.
struct SplineRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] std::size_t size() const noexcept { return end - begin; }
};

// T(c) + weight sum of barriers over the limits of each cell (limit_rows), c the coefficients of
// the spline.
//
// In the derivatives each limit is taken as linear about the present c, so the second derivative
// misses the curvature of the jerk's sqrt(b): it is positive definite, and the search converges
// fast, though not quadratically. Two coefficients at each end depend on their neighbours: a launch
// of constant jerk over h joins the spline where b' = 4/3 b / h, a begin in motion fixes both. On a
// range of the cells, whose coefficients are those of the whole from range.begin on, both are fixed
// at an end within the spline, so that the feedrate beyond the range stays as it is.
class BarrierObjective {
 public:
  BarrierObjective(const CellSequence& sequence, const PlanLimits& limits)
      : BarrierObjective(sequence, limits, {.begin = 0, .end = sequence.spline_cells()}) {}
  BarrierObjective(const CellSequence& sequence, const PlanLimits& limits,
                   const SplineRange& range);

  [[nodiscard]] std::size_t size() const noexcept { return range_.size() + 2; }
  // The free coefficients.
  [[nodiscard]] BandSystem::Rows free_rows() const noexcept;
  // Gives the coefficients that are not free their values.
  void bind(std::vector<double>& coefficients) const noexcept;
  // The same for a change of the coefficients.
  void bind_change(std::vector<double>& change) const noexcept;

  struct Value {
    double time_s = 0.0;
    double objective_s = 0.0;  // infinite where b is not positive
  };
  [[nodiscard]] Value value(const std::vector<double>& coefficients,
                            const BarrierWeights& weights) const;
  // At these coefficients, with the Newton system for the free rows.
  [[nodiscard]] Value derive(const std::vector<double>& coefficients, const BarrierWeights& weights,
                             BandSystem& system) const;

 private:
  struct RestCell {
    double length_mm = 0.0;  // 0: none
    double cap = 0.0;        // of v^2 where it meets the spline
    double gain = 0.0;       // the outermost coefficient over its neighbour
  };

  // rest: the end at rest; inner: the other one.
  struct RestEnds {
    const PathSample* rest = nullptr;
    const PathSample* inner = nullptr;
  };
  [[nodiscard]] RestCell rest_cell(const Cell& cell, const RestEnds& ends,
                                   double neighbour_mm) const;
  struct Sums;
  // ends: what launch and landing are added to.
  template <Order kOrder>
  [[nodiscard]] Value sum(const std::vector<double>& coefficients, Sums ends) const;
  // For the launch or landing, which meets the spline at its outermost coefficient.
  void add_rest(const RestCell& rest, std::size_t outer, const std::vector<double>& coefficients,
                Sums& sums) const;
  void fold_ends(BandSystem& system) const;
  [[nodiscard]] bool launches() const noexcept { return launch_.length_mm > 0.0; }
  [[nodiscard]] bool lands() const noexcept { return landing_.length_mm > 0.0; }
  // The begin of the range is that of a sequence in motion.
  [[nodiscard]] bool begins_in_motion() const noexcept {
    return range_.begin == 0 && !sequence_->begin.at_rest();
  }

  const CellSequence* sequence_;
  const PlanLimits* limits_;
  SplineRange range_;
  LimitRows rows_;
  RestCell launch_{};
  RestCell landing_{};
};

}  // namespace kerf::lookahead
