// G73, G74, G81 to G89: a block's holes as moves.
#include <cmath>

#include "diagnostics/errors/compensation.hpp"
#include "diagnostics/errors/cycles.hpp"
#include "diagnostics/errors/motion.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/moves/arc_geometry.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

std::string Interpreter::motion_name() const {
  return joined({"G", shortest(static_cast<double>(state_.motion) / 10.0)});
}

bool Interpreter::drill_cycle() {
  const bool fanuc_r = dialect_ == Dialect::fanuc && block_->has('R');
  if (!refuse_extra("in a canned cycle")) {
    return false;
  }
  if (!block_->has_any(kAxisLetters) && !fanuc_r) {
    if (!codes_.has(Group::motion) && !block_->has_any(letters('R', 'I', 'J', 'K'))) {
      return true;
    }
    return fail(motion_offset(), errors::kCycleWithoutAxis,
                joined({motion_name(), " needs at least one axis word"}));
  }
  if (!check_cycle_modes() || !take_cycle_words()) {
    return false;
  }
  DrillCycle cycle;
  const Point from = state_.coordinates.to_program(state_.position_mm);
  cycle.plane = state_.plane;
  cycle.hole_mm = from;
  return read_cycle(cycle) && (cycle.holes == 0 || run_cycle(cycle, from));
}

bool Interpreter::check_cycle_modes() {
  if (compensation_.on()) {
    return fail(motion_offset(), errors::kCycleWhileCompensating,
                joined({motion_name(), " cannot be used while G41/G42 is active"}));
  }
  if (state_.feed_mode == FeedMode::inverse_time) {
    return fail(motion_offset(), errors::kCycleInverseTime,
                joined({motion_name(), " cannot be used with G93: write G94 or G95"}));
  }
  if (dialect_ == Dialect::fanuc && state_.motion == Motion::back_bore) {
    return fail(motion_offset(), errors::kFanucBackBore,
                "G87 with Fanuc's words (Q: the shift) is not supported");
  }
  return check_cycle_spindle();
}

bool Interpreter::check_cycle_spindle() {
  const Motion motion = state_.motion;
  const char* wanted = nullptr;
  if (motion == Motion::tap && state_.spindle != Spindle::clockwise) {
    wanted = " running clockwise (M3)";
  } else if (motion == Motion::tap_left && state_.spindle != Spindle::counterclockwise) {
    wanted = " running counterclockwise (M4)";
  } else if (state_.spindle == Spindle::off &&
             (motion == Motion::bore_with_stop || motion == Motion::bore_by_hand ||
              motion == Motion::back_bore)) {
    wanted = " running (M3 or M4)";
  }
  return wanted == nullptr || fail(motion_offset(), errors::kCycleSpindle,
                                   joined({motion_name(), " needs the spindle", wanted}));
}

bool Interpreter::run_cycle(const DrillCycle& cycle, const Point& from_mm) {
  double feedrate_mm_s = 0.0;
  if (!cutting_feedrate(0.0, feedrate_mm_s)) {
    return false;
  }
  cycle_steps_.clear();
  expand(cycle, from_mm, cycle_steps_);
  for (CycleStep& step : cycle_steps_) {
    step.end_mm = state_.coordinates.to_machine(step.end_mm);
    for (const double coordinate : step.end_mm) {
      if (!(std::fabs(coordinate) <= kLargestCoordinate_mm)) {
        return fail(motion_offset(), errors::kPositionOutOfRange,
                    joined({motion_name(), " leads outside -999999.999..999999.999 mm"}));
      }
    }
  }
  for (const CycleStep& step : cycle_steps_) {
    push_cycle_step(step, feedrate_mm_s);
  }
  return true;
}

// Cycles run on the exact path, also while G64 would let the corners go.
void Interpreter::push_cycle_step(const CycleStep& step, double feedrate_mm_s) {
  Move& move = push_move();
  if (move.mode == PathMode::blend) {
    move.mode = PathMode::exact_path;
    move.blend_tolerance_mm = 0.0;
    move.merge_tolerance_mm = 0.0;
  }
  const bool clockwise =
      (state_.spindle == Spindle::clockwise) != (step.kind == StepKind::spindle_turned);
  switch (step.kind) {
    case StepKind::rapid:
    case StepKind::feed:
      move.shape = LineMove{step.end_mm};
      move.rapid = step.kind == StepKind::rapid;
      move.feedrate_mm_s = move.rapid ? 0.0 : feedrate_mm_s;
      state_.position_mm = step.end_mm;
      break;
    case StepKind::dwell:
      move.shape = DwellMove{step.duration_s};
      break;
    case StepKind::spindle_off:
      move.shape = EventMove{EventKind::spindle_off, 0.0};
      break;
    case StepKind::spindle_orient:
      move.shape = EventMove{EventKind::spindle_orient, 0.0};
      break;
    case StepKind::program_stop:
      move.shape = EventMove{EventKind::program_stop, 0.0};
      break;
    default:
      move.shape = turn_spindle(clockwise ? Spindle::clockwise : Spindle::counterclockwise);
      break;
  }
}

}  // namespace kerf::parser
