#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "smoothing/run_segments.hpp"

namespace kerf::smoothing {

namespace {

constexpr std::size_t kMinLines = 8;
constexpr double kFlat_mm = 1e-9;
// Of vertices from the circle: what three decimals in two coordinates and in the circle's own three
// points leave.
constexpr double kRounding_mm = 1.5e-3;
constexpr double kOfTolerance = 0.25;
constexpr double kAllowed = 0.95;
constexpr double kLargest_mm = 1e5;
constexpr double kMinSweep_rad = 0.2;  // of less a spline tells no less

using AxisOrder = std::array<std::size_t, 3>;  // first, second, normal

Eigen::Vector2d in(const AxisOrder& plane, const Vertex& vertex) {
  return {vertex.point_mm[plane[0]], vertex.point_mm[plane[1]]};
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

std::optional<AxisOrder> plane_of(const Polyline& run, std::size_t last) {
  for (const AxisOrder& plane : {AxisOrder{0, 1, 2}, AxisOrder{2, 0, 1}, AxisOrder{1, 2, 0}}) {
    const bool flat = std::all_of(
        run.begin(), run.begin() + static_cast<std::ptrdiff_t>(last) + 1, [&](const Vertex& v) {
          return std::abs(v.point_mm[plane[2]] - run[0].point_mm[plane[2]]) <= kFlat_mm;
        });
    if (flat) {
      return plane;
    }
  }
  return std::nullopt;
}

// Through three points; nothing where they are as good as on a line.
std::optional<Eigen::Vector2d> centre_of(const std::array<Eigen::Vector2d, 3>& points) {
  const auto& [a, b, c] = points;
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d ac = c - a;
  const double twice = 2.0 * cross(ab, ac);
  const Eigen::Vector2d from_a =
      Eigen::Vector2d(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                      ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) /
      twice;
  if (!(from_a.norm() <= kLargest_mm)) {
    return std::nullopt;
  }
  return a + from_a;
}

// Of the chord between two points, seen from the origin: its nearest point, which is not its middle
// where one end is farther.
double nearest_of_chord_mm(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d chord = to - from;
  const double share = std::clamp(-from.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
  return (from + share * chord).norm();
}

}  // namespace

std::optional<CircleRun> circle_of(const Polyline& run, std::size_t last, double tolerance_mm) {
  assert(last < run.size());
  const auto plane = last >= kMinLines ? plane_of(run, last) : std::nullopt;
  if (!plane) {
    return std::nullopt;
  }
  const bool closed = run[0].point_mm == run[last].point_mm;
  const auto centre = centre_of({in(*plane, run[0]), in(*plane, run[closed ? last / 3 : last / 2]),
                                 in(*plane, run[closed ? 2 * last / 3 : last])});
  if (!centre) {
    return std::nullopt;
  }
  const double radius = (in(*plane, run[0]) - *centre).norm();
  const double sense =
      cross(in(*plane, run[0]) - *centre, in(*plane, run[1]) - *centre) < 0 ? -1 : 1;
  std::vector<double> angles_rad{0.0};
  double deviation = 0.0;
  for (std::size_t i = 1; i <= last; ++i) {
    const Eigen::Vector2d before = in(*plane, run[i - 1]) - *centre;
    const Eigen::Vector2d here = in(*plane, run[i]) - *centre;
    const double step = sense * std::atan2(cross(before, here), before.dot(here));
    const double off = std::abs(here.norm() - radius);
    const double height = std::abs(nearest_of_chord_mm(before, here) - radius);
    deviation = std::max({deviation, off, height});
    if (!(step > 0.0 && off <= std::min(kRounding_mm, kOfTolerance * tolerance_mm) &&
          height <= kAllowed * tolerance_mm)) {
      return std::nullopt;
    }
    angles_rad.push_back(angles_rad.back() + step);
  }
  const double sweep = angles_rad.back();
  if (sweep < kMinSweep_rad || sweep > 2.0 * std::numbers::pi + (closed ? 1e-6 : -1e-6)) {
    return std::nullopt;
  }
  curves::ArcShape shape{.start_mm = run[0].point_mm,
                         .end_mm = run[last].point_mm,
                         .centre_mm = run[0].point_mm,
                         .normal_axis = static_cast<int>((*plane)[2]),
                         .clockwise = sense < 0.0};
  shape.centre_mm[(*plane)[0]] = centre->x();
  shape.centre_mm[(*plane)[1]] = centre->y();
  const auto arc = curves::Arc::make(shape);
  if (!arc) {
    return std::nullopt;
  }
  CircleRun circle{.arc = *arc, .s_mm = {}, .deviation_mm = deviation};
  for (std::size_t i = 0; i < last; ++i) {
    circle.s_mm.push_back(angles_rad[i] / sweep * arc->length_mm());
  }
  return circle;
}

}  // namespace kerf::smoothing
