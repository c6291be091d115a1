// About how long the lines of a program take, before their times are planned.
#pragma once

#include <cstdint>
#include <vector>

#include <kerf/machine.hpp>

#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::program {

// Length divided by feedrate, or by what the axes can do in that direction. Weakness: a line that
// begins or ends slower takes longer. The shares of lines among which that is alike are right.
class NominalLines {
 public:
  explicit NominalLines(const MachineLimits& limits) : limits_(limits) {}

  // As they are run.
  void add(const smoothing::PathSegment& segment);
  void add(const parser::Move& move);

  // By line of the program, in all its rounds; 0: it takes no time.
  [[nodiscard]] const std::vector<double>& seconds() const noexcept { return seconds_; }

 private:
  void count(std::uint32_t line, double duration_s);

  MachineLimits limits_;
  std::vector<double> seconds_;
};

}  // namespace kerf::program
