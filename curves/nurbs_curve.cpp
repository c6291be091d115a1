#include "curves/nurbs_curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "curves/arc_length.hpp"
#include "curves/nurbs_data.hpp"

namespace kerf::curves {
namespace {

constexpr Wide kCorner_rad = 1e-9L;
constexpr Wide kNoise = 1e-14L;     // of a span's size: control points this close coincide
constexpr Wide kPoint_mm = 1e-15L;  // a span this small is a point to rounding

// A part of the curve without corners.
struct SmoothRun {
  std::vector<BezierSpan> spans;
  Position end_mm{};
};

bool is_corner(const BezierSpan& before, const BezierSpan& after) {
  const WideVector in = before.end_direction(kNoise * before.polygon_length_mm());
  const WideVector out = after.begin_direction(kNoise * after.polygon_length_mm());
  return (in - out).norm() > kCorner_rad;
}

bool stands_still(const BezierSpan& before, const BezierSpan& after) {
  const std::size_t last = before.count() - 1;
  return (before.seen(last) - before.seen(last - 1)).norm() <=
             kNoise * before.polygon_length_mm() ||
         (after.seen(1) - after.seen(0)).norm() <= kNoise * after.polygon_length_mm();
}

// The tangent can turn at a knot of multiplicity p, or where the derivative vanishes there; at any
// other knot it is continuous, and comparing would only see rounding.
std::vector<SmoothRun> cut_at_corners(const NurbsData& data) {
  const auto p = static_cast<std::size_t>(data.degree);
  std::vector<SmoothRun> runs(1);
  for (const std::size_t k : span_knots(data)) {
    const BezierSpan span = bezier_span(data, k);
    if (span.polygon_length_mm() <= kPoint_mm) {
      continue;
    }
    if (!runs.back().spans.empty()) {
      const BezierSpan& before = runs.back().spans.back();
      const bool repeated = data.knots[k + 1 - p] == data.knots[k];
      const bool gap = before.u_end != span.u_begin;
      if ((repeated || gap || stands_still(before, span)) && is_corner(before, span)) {
        runs.back().end_mm = repeated ? data.points[k - p].position_mm : before.end_mm();
        runs.emplace_back();
      }
    }
    runs.back().spans.push_back(span);
  }
  runs.back().end_mm = data.points.back().position_mm;
  return runs;
}

}  // namespace

tl::expected<std::vector<NurbsCurve>, CurveError> NurbsCurve::from_spans(
    std::span<const BezierSpan> spans, const Position& end_mm) {
  auto mapped = map_arc_length(spans, end_mm);
  if (!mapped) {
    return tl::unexpected(mapped.error());
  }
  std::vector<NurbsCurve> curves;
  for (auto& pieces : *mapped) {
    curves.push_back(NurbsCurve(std::move(pieces)));
  }
  return curves;
}

tl::expected<std::vector<NurbsCurve>, CurveError> NurbsCurve::make(const NurbsData& data) {
  if (auto valid = check(data); !valid) {
    return tl::unexpected(valid.error());
  }
  std::vector<NurbsCurve> curves;
  for (const SmoothRun& run : cut_at_corners(data)) {
    auto parts = from_spans(run.spans, run.end_mm);
    if (!parts) {
      return tl::unexpected(parts.error());
    }
    std::move(parts->begin(), parts->end(), std::back_inserter(curves));
  }
  if (curves.empty()) {
    return tl::unexpected(CurveError{"the curve has no length: all of it lies at " +
                                     to_text(data.points.front().position_mm)});
  }
  return curves;
}

std::size_t NurbsCurve::piece_index(double s_mm) const noexcept {
  const auto found =
      std::partition_point(pieces_.begin(), pieces_.end() - 1,
                           [&](const NurbsPiece& piece) { return piece.s_end_mm <= s_mm; });
  return static_cast<std::size_t>(found - pieces_.begin());
}

double NurbsCurve::s_at(double u) const noexcept {
  const auto found =
      std::partition_point(pieces_.begin(), pieces_.end() - 1,
                           [&](const NurbsPiece& piece) { return piece.u_end <= u; });
  const double width = found->u_end - found->u_begin;
  const double x = width > 0.0 ? 2.0 * (u - found->u_begin) / width - 1.0 : 1.0;
  return length_at(*found, x > 1.0 ? 1.0 : (x > -1.0 ? x : -1.0));
}

Position NurbsCurve::at(double s_mm) const noexcept {
  return pieces_[piece_index(s_mm)].at(s_mm);
}

PathDerivatives NurbsCurve::derivatives_at(double s_mm) const noexcept {
  return pieces_[piece_index(s_mm)].derivatives_at(s_mm);
}

}  // namespace kerf::curves
