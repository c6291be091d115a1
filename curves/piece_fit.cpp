// Idea. |dC/dx| is sampled at 16 Gauss nodes; one matrix product gives the arc length at ten
// Chebyshev-Lobatto points x_j, and the polynomial through the pairs (s_j, x_j), interpolated the
// other way round, is x(s): no iteration. Another product gives the arc length at points between,
// where the polynomial has to agree to kFitTolerance_mm; if it does not, or the last Legendre
// coefficients of the speed have not died away, the piece is too long.
#include "curves/piece_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "curves/arc_length_rule.hpp"

namespace kerf::curves {
namespace {

constexpr double kFitTolerance_mm = 1e-12;
constexpr double kRelativeFitTolerance = 1e-14;  // what double can do on long pieces
constexpr double kShort_mm = 1.0;  // up to this double will do for the interpolation, too

using Rule = ArcLengthRule;
using MapCoefficients = std::array<double, NurbsPiece::kMapDegree + 1>;

// The polynomial x(y) through (y_j, x_j), x_j the rule's knots, by divided differences, as powers
// of y. Unrolled, for it is most of what a fit costs.
template <typename Real>
MapCoefficients interpolate_inverse(const Eigen::Matrix<double, Rule::kKnots, 1>& y) {
  constexpr int kCount = Rule::kKnots;
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): it is converted, if Real is wider.
  const Eigen::Matrix<Real, kCount, 1> node = y.cast<Real>();
  Eigen::Matrix<Real, kCount, 1> difference = Rule::get().knots.cast<Real>();
  std::array<Real, kCount> divided{difference[0]};
#pragma GCC unroll 16
  for (int level = 1; level < kCount; ++level) {
#pragma GCC unroll 16
    for (int j = 0; j < kCount - level; ++j) {
      difference[j] = (difference[j + 1] - difference[j]) / (node[j + level] - node[j]);
    }
    divided[static_cast<std::size_t>(level)] = difference[0];
  }
  std::array<Real, kCount> power{};
#pragma GCC unroll 16
  for (std::size_t done = 1; done <= kCount; ++done) {
    const Real at = node[static_cast<Eigen::Index>(kCount - done)];
    Real lower = divided[kCount - done];
#pragma GCC unroll 16
    for (std::size_t k = 0; k < done; ++k) {
      lower = std::exchange(power[k], lower - at * power[k]);
    }
  }
  MapCoefficients result{};
  std::transform(power.begin(), power.end(), result.begin(),
                 [](Real c) { return static_cast<double>(c); });
  return result;
}

double tolerance_mm(double length_mm) {
  return std::max(kFitTolerance_mm, kRelativeFitTolerance * length_mm);
}

}  // namespace

NurbsPiece unmapped_piece(const BezierSpan& right_half, Wide u_begin) {
  NurbsPiece piece;
  piece.degree = right_half.degree;
  piece.u_begin = static_cast<double>(u_begin);
  piece.u_end = static_cast<double>(right_half.u_end);
  piece.origin_mm = narrow(right_half.origin_mm);
  // The half's coordinates count from its begin in long double; move them to the rounded origin.
  const WideVector rounding_mm = right_half.origin_mm - widen(piece.origin_mm);
  const auto taylor = taylor_at_begin(right_half);
  const Wide scale = 1.0L / taylor[0].w();
  for (std::size_t k = 0; k < right_half.count(); ++k) {
    WidePoint c = scale * taylor[k];
    c.head<3>() += c.w() * rounding_mm;
    for (std::size_t i = 0; i < 4; ++i) {
      piece.coefficients[k][i] = static_cast<double>(c[static_cast<Eigen::Index>(i)]);
    }
  }
  return piece;
}

std::optional<LengthMap> length_map(const NodeSpeeds& speed) {
  const Rule& rule = Rule::get();
  const double length_mm = rule.weights.dot(speed);
  if (!(rule.to_tail.lazyProduct(speed).cwiseAbs().sum() <= tolerance_mm(length_mm))) {
    return std::nullopt;
  }
  const double to_scaled = 2.0 / length_mm;
  Eigen::Matrix<double, Rule::kKnots, 1> y = rule.to_knots.lazyProduct(speed) * to_scaled;
  y.array() -= 1.0;
  y[0] = -1.0;
  y[Rule::kKnots - 1] = 1.0;
  for (int j = 1; j < Rule::kKnots; ++j) {
    if (!(y[j] > y[j - 1])) {
      return std::nullopt;
    }
  }
  return LengthMap{length_mm, length_mm <= kShort_mm ? interpolate_inverse<double>(y)
                                                     : interpolate_inverse<Wide>(y)};
}

bool holds(const LengthMap& map, const NodeSpeeds& speed, const CheckSpeeds& at_checks) {
  using Checks = Eigen::Array<double, Rule::kChecks, 1>;
  const Rule& rule = Rule::get();
  const Checks y = rule.to_checks.lazyProduct(speed).array() * (2.0 / map.length_mm) - 1.0;
  Checks x = Checks::Zero();
  for (std::size_t k = map.local_by_length.size(); k-- > 0;) {
    x = x * y + map.local_by_length[k];
  }
  const Checks off_mm = (x - rule.checks.array()) * at_checks.array();
  return (off_mm.abs() <= tolerance_mm(map.length_mm)).all();
}

double fit_length_map(NurbsPiece& piece) {
  const Rule& rule = Rule::get();
  const auto speed_at = [&piece](double x) { return speed_mm(piece, x); };
  const NodeSpeeds speed = rule.nodes.unaryExpr(speed_at);
  const auto map = length_map(speed);
  if (!map || !holds(*map, speed, rule.checks.unaryExpr(speed_at))) {
    return -1.0;
  }
  piece.local_by_length = map->local_by_length;
  return map->length_mm;
}

}  // namespace kerf::curves
