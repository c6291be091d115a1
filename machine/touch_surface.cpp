#include "machine/touch_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::machine {
namespace {

constexpr double kRounding_mm = 1e-6;
constexpr double kNever = std::numeric_limits<double>::infinity();

// A stretch of a way, as shares of its length.
struct ShareInside {
  double begin = kNever;  // never: there is none
  double end = -kNever;
};

double along(const TipWay& way, std::size_t axis) noexcept {
  return way.to_mm[axis] - way.from_mm[axis];
}

Position place_at(const TipWay& way, double share) noexcept {
  Position place;
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    place[axis] = way.from_mm[axis] + share * along(way, axis);
  }
  return place;
}

// Where c0 + c1 t + c2 t^2 >= 0 first within t from `from` to `to`, or where it ends there.
struct Quadratic {
  double c0 = 0.0;
  double c1 = 0.0;
  double c2 = 0.0;

  [[nodiscard]] double at(double t) const noexcept { return c0 + t * (c1 + t * c2); }
  // The roots in ascending order; never where there is none.
  [[nodiscard]] std::array<double, 2> roots() const noexcept {
    if (c2 == 0.0) {
      return {c1 != 0.0 ? -c0 / c1 : kNever, kNever};
    }
    const double disc = c1 * c1 - 4.0 * c2 * c0;
    if (disc < 0.0) {
      return {kNever, kNever};
    }
    const double q = -0.5 * (c1 + std::copysign(std::sqrt(disc), c1));
    const double one = q / c2;
    const double other = q != 0.0 ? c0 / q : one;
    return {std::min(one, other), std::max(one, other)};
  }
};

// ---- The depth of a tip below a surface: above 0 inside, and where it is 0 on a way.

double depth_mm(const TouchBox& box, const Position& tip) noexcept {
  double depth = kNever;
  for (std::size_t axis = 0; axis < tip.size(); ++axis) {
    depth = std::min({depth, tip[axis] - box.min_mm[axis], box.max_mm[axis] - tip[axis]});
  }
  return depth;
}

double depth_mm(const TouchPlane& plane, const Position& tip) noexcept {
  const auto normal = curves::vec(plane.normal);
  return (curves::vec(plane.point_mm) - curves::vec(tip)).dot(normal) / normal.norm();
}

double depth_mm(const TouchSphere& sphere, const Position& tip) noexcept {
  return sphere.radius_mm - (curves::vec(tip) - curves::vec(sphere.centre_mm)).norm();
}

struct GridCell {
  std::array<std::size_t, 2> at{};  // column and row
  std::array<double, 2> inside{};   // 0 to 1
};

std::size_t rows_of(const HeightMap& map) noexcept {
  return map.heights_mm.size() / map.columns;
}

// The cell that holds a point; nothing beside the grid.
std::optional<GridCell> cell_at(const HeightMap& map, double x_mm, double y_mm) noexcept {
  const std::array<double, 2> place{(x_mm - map.origin_mm[0]) / map.spacing_mm[0],
                                    (y_mm - map.origin_mm[1]) / map.spacing_mm[1]};
  const std::array<std::size_t, 2> points{map.columns, rows_of(map)};
  GridCell cell;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (!(place[k] >= 0.0 && place[k] <= static_cast<double>(points[k] - 1))) {
      return std::nullopt;
    }
    cell.at[k] = std::min(static_cast<std::size_t>(place[k]), points[k] - 2);
    cell.inside[k] = place[k] - static_cast<double>(cell.at[k]);
  }
  return cell;
}

// z = h00 + h10 u + h01 v + h11 u v in a cell.
std::array<double, 4> bilinear(const HeightMap& map, const GridCell& cell) noexcept {
  const double* const corner = map.heights_mm.data() + cell.at[1] * map.columns + cell.at[0];
  const double h00 = corner[0];
  const double h10 = corner[1];
  const double h01 = corner[map.columns];
  const double h11 = corner[map.columns + 1];
  return {h00, h10 - h00, h01 - h00, h00 - h10 - h01 + h11};
}

