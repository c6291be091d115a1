// Part programs of short segments, made the same way every time.
#pragma once

#include <string>
#include <vector>

#include "bench/part_path.hpp"

namespace kerf::bench {

// Rest to rest from its first point. The body needs a line before it that says modes and feed.
struct PartProgram {
  std::string body;
  Point start_mm{};
  std::vector<PathElement> path;  // as written, decimals included
};

// Lines and arcs as text, rounded to so many decimals, and as the path that this text means.
class PartWriter {
 public:
  PartWriter(const Point& start_mm, int decimals);

  void line_to(const Point& to_mm, bool rapid = false);
  // In XY, about a centre; z_mm: of its end.
  struct Arc {
    std::array<double, 2> to_mm{};
    std::array<double, 2> centre_mm{};
    bool clockwise = false;
    double z_mm = 0.0;
  };
  void arc_to(const Arc& arc);
  [[nodiscard]] const Point& here() const { return here_; }
  [[nodiscard]] PartProgram finish();

 private:
  [[nodiscard]] double rounded(double value) const;
  void write(char letter, double value);

  int decimals_;
  double units_per_mm_;
  Point here_{};
  PartProgram program_;
};

// Points of x = 45 + r cos t, y = 50 + r sin t, z = -1 + 0.5 sin 3t with r = 20 + 5 cos 5t, one
// after the other at equal steps of its length; closed, it goes round and round.
class Flower {
 public:
  explicit Flower(double step_mm) : step_mm_(step_mm) {}
  [[nodiscard]] Point here() const;
  void advance();

 private:
  double step_mm_;
  double t_ = 0.0;
};

// Rows of 100 mm in steps of 0.2 mm over z = 5 sin(x/12) cos(y/9) + 0.3 sin(x/1.7), the rows 0.2 mm
// apart and joined by a step in Y.
PartProgram raster(int lines);
PartProgram flower(int decimals);
// Along X.
PartProgram straight(double length_mm, int lines);
PartProgram square(double side_mm);
// Of Archimedes, outwards from a radius to another.
struct SpiralShape {
  double from_radius_mm = 2.0;
  double to_radius_mm = 40.0;
  int lines = 50'000;
};
PartProgram spiral(const SpiralShape& shape);
// Letters of lines and flattened bows, with plunges and rapids between the strokes.
PartProgram engraving();
// Rounded rectangles from the inside outwards, G2 and G3, a helix down to each of three depths.
PartProgram pocket();
// Small arcs and short lines, tangential junctions and corners of all kinds.
PartProgram small_loops(int loops);

}  // namespace kerf::bench
