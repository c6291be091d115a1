// What is engraved, pocketed and looped.
#include <cmath>
#include <string_view>
#include <vector>

#include "bench/part_programs.hpp"

namespace kerf::bench {

namespace {

constexpr double kDegree = kFullTurn_rad / 360.0;

using Spot = std::array<double, 2>;
using Stroke = std::vector<Spot>;

// Of an ellipse.
struct Bow {
  Spot centre{};
  Spot radii{};
  Spot from_to_deg{};
};

// Flattened into steps of 0.1 mm or so of a letter 6 mm high.
void add_bow(Stroke& stroke, const Bow& bow) {
  const double sweep = (bow.from_to_deg[1] - bow.from_to_deg[0]) * kDegree;
  const int steps = static_cast<int>(std::ceil(std::abs(sweep) * bow.radii[0] / 0.1));
  for (int i = 0; i <= steps; ++i) {
    const double angle = bow.from_to_deg[0] * kDegree + sweep * i / steps;
    stroke.push_back({bow.centre[0] + bow.radii[0] * std::cos(angle),
                      bow.centre[1] + bow.radii[1] * std::sin(angle)});
  }
}

Stroke ring(const Spot& centre, const Spot& radii) {
  Stroke stroke;
  add_bow(stroke, {centre, radii, {90.0, 450.0}});
  return stroke;
}

// On a field 4 mm wide and 6 mm high.
std::vector<Stroke> letter(char name) {
  const Stroke stem{{0, 0}, {0, 6}};
  switch (name) {
    case 'E':
      return {{{4, 6}, {0, 6}, {0, 0}, {4, 0}}, {{0, 3}, {3, 3}}};
    case 'F':
      return {{{4, 6}, {0, 6}, {0, 0}}, {{0, 3}, {3, 3}}};
    case 'K':
      return {stem, {{4, 6}, {0, 3}, {4, 0}}};
    case 'R': {
      Stroke bow{{0, 0}, {0, 6}};
      add_bow(bow, {{2.5, 4.5}, {1.5, 1.5}, {90.0, -90.0}});
      bow.push_back({0, 3});
      return {bow, {{2, 3}, {4, 0}}};
    }
    case 'S': {
      Stroke bows;
      add_bow(bows, {{2, 4.5}, {2, 1.5}, {30.0, 270.0}});
      add_bow(bows, {{2, 1.5}, {2, 1.5}, {90.0, -150.0}});
      return {bows};
    }
    case '8':
      return {ring({2, 4.6}, {1.6, 1.4}), ring({2, 1.6}, {2, 1.6})};
    default:
      return {ring({2, 3}, {2, 3})};
  }
}

}  // namespace

PartProgram engraving() {
  constexpr double kAbove_mm = 1.0;
  constexpr double kDepth_mm = -0.2;
  PartWriter writer({0.0, 0.0, kAbove_mm}, 3);
  double y = 0.0;
  for (const std::string_view text : {"KERFO8SER", "ROSE8FORK", "SOKEFER8O"}) {
    double x = 0.0;
    for (const char name : text) {
      for (const Stroke& stroke : letter(name)) {
        const auto at = [&](const Spot& spot, double z) {
          return Point{x + spot[0], y + spot[1], z};
        };
        writer.line_to(at(stroke.front(), kAbove_mm), true);
        writer.line_to(at(stroke.front(), kDepth_mm));
        for (std::size_t i = 1; i < stroke.size(); ++i) {
          writer.line_to(at(stroke[i], kDepth_mm));
        }
        writer.line_to(at(stroke.back(), kAbove_mm), true);
      }
      x += 5.5;
    }
    y -= 8.0;
  }
  return writer.finish();
}

PartProgram pocket() {
  constexpr double kRadius_mm = 3.0;
  constexpr double kStep_mm = 2.5;
  constexpr double kDown_mm = 1.0;
  PartWriter writer({8.0, 0.0, 0.0}, 4);
  for (int depth = 1; depth <= 3; ++depth) {
    const double z = -kDown_mm * depth;
    if (depth > 1) {
      writer.line_to({8.0, 0.0, z + kDown_mm}, true);
    }
    writer.arc_to({.to_mm = {8.0, 0.0}, .centre_mm = {5.0, 0.0}, .z_mm = z});
    for (int i = 0; i < 10; ++i) {
      const double w = 8.0 + kStep_mm * i;
      const double h = 5.0 + kStep_mm * i;
      const double in_w = w - kRadius_mm;
      const double in_h = h - kRadius_mm;
      writer.line_to({w, 0.0, z});
      writer.line_to({w, in_h, z});
      writer.arc_to({.to_mm = {in_w, h}, .centre_mm = {in_w, in_h}, .z_mm = z});
      writer.line_to({-in_w, h, z});
      writer.arc_to({.to_mm = {-w, in_h}, .centre_mm = {-in_w, in_h}, .z_mm = z});
      writer.line_to({-w, -in_h, z});
      writer.arc_to({.to_mm = {-in_w, -h}, .centre_mm = {-in_w, -in_h}, .z_mm = z});
      writer.line_to({in_w, -h, z});
      writer.arc_to({.to_mm = {w, -in_h}, .centre_mm = {in_w, -in_h}, .z_mm = z});
      writer.line_to({w, 0.0, z});
    }
  }
  return writer.finish();
}

PartProgram small_loops(int loops) {
  constexpr std::array kRadii_mm{0.1, 0.5, 0.2, 1.0, 0.3};
  PartWriter writer({}, 4);
  for (int i = 0; i < loops; ++i) {
    const double r = kRadii_mm[static_cast<std::size_t>(i) % kRadii_mm.size()];
    const auto on = [&writer](double dx, double dy) {
      writer.line_to({writer.here()[0] + dx, writer.here()[1] + dy, 0.0});
    };
    const auto around = [&writer](const Spot& centre, const Spot& to, bool clockwise) {
      const Point here = writer.here();
      writer.arc_to({.to_mm = {here[0] + to[0], here[1] + to[1]},
                     .centre_mm = {here[0] + centre[0], here[1] + centre[1]},
                     .clockwise = clockwise});
    };
    on(1.0, 0.0);
    around({0.0, r}, {0.0, 2.0 * r}, false);  // tangential, and back
    on(-0.3, 0.0);
    around({0.0, r}, {0.0, 2.0 * r}, true);
    on(0.4, 0.1);
    around({r, 0.0}, {0.0, 0.0}, true);  // a whole circle across the way
    on(0.2, -0.2);
    around({0.0, -r}, {r, -r}, true);
    on(0.5, -3.0 * r);
  }
  return writer.finish();
}

}  // namespace kerf::bench
