#include <cmath>

#include "curves/curve_builders.hpp"

namespace kerf::curves {

namespace {

constexpr double kMinWeight = 0.5;  // of the origin's, within a piece

double beside_mm(const Eigen::Vector3d& offset, const Eigen::Vector3d& direction) {
  return (offset - offset.dot(direction) * direction).norm();
}

// A bound: the sizes of the powers' vectors added up, over the least weight.
double farthest_mm(const NurbsPiece& piece, const Position& start_mm,
                   const Eigen::Vector3d& direction) {
  double sum = 0.0;
  double weight = 1.0;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(piece.degree); ++k) {
    const auto& power = piece.coefficients[k];
    sum += beside_mm({power[0], power[1], power[2]}, direction);
    weight -= std::abs(power[3]);
  }
  if (!(weight > kMinWeight)) {
    return HUGE_VAL;
  }
  return beside_mm(vec(piece.origin_mm) - vec(start_mm), direction) + sum / weight;
}

}  // namespace

std::optional<Line> straight(const NurbsCurve& curve) {
  const Position start_mm = curve.at(0.0);
  const auto line = Line::between(start_mm, curve.at(curve.length_mm()));
  if (!line || curve.length_mm() - line->length_mm() > kStraight_mm) {
    return std::nullopt;
  }
  const Eigen::Vector3d direction = vec(line->direction());
  for (const NurbsPiece& piece : curve.pieces()) {
    if (!(farthest_mm(piece, start_mm, direction) <= kStraight_mm)) {
      return std::nullopt;
    }
  }
  return *line;
}

}  // namespace kerf::curves
