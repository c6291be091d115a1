// A non-uniform rational B-spline, smooth (tangent-continuous) from end to end.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "curves/curve_error.hpp"
#include "curves/nurbs_piece.hpp"
#include "curves/position.hpp"

namespace kerf::curves {

struct BezierSpan;  // bezier_span.hpp

struct ControlPoint {
  Position position_mm{};
  double weight = 1.0;  // > 0
};

// Degree p (order p + 1), n control points, n + p + 1 knots.
struct NurbsData {
  int degree = 3;
  std::vector<ControlPoint> points;
  std::vector<double> knots;
};

class NurbsCurve {
 public:
  // Cuts the curve at its corners and returns the smooth parts in order, normally one. Corners are
  // where the tangent turns by more than 1e-9 rad at a knot (of multiplicity degree, or where
  // control points coincide), or by more than 0.05 rad within 1e-12 mm (extreme weights; a cusp,
  // where the curve turns back between two knots). Errors:
  // degree outside 1..9, fewer points than the order, count of knots not n + p + 1, decreasing or
  // not finite knots, end knots not repeated p + 1 times, a jump in position, weight not positive
  // or not finite, a coordinate not finite or beyond kMaxCoordinate_mm, zero length (up to 1e-11
  // mm).
  static tl::expected<std::vector<NurbsCurve>, CurveError> make(const NurbsData& data);
  // The same from Bezier spans, each beginning where and in the direction in which the one before
  // ends; end_mm is their end as the program wrote it. Empty if they have no length.
  static tl::expected<std::vector<NurbsCurve>, CurveError> from_spans(
      std::span<const BezierSpan> spans, const Position& end_mm);

  // Of pieces in order, of which each begins where and in the direction in which the one before
  // ends, both in s and in place, and the last ends the curve. Precondition: there is one.
  static NurbsCurve from_pieces(std::vector<NurbsPiece> pieces) {
    return NurbsCurve(std::move(pieces));
  }

  // From begin_mm to end_mm along it, on the same points to rounding. Nothing: their distance is 0
  // in double. Precondition: 0 <= begin < end <= length.
  [[nodiscard]] std::optional<NurbsCurve> part(const Stretch& stretch) const;

  [[nodiscard]] double length_mm() const noexcept { return pieces_.back().s_end_mm; }
  [[nodiscard]] const std::vector<NurbsPiece>& pieces() const noexcept { return pieces_; }
  // Index of the piece that holds s_mm (clamped): binary search.
  [[nodiscard]] std::size_t piece_index(double s_mm) const noexcept;
  // Where the parameter is u (clamped): the arc length at which x(s) says so.
  [[nodiscard]] double s_at(double u) const noexcept;
  [[nodiscard]] Position at(double s_mm) const noexcept;
  [[nodiscard]] PathDerivatives derivatives_at(double s_mm) const noexcept;
  // Touched by the curve, and passed by it by less than 1e-9 mm.
  [[nodiscard]] Extents extents() const;

 private:
  explicit NurbsCurve(std::vector<NurbsPiece> pieces) : pieces_(std::move(pieces)) {}
  std::vector<NurbsPiece> pieces_;  // not empty
};

}  // namespace kerf::curves
