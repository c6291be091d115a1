// How long what is left of a program takes.
#pragma once

#include <array>
#include <deque>
#include <optional>

#include "lookahead/path/block.hpp"

namespace kerf {

// The idea: a program's nominal time, length over feedrate, is known from its check, and so is the
// nominal time of the path that the tool has behind it. What the machine took for that, beside what
// it would take at the feedrate, is what it will take for the rest. Dwells take what they say.
// Weakness: a program whose end is of another kind than its begin is judged by the begin, and
// dwells that are not read yet count as motion.
class TimeLeft {
 public:
  // Of the whole program (CheckReport::nominal_s); 0: nobody knows.
  TimeLeft(const lookahead::PlanLimits& limits, double nominal_s);

  // In program order, as the path is run.
  void push(const lookahead::Block& block);
  void push_rest(double duration_s);

  // What was pushed ends here, where the tool rests: a probe has found what it looked for.
  void end_path_at(double path_mm);

  struct ToolPlace {
    double path_mm = 0.0;
    double moved_s = 0.0;  // without holds and waits
    double feed_override = 1.0;
  };
  void follow(const ToolPlace& tool);
  // Nothing: nobody knows, or at a feed of 0 never.
  [[nodiscard]] std::optional<double> left_s() const;

 private:
  struct Mark {
    double path_mm = 0.0;
    double nominal_s = 0.0;
    double rest_s = 0.0;  // of dwells, and of axes that turn alone: the path stands still
  };
  void reach(double path_mm);

  double fastest_mm_s_;
  std::array<MotionLimits, kAuxiliaryAxes> extra_;
  double whole_nominal_s_;
  std::deque<Mark> marks_;  // ends of what lies ahead of the tool
  Mark pushed_{};           // the end of all
  Mark behind_{};           // the latest that the tool has passed
  double done_nominal_s_ = 0.0;
  double rest_to_run_s_ = 0.0;  // where the tool is
  double in_motion_s_ = 0.0;
  double expected_s_ = 0.0;  // of that, nominal, at the overrides that were in force
  ToolPlace tool_{};
};

}  // namespace kerf
