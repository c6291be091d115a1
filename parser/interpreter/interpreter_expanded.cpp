// The motion of a block that a unit expands: curves with control points, cycles, probing.
#include <algorithm>
#include <optional>

#include "diagnostics/errors/pages.hpp"
#include "parser/curves/splines.hpp"
#include "parser/cycles/canned_cycle.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/spindle_io/switches.hpp"

namespace kerf::parser {

namespace {

Done check_curve_feed(const RunningBlock& at, const ModalState& state) {
  const bool nurbs = state.motion == Motion::nurbs;
  if (state.feed_mode == FeedMode::inverse_time ||
      (nurbs && state.feed_mode == FeedMode::per_revolution)) {
    return fail(at.motion_offset(), errors::kCurveInverseTime,
                nurbs ? "G6.2 cannot be used with G93 or G95" : "G5.2 cannot be used with G93");
  }
  return {};
}

}  // namespace

Done Interpreter::begin_curve(const RunningBlock& at) {
  ModalState& state = memory_.state;
  set_units_and_feed_mode(at.codes);
  if (Done done = set_modes(at); !done) {
    return done;
  }
  Done begun =
      set_feed(at, state)
          .and_then([&] { return check_curve_feed(at, state); })
          .and_then([&] { return feed_.cutting(at, state, 0.0); })
          .and_then([&](double feedrate_mm_s) { return curves_.begin(at, state, feedrate_mm_s); });
  if (!begun) {
    curves_.skip(state.motion);
  } else if (state.motion == Motion::nurbs) {
    warn_of_order(at);
  }
  return begun;
}

Done Interpreter::spline(const RunningBlock& at) {
  ModalState& state = memory_.state;
  const bool cubic = state.motion == Motion::cubic_spline;
  Expected<std::optional<Spline>> read =
      cubic ? cubic_spline(at, state) : quadratic_spline(at, state);
  if (!read) {
    return fault_of(read);
  }
  if (!*read) {
    return {};
  }
  Expected<double> feedrate = feed_.cutting(at, state, 0.0);
  if (!feedrate) {
    return fault_of(feedrate);
  }
  Spline& spline = **read;
  push_curve(at, state, {std::move(spline.curve), cubic ? "G5" : "G5.1", at.source, *feedrate});
  if (cubic) {
    state.spline_handle_mm = spline.second_handle_mm;
  }
  return {};
}

Done Interpreter::drill(const RunningBlock& at) {
  ModalState& state = memory_.state;
  Expected<std::optional<DrillCycle>> cycle = read_cycle(at, state, compensation_.phase());
  if (!cycle) {
    return fault_of(cycle);
  }
  if (!*cycle) {
    return {};
  }
  Expected<double> feedrate = feed_.cutting(at, state, 0.0);
  if (!feedrate) {
    return fault_of(feedrate);
  }
  if (Done done = expand_on_machine(at, state, **cycle, cycle_steps_); !done) {
    return done;
  }
  // A tap's feed goes with the spindle's speed: nobody may change one of them.
  const AllowedOverrides before = state.overrides;
  if (std::ranges::find(cycle_steps_, StepKind::spindle_turned, &CycleStep::kind) !=
      cycle_steps_.end()) {
    follow_overrides(at, state, {.feed = false, .speed = false, .feed_hold = before.feed_hold});
  }
  for (const CycleStep& step : cycle_steps_) {
    push_cycle_step(at, step, {.feedrate_mm_s = *feedrate, .rapids_stop = before.feed});
  }
  follow_overrides(at, state, before);
  return {};
}

// Cycles run on the exact path, also while G64 would let the corners go.
void Interpreter::push_cycle_step(const RunningBlock& at, const CycleStep& step,
                                  const CycleFeed& feed) {
  ModalState& state = memory_.state;
  Move& move = at.push_move(state);
  move.in_cycle = true;
  if (move.mode == PathMode::blend) {
    move.mode = PathMode::exact_path;
    move.blend_tolerance_mm = 0.0;
    move.merge_tolerance_mm = 0.0;
  }
  const bool taps = state.motion == Motion::tap || state.motion == Motion::tap_left;
  move.follows.hold = !taps || step.kind == StepKind::rapid;
  const bool clockwise =
      (state.spindle == Spindle::clockwise) != (step.kind == StepKind::spindle_turned);
  switch (step.kind) {
    case StepKind::rapid:
    case StepKind::feed:
      move.shape = LineMove{step.end_mm};
      move.rapid = step.kind == StepKind::rapid;
      move.feedrate_mm_s = move.rapid ? 0.0 : feed.feedrate_mm_s;
      move.follows.feed = move.rapid ? feed.rapids_stop : move.follows.feed;
      state.position_mm = step.end_mm;
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
    default: {
      EventMove turn =
          spindle_.turn(state, clockwise ? Spindle::clockwise : Spindle::counterclockwise);
      turn.taps = taps;
      move.shape = turn;
      break;
    }
  }
}

Done Interpreter::probe(const RunningBlock& at) {
  ModalState& state = memory_.state;
  Expected<std::optional<ProbeWay>> way = read_probe(at, state);
  if (!way) {
    return fault_of(way);
  }
  if (!*way) {
    return {};
  }
  Expected<double> feedrate = feed_.cutting(at, state, (*way)->length_mm);
  if (!feedrate) {
    return fault_of(feedrate);
  }
  asked_ = {.motion = state.motion, .offset = at.motion_offset()};
  return run_probe(at, state, memory_.answers, {(*way)->end_mm, *feedrate});
}

void Interpreter::take_answer(const MachineQuestion& question, const MachineAnswer& answer) {
  if (question.kind == MachineQuestion::Kind::at_speed) {
    return;
  }
  if (!is_probe(question)) {
    memory_.state.input = answer.found ? answer.value : -1.0;
  } else if (const Done taken = take_probe_answer(asked_, answer, memory_.state); !taken) {
    report(memory_.line, *taken.error());
  }
}

}  // namespace kerf::parser
