// A lower bound of a program's time, from its length alone.
#pragma once

#include <vector>

#include "lookahead/path/limits.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf {

// Length divided by the highest feedrate that program and machine allow, plus dwells. G64 may
// shorten the path, so under G64 only a share of the length counts and the bound is weaker.
class LeastTime {
 public:
  explicit LeastTime(const lookahead::PlanLimits& limits);
  // With X, Y and Z together.
  [[nodiscard]] static double fastest_mm_s(const lookahead::PlanLimits& limits);

  // segments: the move as it is programmed; a pause has none.
  void add(const parser::Move& move, const std::vector<smoothing::PathSegment>& segments);
  // Without its curve: as if it led straight to its end.
  void add_straight(const parser::Move& move);

  [[nodiscard]] double seconds() const noexcept { return seconds_; }
  // The same for the path as it is programmed.
  [[nodiscard]] double nominal_s() const noexcept { return nominal_s_; }
  // Of the path as it is programmed.
  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }

 private:
  struct Way {
    double length_mm = 0.0;
    double time_s = 0.0;
  };
  void count(const parser::Move& move, Way way);
  void rest(double duration_s);

  lookahead::PlanLimits limits_;
  double fastest_mm_s_;
  double seconds_ = 0.0;
  double nominal_s_ = 0.0;
  double length_mm_ = 0.0;
};

}  // namespace kerf