double depth_mm(const HeightMap& map, const Position& tip) noexcept {
  const auto cell = cell_at(map, tip[0], tip[1]);
  if (!cell) {
    return -kNever;
  }
  const auto [u, v] = cell->inside;
  const auto h = bilinear(map, *cell);
  return h[0] + h[1] * u + h[2] * v + h[3] * u * v - tip[2];
}

// ---- The first stretch of a way that lies inside, from a place on; the way goes on beyond its
// end.

ShareInside inside_from(const TouchBox& box, const TipWay& way) noexcept {
  ShareInside in{.begin = -kNever, .end = kNever};
  for (std::size_t axis = 0; axis < way.from_mm.size(); ++axis) {
    const double step = along(way, axis);
    if (step == 0.0) {
      const bool within = way.from_mm[axis] >= box.min_mm[axis] - kRounding_mm &&
                          way.from_mm[axis] <= box.max_mm[axis] + kRounding_mm;
      in.end = within ? in.end : -kNever;
      continue;
    }
    const double to_min = (box.min_mm[axis] - way.from_mm[axis]) / step;
    const double to_max = (box.max_mm[axis] - way.from_mm[axis]) / step;
    in.begin = std::max(in.begin, std::min(to_min, to_max));
    in.end = std::min(in.end, std::max(to_min, to_max));
  }
  return in.begin <= in.end ? in : ShareInside{};
}

ShareInside inside_from(const TouchPlane& plane, const TipWay& way) noexcept {
  const double from = depth_mm(plane, way.from_mm);
  const double step = depth_mm(plane, way.to_mm) - from;
  if (step == 0.0) {
    return from >= -kRounding_mm ? ShareInside{.begin = -kNever, .end = kNever} : ShareInside{};
  }
  const double at = -from / step;
  return step > 0.0 ? ShareInside{.begin = at, .end = kNever}
                    : ShareInside{.begin = -kNever, .end = at};
}

ShareInside inside_from(const TouchSphere& sphere, const TipWay& way) noexcept {
  const Eigen::Vector3d from = curves::vec(way.from_mm) - curves::vec(sphere.centre_mm);
  const Eigen::Vector3d step = curves::vec(way.to_mm) - curves::vec(way.from_mm);
  const Quadratic depth{.c0 = sphere.radius_mm * sphere.radius_mm - from.squaredNorm(),
                        .c1 = -2.0 * from.dot(step),
                        .c2 = -step.squaredNorm()};
  const auto [begin, end] = depth.roots();
  return begin < kNever ? ShareInside{.begin = begin, .end = end} : ShareInside{};
}

// The depth along the way within one cell.
Quadratic depth_along(const HeightMap& map, const GridCell& cell, const TipWay& way) noexcept {
  const auto h = bilinear(map, cell);
  std::array<double, 2> from{};
  std::array<double, 2> step{};
  for (std::size_t k = 0; k < 2; ++k) {
    from[k] =
        (way.from_mm[k] - map.origin_mm[k]) / map.spacing_mm[k] - static_cast<double>(cell.at[k]);
    step[k] = along(way, k) / map.spacing_mm[k];
  }
  return {.c0 = h[0] + h[1] * from[0] + h[2] * from[1] + h[3] * from[0] * from[1] - way.from_mm[2],
          .c1 = h[1] * step[0] + h[2] * step[1] + h[3] * (from[0] * step[1] + from[1] * step[0]) -
                along(way, 2),
          .c2 = h[3] * step[0] * step[1]};
}

