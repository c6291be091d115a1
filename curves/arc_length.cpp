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
// 20 to 40 pieces. What the curve does across such a point shows in the tangents on both sides:
// it goes on, turns back (a cusp) or turns a corner; corners also come of large weights, which pull
// a curve onto its control polygon to within 1e-12 mm.
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
constexpr double kShortestCurve_mm = 1e-11;
constexpr Wide kTurnsBack = -0.999L;    // cosine of the angle between the tangents
constexpr Wide kTurnsCorner = 0.9988L;  // 0.05 rad, more than any smooth curve turns in 1e-12 mm
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

// Maps one span after the other, left to right.
class Mapper {
 public:
  std::vector<std::vector<NurbsPiece>> curves{1};
  Wide length_mm = 0.0L;  // of the last one so far

  tl::expected<void, CurveError> add(const BezierSpan& span) {
    pending_.assign(1, {span, 0});
    while (!pending_.empty()) {
      const auto [current, depth] = pending_.back();
      pending_.pop_back();
      const auto [left, right] = halve(current);
      const Wide polygon_mm = current.polygon_length_mm();
      NurbsPiece piece = geometry_of(current, right);
      if (polygon_mm <= kPointLike_mm) {
        piece.local_by_length = {0.0, 1.0};
        points_.push_back({piece, static_cast<double>(polygon_mm)});
        continue;
      }
      const double piece_mm = current.weight_ratio() <= kMostWeightRatio ? fit(piece) : -1.0;
      if (piece_mm >= 0.0) {
        if (auto passed = pass_points(current, polygon_mm); !passed)
          return passed;
        append(piece, piece_mm);
      } else if (depth < kDepth) {
        pending_.push_back({right, depth + 1});
        pending_.push_back({left, depth + 1});
      } else {
        return tl::unexpected(error_at("the curve cannot be resolved", current));
      }
    }
    return {};
  }

  // Takes what is still held back, and ends the last curve.
  void finish(const Position& end_mm) {
    for (auto& [piece, piece_mm] : points_)
      append(piece, piece_mm);
    end_curve(end_mm);
    std::erase_if(curves, [](const auto& pieces) {
      return pieces.empty() || !(pieces.back().s_end_mm > kShortestCurve_mm);
    });
  }

 private:
  struct Pending {
    BezierSpan span;
    int depth;
  };
  struct Point {
    NurbsPiece piece;
    double length_mm;
  };

  static CurveError error_at(const std::string& what, const BezierSpan& span) {
    return {what + " at u = " + to_text(static_cast<double>(span.u_begin)) + ", " +
            to_text(span.begin_mm())};
  }

  // Compares the tangents before and after the pieces without extent that were held back, keeps
  // them where the curve goes on smoothly and drops them for a corner.
  tl::expected<void, CurveError> pass_points(const BezierSpan& next, Wide polygon_mm) {
    const WideVector direction = next.begin_direction(kCoincident * polygon_mm);
    const bool inside = !curves.back().empty() && last_direction_.squaredNorm() > 0.0L;
    const Wide cosine = inside ? last_direction_.dot(direction) : 1.0L;
    last_direction_ = next.end_direction(kCoincident * polygon_mm);
    if (cosine < kTurnsBack) {
      return tl::unexpected(error_at("the curve turns back on itself in a cusp", next));
    }
    if (cosine < kTurnsCorner) {
      end_curve(next.begin_mm());
      curves.emplace_back();
      length_mm = 0.0L;
    } else {
      for (auto& [piece, piece_mm] : points_)
        append(piece, piece_mm);
    }
    points_.clear();
    return {};
  }

  void append(NurbsPiece& piece, double piece_mm) {
    piece.s_begin_mm = static_cast<double>(length_mm);
    length_mm += static_cast<Wide>(piece_mm);
    piece.s_end_mm = static_cast<double>(length_mm);
    if (piece.s_end_mm > piece.s_begin_mm)
      curves.back().push_back(piece);
  }

  void end_curve(const Position& end_mm) {
    if (curves.back().empty())
      return;
    curves.back().back().ends_curve = true;
    curves.back().back().end_mm = end_mm;
    curves.back().shrink_to_fit();
  }

  std::vector<Pending> pending_;
  std::vector<Point> points_;  // pieces without extent since the last one with any
  WideVector last_direction_ = WideVector::Zero();
};

}  // namespace

tl::expected<std::vector<std::vector<NurbsPiece>>, CurveError> map_arc_length(
    std::span<const BezierSpan> spans, const Position& end_mm) {
  Mapper mapper;
  for (const BezierSpan& span : spans) {
    if (auto added = mapper.add(span); !added)
      return tl::unexpected(added.error());
  }
  mapper.finish(end_mm);
  return std::move(mapper.curves);
}

}  // namespace kerf::curves
