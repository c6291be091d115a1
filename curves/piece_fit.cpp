// Idea. |dC/dx| is sampled at 16 Gauss nodes; one matrix product gives the arc length at ten
// Chebyshev-Lobatto points x_j, and the polynomial through the pairs (s_j, x_j), interpolated the
// other way round, is x(s): no iteration. Another product gives the arc length at points between,
// where the polynomial has to agree to kFitTolerance_mm; if it does not, or the last Legendre
// coefficients of the speed have not died away, the piece is too long.
#include "curves/piece_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "curves/arc_length_rule.hpp"

namespace kerf::curves {
namespace {

constexpr double kFitTolerance_mm = 1e-12;
constexpr double kRelativeFitTolerance = 1e-14;  // what double can do on long pieces

using Rule = ArcLengthRule;
using MapCoefficients = std::array<double, NurbsPiece::kMapDegree + 1>;

// The polynomial x(y) through (y_j, knots_j), by divided differences, as powers of y.
MapCoefficients interpolate_inverse(const Eigen::Matrix<double, Rule::kKnots, 1>& y,
                                    const Eigen::Matrix<double, Rule::kKnots, 1>& x) {
  constexpr int kCount = Rule::kKnots;
  Eigen::Matrix<Wide, kCount, 1> node = y.cast<Wide>();
  Eigen::Matrix<Wide, kCount, 1> divided = x.cast<Wide>();
  for (int level = 1; level < kCount; ++level) {
    for (int j = kCount - 1; j >= level; --j) {
      divided[j] = (divided[j] - divided[j - 1]) / (node[j] - node[j - level]);
    }
  }
  std::array<Wide, kCount> power{};
  for (int j = kCount - 1; j >= 0; --j) {
    for (int k = kCount - 1; k > 0; --k) {
      const auto i = static_cast<std::size_t>(k);
      power[i] = power[i - 1] - node[j] * power[i];
    }
    power[0] = divided[j] - node[j] * power[0];
  }
  MapCoefficients result{};
  std::transform(power.begin(), power.end(), result.begin(),
                 [](Wide c) { return static_cast<double>(c); });
  return result;
}

double horner(const MapCoefficients& c, double y) {
  double x = 0.0;
  for (std::size_t k = c.size(); k-- > 0;) {
    x = x * y + c[k];
  }
  return x;
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

double fit_length_map(NurbsPiece& piece) {
  const Rule& rule = Rule::get();
  Eigen::Matrix<double, Rule::kNodes, 1> speed;
  for (int i = 0; i < Rule::kNodes; ++i) {
    speed[i] = speed_mm(piece, rule.nodes[i]);
  }
  const double length_mm = rule.weights.dot(speed);
  const double tolerance_mm = std::max(kFitTolerance_mm, kRelativeFitTolerance * length_mm);
  if (!((rule.to_tail * speed).cwiseAbs().sum() <= tolerance_mm)) {
    return -1.0;
  }

  const double to_scaled = 2.0 / length_mm;
  Eigen::Matrix<double, Rule::kKnots, 1> y = (rule.to_knots * speed) * to_scaled;
  y.array() -= 1.0;
  y[0] = -1.0;
  y[Rule::kKnots - 1] = 1.0;
  for (int j = 1; j < Rule::kKnots; ++j) {
    if (!(y[j] > y[j - 1])) {
      return -1.0;
    }
  }
  piece.local_by_length = interpolate_inverse(y, rule.knots);
  const Eigen::Matrix<double, Rule::kChecks, 1> s_mm = rule.to_checks * speed;
  for (int j = 0; j < Rule::kChecks; ++j) {
    const double x = horner(piece.local_by_length, s_mm[j] * to_scaled - 1.0);
    const double off_mm = (x - rule.checks[j]) * speed_mm(piece, rule.checks[j]);
    if (!(std::abs(off_mm) <= tolerance_mm)) {
      return -1.0;
    }
  }
  return length_mm;
}

}  // namespace kerf::curves
