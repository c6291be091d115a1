// Lines whose time optimum is known in closed form.
#pragma once

#include <cstddef>
#include <deque>

#include "lookahead/path/block.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

struct LineJunctions {
  Junction begin{};
  Junction end{};
  bool are_cruises = false;  // both are a rest, or passed_as_cruise (junction_share.hpp)
};

// A line that is long enough to pass both junctions as fast as they allow, with no acceleration at
// either: then no plan before or after it reaches it, and between them the S-curve is the time
// optimum. There is none at junctions that leave nothing for it; nor where the line is long enough
// to be clearly faster between them, or as fast as it allows, for then the feedrate has a minimum
// at both. Weakness: beside a junction the S-curve keeps the feedrate constant for three ticks, the
// optimum only nearly so. False for curves.
bool is_independent_line(const Block& block, const LineJunctions& junctions);

// The last lines of a row of independent ones, as many as the look-ahead keeps behind what it plans
// for good. As long as more may come the plan ends at rest after them, and over each of them it
// brakes without acceleration at either end: dv = J (L / 2v)^2, so v^3 falls by 3/4 J L^2, or by
// 3/2 A L v where the line is long enough to come to A.
class LinesAhead {
 public:
  explicit LinesAhead(std::size_t most) : most_(most) {}

  void clear();
  // v_begin_mm_s: at its begin.
  void push(const Block& line, double v_begin_mm_s);
  // False: they are too short to brake on from where the first begins, so the rest after them
  // would make the row slower than its junctions do.
  [[nodiscard]] bool are_long_enough() const;

 private:
  struct Line {
    double v_begin_mm_s = 0.0;
    double fall = 0.0;  // of v^3
  };
  std::size_t most_;
  std::deque<Line> lines_;
  double fall_ = 0.0;  // of all
};

}  // namespace kerf::lookahead
