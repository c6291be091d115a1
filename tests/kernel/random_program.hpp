// Random part programs: lines, arcs, helices and NURBS over many decades of length and feed.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/kernel/dense_path.hpp"
#include "tests/kernel/program_path.hpp"

namespace kerf::test {

struct RandomProgram {
  std::string text;
  std::array<double, 3> start_mm{};  // where the tool is
  std::array<double, 3> end_mm{};    // as printed in the last motion block
  double end_a_deg = 0.0;
  double end_u_mm = 0.0;
  std::vector<double> feedrate_mm_s;  // by source line, line 1 first; 0 where no motion starts
  std::vector<Stretch> path;
  std::vector<PathPoint> dense;  // in place of path: of a single curve

  [[nodiscard]] std::size_t lines() const { return feedrate_mm_s.size(); }
  // Of the blocks that a tick from one line to another may touch.
  [[nodiscard]] double fastest_mm_s(std::size_t from_line, std::size_t to_line) const;
};

// kinds of motion that a program may hold
struct Mix {
  bool arcs = true;
  bool nurbs = true;
  bool extra = false;    // A and U beside lines and arcs, and alone
  bool contour = false;  // many short lines with gentle turns instead of everything else
  int blocks = 12;
  double longest_mm = 1e3;  // of a line; arcs and curves in proportion
};

RandomProgram random_program(std::uint64_t seed, const Mix& mix);

}  // namespace kerf::test
