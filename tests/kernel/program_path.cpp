#include "tests/kernel/program_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::test {

namespace {

constexpr double kArcFreedom_mm = 5e-7;

using Homogeneous = std::array<double, 4>;

}  // namespace

// De Boor's.
Vec nurbs_point(const std::vector<WeightedPoint>& points, const std::vector<double>& knots,
                double u) {
  const std::size_t degree = knots.size() - points.size() - 1;
  const auto above =
      std::upper_bound(knots.begin() + static_cast<std::ptrdiff_t>(degree),
                       knots.begin() + static_cast<std::ptrdiff_t>(points.size()), u);
  const auto k = static_cast<std::size_t>(above - knots.begin()) - 1;
  std::array<Homogeneous, 10> d{};
  for (std::size_t j = 0; j <= degree; ++j) {
    const WeightedPoint& point = points[k - degree + j];
    for (std::size_t i = 0; i < 3; ++i) {
      d[j][i] = point.weight * point.position_mm[i];
    }
    d[j][3] = point.weight;
  }
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t j = degree; j >= r; --j) {
      const double low = knots[k - degree + j];
      const double share = (u - low) / (knots[k + 1 + j - r] - low);
      for (std::size_t i = 0; i < 4; ++i) {
        d[j][i] = (1.0 - share) * d[j - 1][i] + share * d[j][i];
      }
    }
  }
  const Homogeneous& p = d[degree];
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

Stretch line_stretch(const Vec& from_mm, const Vec& to_mm) {
  return {.at_mm = [from_mm, to_mm](double u) {
    Vec point{};
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] = from_mm[k] + u * (to_mm[k] - from_mm[k]);
    }
    return point;
  }};
}

Stretch arc_stretch(const ArcWords& words) {
  const std::size_t normal = words.normal;
  const std::size_t first = (normal + 1) % 3;
  const std::size_t second = (normal + 2) % 3;
  const Vec& from = words.from_mm;
  const Vec& to = words.to_mm;
  const std::array<double, 2> centre{from[first] + words.centre_offset_mm[first],
                                     from[second] + words.centre_offset_mm[second]};
  const std::array<double, 2> out{from[first] - centre[0], from[second] - centre[1]};
  const std::array<double, 2> in{to[first] - centre[0], to[second] - centre[1]};
  const double begin = std::atan2(out[1], out[0]);
  const double sense = words.clockwise ? -1.0 : 1.0;
  double sweep = sense * (std::atan2(in[1], in[0]) - begin);
  if (words.full_turn) {
    sweep = 2.0 * std::numbers::pi;
  } else if (sweep < 0.0) {
    sweep += 2.0 * std::numbers::pi;
  }
  const double radius = std::hypot(out[0], out[1]);
  const double growth = std::hypot(in[0], in[1]) - radius;
  const double rise = to[normal] - from[normal];
  const auto at_mm = [=, height = from[normal]](double u) {
    const double angle = begin + sense * u * sweep;
    const double r = radius + u * growth;
    Vec point{};
    point[first] = centre[0] + r * std::cos(angle);
    point[second] = centre[1] + r * std::sin(angle);
    point[normal] = height + u * rise;
    return point;
  };
  return {.at_mm = at_mm, .freedom_mm = kArcFreedom_mm};
}

std::vector<Stretch> nurbs_stretches(const std::vector<WeightedPoint>& points,
                                     const std::vector<double>& knots) {
  std::vector<double> ends{knots.front(), knots.back()};
  if (knots.size() == points.size() + 2) {
    ends.assign(knots.begin() + 1, knots.end() - 1);
  }
  std::vector<Stretch> stretches;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double low = ends[i - 1];
    const double width = ends[i] - low;
    // The end of a leg belongs to the next one, whose corner is the same point.
    stretches.push_back({.at_mm = [points, knots, low, width](double u) {
      return nurbs_point(points, knots, low + u * width);
    }});
  }
  return stretches;
}

}  // namespace kerf::test
