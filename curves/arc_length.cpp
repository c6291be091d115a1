// Idea. On an interval of u halved until the curve is tame there, |dC/dx| is sampled at 16 Gauss
// nodes; one matrix product gives the arc length at ten Chebyshev-Lobatto points x_j, and the
// polynomial through the pairs (s_j, x_j), interpolated the other way round, is x(s): no iteration.
// Another product gives the arc length at points between, where the polynomial has to agree to
// kFitTolerance_mm; if it does not, or the last Legendre coefficients of the speed have not died
// away, the interval is halved. Convergence is geometric, so a curve without singularities takes
// few pieces, and each factor of 10 in accuracy a quarter more of them.
//
// Where |C'(u)| tends to zero x(s) is singular (like a root of s). Halving then closes in on the
// point geometrically until the piece is shorter than the tolerance, where any x(s) will do: about
// 20 to 40 pieces. A piece that short whose ends point in opposite directions is a cusp.
//
// Weakness: a near-cusp sharper than 1e-12 mm is taken for a cusp, and curves whose coordinates
// differ by less than 1e-12 mm are taken for points.
#include "curves/arc_length.hpp"

#include <algorithm>
#include <cmath>

#include "curves/arc_length_rule.hpp"

namespace kerf::curves {
namespace {

constexpr double kFitTolerance_mm = 1e-12;
constexpr double kRelativeFitTolerance = 1e-14;  // what double can do on long pieces
constexpr Wide kPointLike_mm = 1e-12L;
// Control points closer than this share of a piece's size coincide: the first one beyond shows the
// tangent. Generous, because rounding moves points that should coincide, and only turning back is
// looked for.
constexpr Wide kCoincident = 1e-6L;
constexpr Wide kMostWeightRatio = 16.0L;  // in one piece, so that its polynomials lose no digits
constexpr double kShortestCurve_mm = 1e-9;
constexpr int kDepth = 90;

using Rule = ArcLengthRule;
using MapCoefficients = std::array<double, NurbsPiece::kMapDegree + 1>;

// The polynomial x(y) through (y_j, knots_j), by divided differences, as powers of y.
MapCoefficients interpolate_inverse(const Eigen::Matrix<double, Rule::kKnots, 1>& y,
                                    const Eigen::Matrix<double, Rule::kKnots, 1>& x) {
  constexpr int n = Rule::kKnots;
  Eigen::Matrix<Wide, n, 1> node = y.cast<Wide>();
  Eigen::Matrix<Wide, n, 1> divided = x.cast<Wide>();
  for (int level = 1; level < n; ++level) {
    for (int j = n - 1; j >= level; --j) {
      divided[j] = (divided[j] - divided[j - 1]) / (node[j] - node[j - level]);
    }
  }
  std::array<Wide, n> power{};
  for (int j = n - 1; j >= 0; --j) {
    for (int k = n - 1; k > 0; --k) {
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
  for (std::size_t k = c.size(); k-- > 0;)
    x = x * y + c[k];
  return x;
}

NurbsPiece geometry_of(const BezierSpan& whole, const BezierSpan& right_half) {
  NurbsPiece piece;
  piece.degree = whole.degree;
  piece.u_begin = static_cast<double>(whole.u_begin);
  piece.u_end = static_cast<double>(whole.u_end);
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

// Fits x(s) to the piece and returns its length; negative if it has to be halved.
double fit(NurbsPiece& piece) {
  const Rule& rule = Rule::get();
  Eigen::Matrix<double, Rule::kNodes, 1> speed;
  for (int i = 0; i < Rule::kNodes; ++i)
    speed[i] = speed_mm(piece, rule.nodes[i]);
  const double length_mm = rule.weights.dot(speed);
  const double tolerance_mm = std::max(kFitTolerance_mm, kRelativeFitTolerance * length_mm);
  if (!((rule.to_tail * speed).cwiseAbs().sum() <= tolerance_mm))
    return -1.0;

  const double to_scaled = 2.0 / length_mm;
  Eigen::Matrix<double, Rule::kKnots, 1> y = (rule.to_knots * speed) * to_scaled;
  y.array() -= 1.0;
  y[0] = -1.0;
  y[Rule::kKnots - 1] = 1.0;
  for (int j = 1; j < Rule::kKnots; ++j) {
    if (!(y[j] > y[j - 1]))
      return -1.0;
  }
  piece.local_by_length = interpolate_inverse(y, rule.knots);
  const Eigen::Matrix<double, Rule::kChecks, 1> s_mm = rule.to_checks * speed;
  for (int j = 0; j < Rule::kChecks; ++j) {
    const double x = horner(piece.local_by_length, s_mm[j] * to_scaled - 1.0);
    const double off_mm = (x - rule.checks[j]) * speed_mm(piece, rule.checks[j]);
    if (!(std::abs(off_mm) <= tolerance_mm))
      return -1.0;
  }
  return length_mm;
}

CurveError cusp_at(Wide u, const Position& p_mm) {
  return {"the curve turns back on itself in a cusp at u = " + to_text(static_cast<double>(u)) +
          ", " + to_text(p_mm)};
}

// Maps one span after the other, left to right.
class Mapper {
 public:
  std::vector<NurbsPiece> pieces;
  Wide length_mm = 0.0L;

  tl::expected<void, CurveError> add(const BezierSpan& span) {
    last_direction_ = WideVector::Zero();
    pending_.assign(1, {span, 0});
    while (!pending_.empty()) {
      const auto [current, depth] = pending_.back();
      pending_.pop_back();
      const auto [left, right] = halve(current);
      const Wide polygon_mm = current.polygon_length_mm();
      NurbsPiece piece = geometry_of(current, right);
      double piece_mm = -1.0;
      if (polygon_mm <= kPointLike_mm) {
        piece_mm = static_cast<double>(polygon_mm);
        piece.local_by_length = {0.0, 1.0};
      } else if (current.weight_ratio() <= kMostWeightRatio) {
        piece_mm = fit(piece);
      }
      if (piece_mm >= 0.0) {
        if (turns_back(current, polygon_mm)) {
          return tl::unexpected(cusp_at(current.u_begin, current.begin_mm()));
        }
        append(piece, piece_mm);
      } else if (depth < kDepth) {
        pending_.push_back({right, depth + 1});
        pending_.push_back({left, depth + 1});
      } else {
        return tl::unexpected(
            CurveError{"the curve cannot be resolved at u = " + to_text(piece.u_begin) + ", " +
                       to_text(current.begin_mm())});
      }
    }
    return {};
  }

 private:
  struct Pending {
    BezierSpan span;
    int depth;
  };

  // Within the piece, if it is as short as a point, or against the piece before it.
  bool turns_back(const BezierSpan& span, Wide polygon_mm) {
    const WideVector begin = span.begin_direction(kCoincident * polygon_mm);
    const WideVector end = span.end_direction(kCoincident * polygon_mm);
    const bool inside = polygon_mm <= kPointLike_mm && begin.dot(end) < 0.0L;
    const bool at_begin = last_direction_.dot(begin) < 0.0L;
    last_direction_ = end;
    return inside || at_begin;
  }

  void append(NurbsPiece& piece, double piece_mm) {
    piece.s_begin_mm = static_cast<double>(length_mm);
    length_mm += static_cast<Wide>(piece_mm);
    piece.s_end_mm = static_cast<double>(length_mm);
    if (piece.s_end_mm > piece.s_begin_mm)
      pieces.push_back(piece);
  }

  std::vector<Pending> pending_;
  WideVector last_direction_ = WideVector::Zero();
};

}  // namespace

tl::expected<std::vector<NurbsPiece>, CurveError> map_arc_length(std::span<const BezierSpan> spans,
                                                                 const Position& end_mm) {
  Mapper mapper;
  for (const BezierSpan& span : spans) {
    if (auto added = mapper.add(span); !added)
      return tl::unexpected(added.error());
  }
  if (!(mapper.length_mm > static_cast<Wide>(kShortestCurve_mm))) {
    return tl::unexpected(
        CurveError{"the curve has no length: " + to_text(static_cast<double>(mapper.length_mm)) +
                   " mm at " + to_text(end_mm)});
  }
  mapper.pieces.back().ends_curve = true;
  mapper.pieces.back().end_mm = end_mm;
  mapper.pieces.shrink_to_fit();
  return std::move(mapper.pieces);
}

}  // namespace kerf::curves