// The share of the way at which it next crosses a line of the grid, after `t`.
double next_line(const HeightMap& map, const TipWay& way, double t) noexcept {
  double next = 1.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double step = along(way, k) / map.spacing_mm[k];
    if (step == 0.0) {
      continue;
    }
    const double from = (way.from_mm[k] - map.origin_mm[k]) / map.spacing_mm[k];
    const double at = from + t * step;
    double line = step > 0.0 ? std::floor(at) + 1.0 : std::ceil(at) - 1.0;
    if ((line - from) / step <= t) {  // rounded
      line += step > 0.0 ? 1.0 : -1.0;
    }
    next = std::min(next, (line - from) / step);
  }
  return next;
}

// The share of the way at which it comes over the grid; 0 where it begins there.
double begin_over(const HeightMap& map, const TipWay& way) noexcept {
  TouchBox outline;
  const std::array<std::size_t, 2> points{map.columns, rows_of(map)};
  for (std::size_t k = 0; k < points.size(); ++k) {
    outline.min_mm[k] = map.origin_mm[k];
    outline.max_mm[k] = map.origin_mm[k] + static_cast<double>(points[k] - 1) * map.spacing_mm[k];
  }
  return std::max(inside_from(outline, way).begin, 0.0);
}

// Where the depth changes its sign within a part of the way; never: it does not. After another
// cell it may have done so at the line between them.
double change_within(const ShareInside& part, const Quadratic& depth, double sign) noexcept {
  if (part.begin > 0.0 && sign * depth.at(part.begin) > 0.0) {
    return part.begin;
  }
  for (const double root : depth.roots()) {
    const double slope = depth.c1 + 2.0 * depth.c2 * root;
    if (root >= part.begin && root <= part.end && sign * slope > 0.0) {
      return root;
    }
  }
  return kNever;
}

// From cell to cell. Contact can change at a line of the grid only at its outline.
double change_on(const HeightMap& map, const TipWay& way, bool to_inside) noexcept {
  const std::size_t most = 2 * (map.columns + rows_of(map)) + 4;
  double t = to_inside ? begin_over(map, way) : 0.0;
  for (std::size_t i = 0; i < most && t < 1.0; ++i) {
    const double end = next_line(map, way, t);
    const Position middle = place_at(way, 0.5 * (t + end));
    const auto cell = cell_at(map, middle[0], middle[1]);
    if (!cell) {
      if (!to_inside) {
        return t;
      }
      t = end;
      continue;
    }
    const double found = change_within({.begin = t, .end = end}, depth_along(map, *cell, way),
                                       to_inside ? 1.0 : -1.0);
    if (found < kNever) {
      return found;
    }
    t = end;
  }
  return kNever;
}

// Where contact begins, or ends; never: not on this way.
double change_on(const auto& surface, const TipWay& way, bool to_inside) noexcept {
  const ShareInside in = inside_from(surface, way);
  return to_inside ? in.begin : std::max(in.end, 0.0);
}

std::optional<Position> change(const TouchSurface& surface, const TipWay& way,
                               bool to_inside) noexcept {
  const double share =
      visit(surface, [&](const auto& of) { return change_on(of, way, to_inside); });
  if (!(share >= 0.0 && share <= 1.0)) {
    return std::nullopt;
  }
  Position place = place_at(way, share);
  if (surface.shape == TouchSurface::Shape::box) {
    // On the face exactly, so that the next look at the place finds it there.
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      for (const double face : {surface.box.min_mm[axis], surface.box.max_mm[axis]}) {
        if (std::abs(place[axis] - face) < 1e-9) {
          place[axis] = face;
        }
      }
    }
  }
  return place;
}

}  // namespace

bool touches(const TouchSurface& surface, const Position& tip_mm) noexcept {
  return visit(surface, [&](const auto& of) { return depth_mm(of, tip_mm) >= -kRounding_mm; });
}

std::optional<Position> first_contact(const TouchSurface& surface, const TipWay& way) noexcept {
  return change(surface, way, true);
}

std::optional<Position> end_of_contact(const TouchSurface& surface, const TipWay& way) noexcept {
  return change(surface, way, false);
}

}  // namespace kerf::machine
