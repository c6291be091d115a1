// The time of a program from below: for its length alone, whatever is planned on it.
#pragma once

#include <vector>

#include "lookahead/path/limits.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf {

// Lengths over the fastest that program and machine allow, and dwells. That G64 shortens the path
// is allowed for by a share, so there it says much less.
class LeastTime {
 public:
  explicit LeastTime(const lookahead::PlanLimits& limits);

  // segments: the move as it is programmed; a pause has none.
  void add(const parser::Move& move, const std::vector<smoothing::PathSegment>& segments);

  [[nodiscard]] double seconds() const noexcept { return seconds_; }

 private:
  lookahead::PlanLimits limits_;
  double fastest_mm_s_;  // of X, Y and Z together
  double seconds_ = 0.0;
};

}  // namespace kerf
