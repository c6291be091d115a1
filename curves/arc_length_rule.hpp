// Quadrature on [-1, 1] as matrices: samples of a speed at Gauss nodes to arc lengths at other
// points. Look-ahead side only.
//
// The samples at kNodes Gauss-Legendre nodes define an interpolating polynomial; its Legendre
// coefficients are sums over the samples (exact quadrature of degree 2 kNodes - 1), and each
// Legendre polynomial has its integral in closed form, (P[k+1] - P[k-1]) / (2 k + 1). So the
// integral up to any fixed x is one dot product with weights known beforehand. (Legendre series:
// [Trefethen, chapters 17 and 19].)
#pragma once

#include <Eigen/Core>

#include "curves/nurbs_piece.hpp"

namespace kerf::curves {

struct ArcLengthRule {
  static constexpr int kNodes = 16;
  static constexpr int kKnots = NurbsPiece::kMapDegree + 1;  // where x(s) interpolates
  static constexpr int kChecks = NurbsPiece::kMapDegree;     // between them
  static constexpr int kTail = 3;

  Eigen::Matrix<double, kNodes, 1> nodes;
  Eigen::Matrix<double, kNodes, 1> weights;
  Eigen::Matrix<double, kKnots, 1> knots;    // Chebyshev-Lobatto: ends included
  Eigen::Matrix<double, kChecks, 1> checks;  // about where the interpolation errs most
  Eigen::Matrix<double, kKnots, kNodes> to_knots;
  Eigen::Matrix<double, kChecks, kNodes> to_checks;
  Eigen::Matrix<double, kTail, kNodes> to_tail;  // the last Legendre coefficients

  // Computed once.
  static const ArcLengthRule& get();

 private:
  ArcLengthRule();
};

}  // namespace kerf::curves
