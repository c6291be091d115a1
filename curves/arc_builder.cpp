#include <cmath>
#include <numbers>
#include <vector>

#include "curves/bezier_span.hpp"
#include "curves/curve_builders.hpp"

namespace kerf::curves {
namespace {

constexpr double kAgree_mm = 1e-11;
constexpr double kMaxTurns = 1000.0;
constexpr Wide kChunk_rad = 0.2L;  // the Taylor series of degree 9 leaves 0.1^10 / 10! = 3e-17

// Cosine and sine of (middle + half x) times a radius that is linear in x, as powers of x.
struct SpiralSeries {
  std::array<Wide, kMaxDegree + 1> out{};
  std::array<Wide, kMaxDegree + 1> forward{};
};

struct Chunk {
  Wide middle_rad;
  Wide half_rad;
  Wide middle_radius_mm;
  Wide half_growth_mm;  // of the radius, from the middle to the end
};

SpiralSeries series_of(const Chunk& chunk) {
  SpiralSeries unit;
  Wide term = 1.0L;
  for (std::size_t k = 0; k <= kMaxDegree; ++k) {
    const Wide quarter_turns = std::numbers::pi_v<Wide> / 2.0L * static_cast<Wide>(k);
    unit.out[k] = term * std::cos(chunk.middle_rad + quarter_turns);
    unit.forward[k] = term * std::sin(chunk.middle_rad + quarter_turns);
    term *= chunk.half_rad / static_cast<Wide>(k + 1);
  }
  SpiralSeries result;
  for (std::size_t k = 0; k <= kMaxDegree; ++k) {
    result.out[k] = chunk.middle_radius_mm * unit.out[k];
    result.forward[k] = chunk.middle_radius_mm * unit.forward[k];
    if (k == 0) {
      continue;
    }
    result.out[k] += chunk.half_growth_mm * unit.out[k - 1];
    result.forward[k] += chunk.half_growth_mm * unit.forward[k - 1];
  }
  return result;
}

tl::expected<NurbsCurve, CurveError> spiral(const ArcShape& shape, const ArcSweep& sweep) {
  if (sweep.angle_rad > kMaxTurns * 2.0 * std::numbers::pi) {
    return tl::unexpected(
        CurveError{"the arc's radius changes from " + to_text(sweep.start_radius_mm) + " to " +
                   to_text(sweep.end_radius_mm) + " mm over " + std::to_string(shape.turns) +
                   " turns, expected 1000 at most"});
  }
  const auto first = static_cast<Eigen::Index>((shape.normal_axis + 1) % 3);
  const auto second = static_cast<Eigen::Index>((shape.normal_axis + 2) % 3);
  const auto normal = static_cast<Eigen::Index>(shape.normal_axis);
  const Eigen::Matrix<Wide, 2, 1> out = sweep.from_centre_mm.cast<Wide>().normalized();
  const Wide sense = shape.clockwise ? -1.0L : 1.0L;
  const Eigen::Matrix<Wide, 2, 1> forward(-sense * out.y(), sense * out.x());
  const Wide sweep_rad = static_cast<Wide>(sweep.angle_rad);
  const Wide start_radius_mm = static_cast<Wide>(sweep.start_radius_mm);
  const Wide growth_mm = static_cast<Wide>(sweep.end_radius_mm) - start_radius_mm;
  const auto chunks = static_cast<std::size_t>(std::ceil(sweep_rad / kChunk_rad));

  std::vector<BezierSpan> spans(chunks);
  for (std::size_t i = 0; i < chunks; ++i) {
    const Wide half = 0.5L / static_cast<Wide>(chunks);  // shares of the whole sweep
    const Wide middle = (2.0L * static_cast<Wide>(i) + 1.0L) * half;
    const SpiralSeries series = series_of({.middle_rad = middle * sweep_rad,
                                           .half_rad = half * sweep_rad,
                                           .middle_radius_mm = start_radius_mm + middle * growth_mm,
                                           .half_growth_mm = half * growth_mm});
    std::array<WidePoint, kMaxDegree + 1> power{};
    for (std::size_t k = 0; k <= kMaxDegree; ++k) {
      power[k].setZero();
      power[k][first] = series.out[k] * out.x() + series.forward[k] * forward.x();
      power[k][second] = series.out[k] * out.y() + series.forward[k] * forward.y();
    }
    power[0][normal] = middle * static_cast<Wide>(sweep.rise_mm);
    power[1][normal] = half * static_cast<Wide>(sweep.rise_mm);
    power[0].w() = 1.0L;
    spans[i] = from_powers(power, kMaxDegree);
    spans[i].u_begin = (middle - half) * sweep_rad;
    spans[i].u_end = (middle + half) * sweep_rad;
    spans[i].origin_mm = widen(shape.start_mm);
    spans[i].origin_mm[first] -= static_cast<Wide>(sweep.from_centre_mm.x());
    spans[i].origin_mm[second] -= static_cast<Wide>(sweep.from_centre_mm.y());
  }
  auto curves = NurbsCurve::from_spans(spans, shape.end_mm);
  if (!curves) {
    return tl::unexpected(curves.error());
  }
  if (curves->size() != 1) {
    return tl::unexpected(CurveError{"the arc from " + to_text(shape.start_mm) + " to " +
                                     to_text(shape.end_mm) + " is too small to be drawn"});
  }
  return std::move(curves->front());
}

}  // namespace

tl::expected<std::variant<Arc, NurbsCurve>, CurveError> make_arc(const ArcShape& shape) {
  using Result = std::variant<Arc, NurbsCurve>;
  const auto to_result = [](auto made) { return Result(std::move(made)); };
  const auto sweep = sweep_of(shape);
  if (!sweep) {
    return tl::unexpected(sweep.error());
  }
  const double differ_mm = std::abs(sweep->start_radius_mm - sweep->end_radius_mm);
  if (differ_mm <= kAgree_mm) {
    return Arc::make(shape).map(to_result);
  }

  const double chord_mm = sweep->chord_mm.norm();
  if (chord_mm > 0.0) {
    const Eigen::Vector2d along = sweep->chord_mm / chord_mm;
    const double off_mm = along.dot(sweep->from_centre_mm) + 0.5 * chord_mm;
    const bool close = std::abs(off_mm) <= differ_mm || sweep->angle_rad <= std::numbers::pi;
    if (close && std::abs(off_mm) < 0.25 * sweep->start_radius_mm) {
      ArcShape moved = shape;
      moved.centre_mm[static_cast<std::size_t>((shape.normal_axis + 1) % 3)] += off_mm * along.x();
      moved.centre_mm[static_cast<std::size_t>((shape.normal_axis + 2) % 3)] += off_mm * along.y();
      return Arc::make(moved).map(to_result);
    }
  }
  return spiral(shape, *sweep).map(to_result);
}

}  // namespace kerf::curves
