// The box of a NURBS curve. Every piece lies in the convex hull of its Bezier control points; a
// hull that stays inside the box found so far is done, any other is halved and its middle point
// joins the box. Hulls shrink onto the curve quadratically, so only the few that hold an extreme go
// deep.
#include <algorithm>
#include <vector>

#include "curves/bezier_span.hpp"
#include "curves/nurbs_curve.hpp"

namespace kerf::curves {
namespace {

constexpr double kSlack_mm = 2.5e-10;
constexpr int kDepth = 40;

void include(Extents& box, const Position& p_mm) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.min_mm[k] = std::min(box.min_mm[k], p_mm[k]);
    box.max_mm[k] = std::max(box.max_mm[k], p_mm[k]);
  }
}

BezierSpan bezier_of(const NurbsPiece& piece) {
  std::array<WidePoint, kMaxDegree + 1> power{};
  for (std::size_t k = 0; k <= static_cast<std::size_t>(piece.degree); ++k) {
    power[k] = Eigen::Map<const Eigen::Vector4d>(piece.coefficients[k].data()).cast<Wide>();
  }
  BezierSpan span = from_powers(power, piece.degree);
  span.origin_mm = widen(piece.origin_mm);
  return span;
}

bool inside(const BezierSpan& span, const Extents& box) {
  for (std::size_t i = 0; i < span.count(); ++i) {
    const Position p_mm = narrow(span.origin_mm + span.seen(i));
    for (std::size_t k = 0; k < 3; ++k) {
      if (p_mm[k] < box.min_mm[k] - kSlack_mm || p_mm[k] > box.max_mm[k] + kSlack_mm) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

Extents NurbsCurve::extents() const {
  Extents box{.min_mm = pieces_.back().end_mm, .max_mm = pieces_.back().end_mm};
  for (const NurbsPiece& piece : pieces_) {
    include(box, piece.at(piece.s_begin_mm));
  }
  struct Pending {
    BezierSpan span;
    int depth;
  };
  std::vector<Pending> pending;
  for (const NurbsPiece& piece : pieces_) {
    pending.push_back({bezier_of(piece), 0});
    while (!pending.empty()) {
      const auto [span, depth] = pending.back();
      pending.pop_back();
      if (depth >= kDepth || inside(span, box)) {
        continue;
      }
      const auto [left, right] = halve(span);
      include(box, right.begin_mm());
      pending.push_back({left, depth + 1});
      pending.push_back({right, depth + 1});
    }
  }
  return box;
}

}  // namespace kerf::curves
