// Idea. An interval of u is halved until x(s) can be fitted to it (piece_fit.cpp). Convergence is
// geometric, so a curve without singularities takes few pieces, and each factor of 10 in accuracy a
// quarter more of them.
//
// Where |C'(u)| tends to zero x(s) is singular (like a root of s). Halving then closes in on the
// point geometrically until the piece is shorter than the tolerance, where any x(s) will do: about
// 20 to 40 pieces. What the curve does across such a point shows in the tangents on both sides:
// it goes on, turns back (a cusp) or turns a corner; corners also come of large weights, which pull
// a curve onto its control polygon to within 1e-12 mm. At a cusp as at a corner the curve is cut.
//
// Weakness: a near-cusp sharper than 1e-12 mm is taken for a cusp, and curves whose coordinates
// differ by less than 1e-12 mm are taken for points.
#include "curves/arc_length.hpp"

#include <algorithm>
#include <cmath>

#include "curves/piece_fit.hpp"

namespace kerf::curves {
namespace {

constexpr Wide kPointLike_mm = 1e-12L;
// Control points closer than this share of a piece's size coincide: the first one beyond shows the
// tangent. Generous, because rounding moves points that should coincide, and only turning back is
// looked for.
constexpr Wide kCoincident = 1e-6L;
constexpr Wide kMaxWeightRatio = 16.0L;  // in one piece, so that its polynomials lose no digits
constexpr double kShortestCurve_mm = 1e-11;
// A cusp within a piece so short passes for rounding of its fit. It must come to lie between
// pieces.
constexpr Wide kHidesCusp_mm = 1e-10L;
// Cosine of the angle between the tangents: 0.05 rad, more than any smooth curve turns in 1e-12 mm.
constexpr Wide kTurnsCorner = 0.9988L;
constexpr int kDepth = 90;

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
      NurbsPiece piece = unmapped_piece(right, current.u_begin);
      if (polygon_mm <= kPointLike_mm) {
        piece.local_by_length = {0.0, 1.0};
        points_.push_back({piece, static_cast<double>(polygon_mm)});
        continue;
      }
      const bool is_fit =
          current.weight_ratio() <= kMaxWeightRatio && !hides_cusp(current, polygon_mm);
      const double piece_mm = is_fit ? fit_length_map(piece) : -1.0;
      if (piece_mm >= 0.0) {
        pass_points(current, polygon_mm);
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
    for (auto& [piece, piece_mm] : points_) {
      append(piece, piece_mm);
    }
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

  static bool hides_cusp(const BezierSpan& span, Wide polygon_mm) {
    const Wide coincident_mm = kCoincident * polygon_mm;
    return polygon_mm <= kHidesCusp_mm &&
           span.begin_direction(coincident_mm).dot(span.end_direction(coincident_mm)) < 0.0L;
  }

  // Compares the tangents before and after the pieces without extent that were held back, keeps
  // them where the curve goes on smoothly and drops them for a corner.
  void pass_points(const BezierSpan& next, Wide polygon_mm) {
    const WideVector direction = next.begin_direction(kCoincident * polygon_mm);
    const bool inside = !curves.back().empty() && last_direction_.squaredNorm() > 0.0L;
    const Wide cosine = inside ? last_direction_.dot(direction) : 1.0L;
    last_direction_ = next.end_direction(kCoincident * polygon_mm);
    if (cosine < kTurnsCorner) {
      end_curve(next.begin_mm());
      curves.emplace_back();
      length_mm = 0.0L;
    } else {
      for (auto& [piece, piece_mm] : points_) {
        append(piece, piece_mm);
      }
    }
    points_.clear();
  }

  void append(NurbsPiece& piece, double piece_mm) {
    piece.s_begin_mm = static_cast<double>(length_mm);
    length_mm += static_cast<Wide>(piece_mm);
    piece.s_end_mm = static_cast<double>(length_mm);
    if (piece.s_end_mm > piece.s_begin_mm) {
      curves.back().push_back(piece);
    }
  }

  void end_curve(const Position& end_mm) {
    if (curves.back().empty()) {
      return;
    }
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
    if (auto added = mapper.add(span); !added) {
      return tl::unexpected(added.error());
    }
  }
  mapper.finish(end_mm);
  return std::move(mapper.curves);
}

}  // namespace kerf::curves
