#include "curves/nurbs_data.hpp"

#include <cassert>
#include <cmath>
#include <string>

namespace kerf::curves {
namespace {

using Where = CurveError::Where;

constexpr double kJump_mm = 1e-9;

std::string text(std::size_t count) {
  return std::to_string(count);
}

tl::unexpected<CurveError> whole(std::string message) {
  return tl::unexpected(CurveError{std::move(message), Where::whole, 0});
}

tl::unexpected<CurveError> at(Where where, std::size_t index, std::string message) {
  return tl::unexpected(CurveError{std::move(message), where, index});
}

tl::expected<void, CurveError> check_counts(const NurbsData& data) {
  if (data.degree < 1 || data.degree > kMaxDegree) {
    return whole("the curve's degree is " + std::to_string(data.degree) +
                 ", expected 1 to 9 (order 2 to 10)");
  }
  const std::size_t order = static_cast<std::size_t>(data.degree) + 1;
  if (data.points.size() < order) {
    return whole("the curve has " + text(data.points.size()) +
                 " control points, a curve of degree " + std::to_string(data.degree) +
                 " needs at least " + text(order));
  }
  if (data.knots.size() != data.points.size() + order) {
    return whole("the curve has " + text(data.knots.size()) + " knots, expected " +
                 text(data.points.size() + order) + " for " + text(data.points.size()) +
                 " control points of degree " + std::to_string(data.degree));
  }
  return {};
}

tl::expected<void, CurveError> check_points(const NurbsData& data) {
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const ControlPoint& point = data.points[i];
    if (!is_usable(point.position_mm)) {
      return at(Where::point, i,
                "control point " + text(i + 1) + " at " + to_text(point.position_mm) +
                    " is not finite or beyond 1e9 mm");
    }
    if (!(point.weight > 0.0) || !std::isfinite(point.weight)) {
      return at(Where::point, i,
                "control point " + text(i + 1) + " has weight " + to_text(point.weight) +
                    ", expected a finite number above 0");
    }
  }
  return {};
}

tl::expected<void, CurveError> check_knots(const NurbsData& data) {
  const auto& knots = data.knots;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (!std::isfinite(knots[k])) {
      return at(Where::knot, k, "knot " + text(k + 1) + " is " + to_text(knots[k]));
    }
    if (k > 0 && knots[k] < knots[k - 1]) {
      return at(Where::knot, k,
                "knot " + text(k + 1) + " is " + to_text(knots[k]) +
                    ", less than the one before, " + to_text(knots[k - 1]));
    }
  }
  const std::size_t order = static_cast<std::size_t>(data.degree) + 1;
  const std::size_t last = knots.size() - 1;
  for (std::size_t k = 1; k < order; ++k) {
    if (knots[k] != knots[0]) {
      return at(Where::knot, k,
                "the first knot " + to_text(knots[0]) + " stands " + text(k) + " times, expected " +
                    text(order) + " times for degree " + std::to_string(data.degree));
    }
    if (knots[last - k] != knots[last]) {
      return at(Where::knot, last - k,
                "the last knot " + to_text(knots[last]) + " stands " + text(k) +
                    " times, expected " + text(order) + " times for degree " +
                    std::to_string(data.degree));
    }
  }
  if (knots[0] == knots[last]) {
    return whole("all knots are " + to_text(knots[0]));
  }
  return {};
}

// Knots that stand p + 1 times inside leave two separate curves; more than that, a control point
// without effect.
tl::expected<void, CurveError> check_continuity(const NurbsData& data) {
  const auto& knots = data.knots;
  const std::size_t order = static_cast<std::size_t>(data.degree) + 1;
  for (std::size_t k = 0; k + order < knots.size(); ++k) {
    if (knots[k + order] == knots[k]) {
      return at(Where::knot, k + order,
                "knot " + to_text(knots[k]) + " stands more than " + text(order) +
                    " times, the most for degree " + std::to_string(data.degree));
    }
  }
  for (std::size_t k = 1; k + order < knots.size() - 1; ++k) {
    if (knots[k] != knots[k + order - 1]) {
      continue;
    }
    const Position& before = data.points[k - 1].position_mm;
    const Position& after = data.points[k].position_mm;
    if ((vec(before) - vec(after)).norm() > kJump_mm) {
      return at(Where::knot, k,
                "knot " + to_text(knots[k]) + " stands " + text(order) +
                    " times: the curve jumps from " + to_text(before) + " to " + to_text(after));
    }
  }
  return {};
}

}  // namespace

tl::expected<void, CurveError> check(const NurbsData& data) {
  if (auto ok = check_counts(data); !ok) {
    return ok;
  }
  if (auto ok = check_points(data); !ok) {
    return ok;
  }
  if (auto ok = check_knots(data); !ok) {
    return ok;
  }
  return check_continuity(data);
}

// The blossom of a span at p arguments between its two knots, computed by de Boor's scheme, uses
// weights in [0, 1] only; with i arguments at the end and the others at the begin it is control
// point i [Ramshaw] [Farin, chapter 8].
BezierSpan bezier_span(const NurbsData& data, std::size_t knot) {
  assert(knot + 1 < data.knots.size() && data.knots[knot] < data.knots[knot + 1]);
  const auto wide_knot = [&](std::size_t k) { return static_cast<Wide>(data.knots[k]); };
  const auto p = static_cast<std::size_t>(data.degree);
  BezierSpan span;
  span.degree = data.degree;
  span.u_begin = wide_knot(knot);
  span.u_end = wide_knot(knot + 1);
  span.origin_mm = widen(data.points[knot - p / 2].position_mm);
  std::array<WidePoint, kMaxDegree + 1> control;
  for (std::size_t i = 0; i <= p; ++i) {
    const ControlPoint& point = data.points[knot - p + i];
    const Wide weight = static_cast<Wide>(point.weight);
    control[i] << weight * (widen(point.position_mm) - span.origin_mm), weight;
  }
  for (std::size_t i = 0; i <= p; ++i) {
    auto row = control;
    for (std::size_t level = 1; level <= p; ++level) {
      const Wide u = level <= i ? span.u_end : span.u_begin;
      for (std::size_t j = p; j >= level; --j) {
        const Wide low = wide_knot(knot - p + j);
        const Wide share = (u - low) / (wide_knot(knot + 1 + j - level) - low);
        row[j] = (1.0L - share) * row[j - 1] + share * row[j];
      }
    }
    span.points[i] = row[p];
  }
  return span;
}

std::vector<std::size_t> span_knots(const NurbsData& data) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k + 1 < data.knots.size(); ++k) {
    if (data.knots[k] < data.knots[k + 1]) {
      result.push_back(k);
    }
  }
  return result;
}

}  // namespace kerf::curves
