// A lower bound of a program's time, from its length alone.
#pragma once

#include <vector>

#include <kerf/kernel.hpp>

#include "lookahead/event_time.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf {

// Length divided by the highest feedrate that program and machine allow, plus dwells. G64 may
// shorten the path, so under G64 only a share of the length counts and the bound is weaker.
class LeastTime {
 public:
  explicit LeastTime(const lookahead::PlanLimits& limits,
                     const lookahead::EventTime::Settings& events = {});
  // With X, Y and Z together.
  [[nodiscard]] static double fastest_mm_s(const lookahead::PlanLimits& limits);

  // segments: the move as it is programmed; a pause has none.
  void add(const parser::Move& move, const std::vector<smoothing::PathSegment>& segments);
  // Without its curve: as if it led straight to its end.
  void add_straight(const parser::Move& move);

  [[nodiscard]] double seconds() const noexcept { return seconds_; }
  // Of the path as it is programmed, with what the machine takes for events.
  [[nodiscard]] const NominalTime& nominal() const noexcept { return nominal_; }
  // Of the path as it is programmed.
  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }

 private:
  struct Way {
    double length_mm = 0.0;
    double time_s = 0.0;
  };
  void count(const parser::Move& move, Way way);
  void rest(const parser::Move& pause);

  lookahead::PlanLimits limits_;
  double fastest_mm_s_;
  double seconds_ = 0.0;
  lookahead::EventTime event_time_;
  NominalTime nominal_{};
  double length_mm_ = 0.0;
};

}  // namespace kerf
