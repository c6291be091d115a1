#include "parser/cycles/drill_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "parser/moves/arc_geometry.hpp"

namespace kerf::parser {

namespace {

// By so much a height may differ that comes back from the machine's coordinates.
constexpr double kRounding_mm = 1e-7;

// Writes the steps of one block. The place follows the moves, so that each step names only what
// it changes.
class Expansion {
 public:
  Expansion(const DrillCycle& cycle, const Point& from_mm, std::vector<CycleStep>& steps)
      : cycle_(cycle), steps_(steps), at_(from_mm), up_(axes_of(cycle.plane).normal) {
    const DrillLevels& levels = cycle.levels;
    end_mm_ =
        cycle.to_initial ? std::max(levels.initial_mm, levels.clearance_mm) : levels.clearance_mm;
  }

  void run() {
    const double clearance_mm = cycle_.levels.clearance_mm;
    if (cycle_.levels.initial_mm < clearance_mm) {
      move_to(StepKind::rapid, clearance_mm);
    }
    Point hole = cycle_.hole_mm;
    for (std::uint32_t i = 0; i < cycle_.holes; ++i) {
      hole[up_] = at_[up_] > clearance_mm + kRounding_mm ? at_[up_] : end_mm_;
      move(StepKind::rapid, hole);
      move_to(StepKind::rapid, clearance_mm);
      drill();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        hole[axis] += cycle_.between_mm[axis];
      }
    }
  }

 private:
  void drill() {
    switch (cycle_.kind) {
      case Motion::chip_breaking:
      case Motion::peck:
        return peck();
      case Motion::tap_left:
      case Motion::tap:
        return tap();
      case Motion::back_bore:
        return back_bore();
      default:
        return bore();
    }
  }

  // G81, G82, G85, G86, G88, G89: down once, and up in one of three ways.
  void bore() {
    const Motion kind = cycle_.kind;
    const bool stops = kind == Motion::bore_with_stop || kind == Motion::bore_by_hand;
    move_to(StepKind::feed, cycle_.levels.bottom_mm);
    dwell();
    if (stops) {
      event(StepKind::spindle_off);
    }
    if (kind == Motion::bore_by_hand) {
      event(StepKind::program_stop);
    }
    if (kind == Motion::bore) {
      move_to(StepKind::feed, cycle_.levels.clearance_mm);
    }
    move_to(kind == Motion::bore_with_dwell ? StepKind::feed : StepKind::rapid, end_mm_);
    if (stops) {
      event(StepKind::spindle_on);
    }
  }

  // G83 clears the chips out of the hole after each peck, G73 only breaks them.
  void peck() {
    const double clearance_mm = cycle_.levels.clearance_mm;
    const double feeds = feeds_of(cycle_);
    for (int i = 1; i < feeds; ++i) {
      const double depth_mm = clearance_mm - i * cycle_.peck_mm;
      move_to(StepKind::feed, depth_mm);
      if (cycle_.kind == Motion::peck) {
        move_to(StepKind::rapid, clearance_mm);
      }
      move_to(StepKind::rapid, depth_mm + kChipGap_mm);
    }
    move_to(StepKind::feed, cycle_.levels.bottom_mm);
    dwell();
    move_to(StepKind::rapid, end_mm_);
  }

  void tap() {
    move_to(StepKind::feed, cycle_.levels.bottom_mm);
    event(StepKind::spindle_off);
    event(StepKind::spindle_turned);
    dwell();
    move_to(StepKind::feed, end_mm_);
    event(StepKind::spindle_off);
    event(StepKind::spindle_on);
  }

  // Through the hole with the oriented tool aside of its axis, boring upwards, and back.
  void back_bore() {
    step_aside(1.0);
    event(StepKind::spindle_off);
    event(StepKind::spindle_orient);
    move_to(StepKind::rapid, cycle_.levels.bottom_mm);
    step_aside(-1.0);
    event(StepKind::spindle_on);
    move_to(StepKind::feed, cycle_.counter_mm);
    dwell();
    move_to(StepKind::feed, cycle_.levels.bottom_mm);
    event(StepKind::spindle_off);
    event(StepKind::spindle_orient);
    step_aside(1.0);
    move_to(StepKind::rapid, end_mm_);
    step_aside(-1.0);
    event(StepKind::spindle_on);
  }

  void step_aside(double way) {
    Point end = at_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      end[axis] += way * cycle_.aside_mm[axis];
    }
    move(StepKind::rapid, end);
  }

  void move_to(StepKind kind, double height_mm) {
    Point end = at_;
    end[up_] = height_mm;
    move(kind, end);
  }

  void move(StepKind kind, const Point& end_mm) {
    if (end_mm != at_) {
      at_ = end_mm;
      steps_.push_back({kind, at_, 0.0});
    }
  }

  void event(StepKind kind) { steps_.push_back({kind, at_, 0.0}); }

  void dwell() {
    if (cycle_.dwell_s > 0.0) {
      steps_.push_back({StepKind::dwell, at_, cycle_.dwell_s});
    }
  }

  const DrillCycle& cycle_;
  std::vector<CycleStep>& steps_;
  Point at_;
  std::size_t up_;
  double end_mm_ = 0.0;
};

}  // namespace

Letters letters_of_cycle(Motion motion, const DialectRules& rules) {
  const Letters common = letters('R', 'L') | (rules.repeats_in_k ? letters('K') : 0);
  switch (motion) {
    case Motion::chip_breaking:
    case Motion::peck:
      return common | letters('Q') | (rules.cycle_dwell_optional ? letters('P') : 0);
    case Motion::drill:
    case Motion::bore:
      return common;
    case Motion::back_bore:
      return common | letters('I', 'J', 'K') |
             (rules.back_bore_aside ? 0 : letters('P', 'Q'));  // for a message of its own
    default:
      return common | letters('P');
  }
}

// A depth that pecks reach but for rounding is not fed to twice.
double feeds_of(const DrillCycle& cycle) {
  if (cycle.kind != Motion::peck && cycle.kind != Motion::chip_breaking) {
    return 1.0;
  }
  constexpr double kRounding = 1e-9;
  const double depth_mm = cycle.levels.clearance_mm - cycle.levels.bottom_mm;
  return std::max(1.0, std::ceil(depth_mm / cycle.peck_mm - kRounding));
}

void expand(const DrillCycle& cycle, const Point& from_mm, std::vector<CycleStep>& steps) {
  Expansion(cycle, from_mm, steps).run();
}

}  // namespace kerf::parser
