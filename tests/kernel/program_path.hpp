// The path that a program asks for, stretch by stretch, from the definitions alone: what ticks are
// held against.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace kerf::test {

using Vec = std::array<double, 3>;

// A smooth part of the path, over a parameter of its own from 0 to 1.
struct Stretch {
  std::function<Vec(double)> at_mm;
  // How far a right path may be from this one: an arc whose printed centre fits its ends only to
  // the last decimal may be drawn in more than one way.
  double freedom_mm = 1e-9;
  std::size_t line = 0;  // of the block that asks for it
};

struct WeightedPoint {
  Vec position_mm{};
  double weight = 1.0;
};

struct ArcWords {
  Vec from_mm{};
  Vec to_mm{};
  Vec centre_offset_mm{};  // I, J, K
  std::size_t normal = 2;  // axis
  bool clockwise = false;  // seen from the end of the normal axis
  bool full_turn = false;
};

// The point of a NURBS at a parameter within its knots, by corner cutting. Degree at most 9.
Vec nurbs_point(const std::vector<WeightedPoint>& points, const std::vector<double>& knots,
                double u);

Stretch line_stretch(const Vec& from_mm, const Vec& to_mm);
// Angle, radius and height grow evenly.
Stretch arc_stretch(const ArcWords& words);
// One for the whole curve, or one a leg for degree 1. Precondition: inner knots differ.
std::vector<Stretch> nurbs_stretches(const std::vector<WeightedPoint>& points,
                                     const std::vector<double>& knots);

}  // namespace kerf::test
