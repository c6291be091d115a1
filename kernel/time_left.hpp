// How long what is left of a program takes.
#pragma once

#include <array>
#include <deque>
#include <optional>

#include <kerf/kernel.hpp>

#include "lookahead/event_time.hpp"
#include "lookahead/path/block.hpp"

namespace kerf {

// The idea: a program's nominal time, length over feedrate, is known from its check, and so is the
// nominal time of the path that the tool has behind it. What the machine took for that, beside what
// it would take at the feedrate, is what it will take for the rest. An override divides what
// follows it alone. Dwells take what they say, and what the machine does while the tool rests takes
// what its file says. Weakness: a program whose end is of another kind than its begin is judged by
// the begin.
class TimeLeft {
 public:
  // Of the whole program (CheckReport::nominal); nothing: nobody knows.
  TimeLeft(const lookahead::PlanLimits& limits, const std::optional<NominalTime>& nominal);

  // In program order, as the path is run.
  void push(const lookahead::Block& block);
  void push_rest(const lookahead::RestTime& time);
  // Nothing follows: by blends, and by what the machine answers, it may be less than was expected.
  void end();

  // What was pushed ends here, where the tool rests: a probe has found what it looked for.
  void end_path_at(double path_mm);

  struct ToolPlace {
    double path_mm = 0.0;
    double moved_s = 0.0;    // without holds and waits
    Overrides overrides{};   // in force: the feed may be 0
    bool feed_is_0 = false;  // the operator's, in force here or not
  };
  void follow(const ToolPlace& tool);
  // Nothing: nobody knows, or at a feed of 0 never.
  [[nodiscard]] std::optional<double> left_s() const;

 private:
  struct Mark {
    double path_mm = 0.0;
    NominalTime nominal{};  // a rest is a dwell, or axes that turn alone: the path stands still
  };
  void reach(double path_mm);
  void push_standing(double duration_s);

  double fastest_mm_s_;
  std::array<MotionLimits, kAuxiliaryAxes> extra_;
  bool is_known_;
  NominalTime not_pushed_{};
  std::deque<Mark> marks_;  // ends of what lies ahead of the tool
  Mark pushed_{};           // the end of all
  Mark behind_{};           // the latest that the tool has passed
  NominalTime done_nominal_{};
  double rest_to_run_s_ = 0.0;  // where the tool is
  double in_motion_s_ = 0.0;
  double expected_s_ = 0.0;  // of that, nominal, at the overrides that were in force
  ToolPlace tool_{};
};

}  // namespace kerf
