// What the time optimum minimises: the time, and a wall in front of every limit.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lookahead/limits.hpp"
#include "lookahead/optimum/band_system.hpp"
#include "lookahead/optimum/barrier.hpp"
#include "lookahead/optimum/cell.hpp"
#include "lookahead/optimum/feed_spline.hpp"

namespace kerf::lookahead {

// The cells of one stretch, the first one a launch from rest where it begins at rest, the last one
// a landing; between them the feedrate squared is a spline.
struct Stretch {
  StretchBegin begin{};
  std::vector<Cell> cells;

  [[nodiscard]] std::size_t first_spline_cell() const noexcept { return begin.at_rest() ? 1 : 0; }
  [[nodiscard]] std::size_t spline_cells() const noexcept {
    return cells.size() - 1 - first_spline_cell();
  }
};

// How sharp the walls are.
struct Walls {
  double weight_s = 0.0;  // of each
  double relaxed = 0.0;   // Barrier
};

// T(c) + weight sum of barriers over the limits at both ends of each cell, c the coefficients of
// the spline. Along the path: v^2 <= cap^2, |b'| / 2 <= A, sqrt(b) |b''| / 2 <= J; on an axis:
// |q' b' / 2 + q'' b| <= A and sqrt(b) |q' b'' / 2 + 3/2 q'' b' + q''' b| <= J (MATH section 9).
//
// In the derivatives each limit is taken as linear about the present c, so the second derivative
// misses the curvature of the jerk's sqrt(b): it is positive definite, and the search converges
// fast, though not quadratically. Two coefficients at each end depend on their neighbours: a launch
// of constant jerk over h joins the spline where b' = 4/3 b / h, a begin in motion fixes both.
class Merit {
 public:
  Merit(const Stretch& stretch, const PlanLimits& limits);

  [[nodiscard]] std::size_t size() const noexcept { return stretch_->spline_cells() + 2; }
  // Of the coefficients those that are free.
  [[nodiscard]] BandSystem::Rows free_rows() const noexcept;
  // Gives the coefficients that are not free their values.
  void bind(std::vector<double>& coefficients) const noexcept;
  // The same of a change of the coefficients.
  void bind_change(std::vector<double>& change) const noexcept;

  // Infinite where b is not positive.
  [[nodiscard]] double value(const std::vector<double>& coefficients, const Walls& walls) const;
  // The Newton system at these coefficients, for the free rows.
  void derive(const std::vector<double>& coefficients, const Walls& walls,
              BandSystem& system) const;

  // On the cells of the spline.
  [[nodiscard]] const Basis& begin_basis(std::size_t i) const { return basis_[i].begin; }
  // The largest jerk of the launch or landing in a cell, along the path.
  [[nodiscard]] static double rest_jerk_mm_s3(const Cell& cell, const CellEnd& end,
                                              const PlanLimits& limits);

 private:
  struct RestCell {
    double length_mm = 0.0;  // 0: none
    double cap = 0.0;        // of v^2 where it meets the spline
    double gain = 0.0;       // the outermost coefficient over its neighbour
  };

  // rest: the end at rest; inner: the other one.
  struct RestEnds {
    const CellEnd* rest = nullptr;
    const CellEnd* inner = nullptr;
  };
  [[nodiscard]] RestCell rest_cell(const Cell& cell, const RestEnds& ends,
                                   double neighbour_mm) const;
  template <typename Sum>
  bool visit(const std::vector<double>& coefficients, Sum& sum) const;

  const Stretch* stretch_;
  const PlanLimits* limits_;
  std::vector<CellBasis> basis_;
  RestCell launch_{};
  RestCell landing_{};
};

}  // namespace kerf::lookahead
