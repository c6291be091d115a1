// One piece of the arc-length map: its geometry and the polynomial x(s). Look-ahead side only.
#pragma once

#include <array>
#include <optional>

#include "curves/arc_length_rule.hpp"
#include "curves/bezier_span.hpp"
#include "curves/nurbs_piece.hpp"

namespace kerf::curves {

// The piece from u_begin whose right half is given, without x(s) and its place along the curve.
NurbsPiece unmapped_piece(const BezierSpan& right_half, Wide u_begin);

// |dC/dx| at the nodes and at the checks of ArcLengthRule.
using NodeSpeeds = Eigen::Matrix<double, ArcLengthRule::kNodes, 1>;
using CheckSpeeds = Eigen::Matrix<double, ArcLengthRule::kChecks, 1>;

struct LengthMap {
  double length_mm = 0.0;
  std::array<double, NurbsPiece::kMapDegree + 1> local_by_length{};
};

// x(s) by what the speed is at the nodes. Nothing: the piece has to be halved first.
std::optional<LengthMap> length_map(const NodeSpeeds& speed);
// Whether it holds between the nodes, too.
bool holds(const LengthMap& map, const NodeSpeeds& speed, const CheckSpeeds& at_checks);

// Fits x(s) to the piece and returns its length in mm; negative: it has to be halved first.
double fit_length_map(NurbsPiece& piece);

}  // namespace kerf::curves
