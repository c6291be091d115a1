#include "parser/spindle_io/spindle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG92 = 920;
constexpr double kLargestSpeed = 1e9;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kTwoPi = 6.283185307179586477;
constexpr double kRadPerDegree = kTwoPi / 360.0;

// What G96 has the machine follow: S in m/min or feet/min, about X0 of the program.
SurfaceFollowing surface_following(const ModalState& state) {
  if (!state.surface_speed.active) {
    return {};
  }
  const double metre_mm = state.speed_units == Units::inch ? 12.0 * 25.4 : 1000.0;
  const Coordinates::ProgramX x = state.coordinates.program_x();
  return {.mm_s = state.spindle_speed * metre_mm / kSecondsPerMinute,
          .max_per_min = state.surface_speed.max_per_min,
          .per_x = x.per_x,
          .per_y = x.per_y,
          .at_origin_mm = x.at_origin_mm};
}

Done set_spindle_mode(const RunningBlock& at, ModalState& state) {
  if (at.codes[Group::spindle_mode] == 970) {
    state.spindle_speed = spindle_per_min(state);  // until S says otherwise
    state.surface_speed.active = false;
    return {};
  }
  if (!at.block.has('S')) {
    return fail(at.code_word(Group::spindle_mode).offset, errors::kSurfaceSpeedWithoutS,
                "G96 needs S (surface speed)");
  }
  if (!at.rules.speed_limit_in_g92) {
    state.surface_speed = {};
  }
  state.surface_speed.active = true;
  if (at.block.has('D')) {
    const Word& word = at.block.word('D');
    if (word.value < 0.0) {
      return fail(word.offset, errors::kNegativeMostSpeed,
                  "G96: D (highest speed) must not be negative");
    }
    state.surface_speed.max_per_min = word.value;
  }
  return {};
}

// M19 stops the spindle at the angle R (degrees). P: 0 the shorter way, 1 clockwise, 2
// counterclockwise; Q: how many seconds it may take at the most.
Done orient_spindle(const RunningBlock& at, ModalState& state) {
  if (at.block.has('P')) {
    const Word& word = at.block.word('P');
    if (word.value != 0.0 && word.value != 1.0 && word.value != 2.0) {
      return fail(word.offset, errors::kOrientWay,
                  joined({"M19: P must be 0, 1 or 2, found ", shortest(word.value)}));
    }
  }
  if (at.block.has('Q') && !(at.block.value('Q') > 0.0)) {
    return fail(
        at.block.word('Q').offset, errors::kOrientTime,
        joined({"M19: Q (seconds) must be greater than 0, found ", shortest(at.block.value('Q'))}));
  }
  state.spindle = Spindle::off;
  at.push_event(state, {EventKind::spindle_orient, at.block.value_or('R', 0.0) * kRadPerDegree});
  return {};
}

}  // namespace

Done set_speed(const RunningBlock& at, ModalState& state) {
  if (at.codes.has(Group::spindle_mode)) {
    if (Done done = set_spindle_mode(at, state); !done) {
      return done;
    }
  }
  if (!at.block.has('S')) {
    return {};
  }
  const Word& word = at.block.word('S');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeSpeed, "S must not be negative");
  }
  if (word.value > kLargestSpeed) {
    return fail(
        word.offset, errors::kSpeedOutOfRange,
        joined({"S: value ", upper(at.block.text(word).substr(1, 40)), " is out of range"}));
  }
  if (at.rules.speed_limit_in_g92 && at.codes[Group::other] == kG92) {
    state.surface_speed.max_per_min = word.value;
  } else {
    state.spindle_speed = word.value;
    state.speed_units = state.units;
  }
  return {};
}

double spindle_per_min(const ModalState& state) {
  if (!state.surface_speed.active) {
    return state.spindle_speed;
  }
  const double radius_mm = std::fabs(state.coordinates.to_program(state.position_mm)[0]);
  const double surface_mm = surface_following(state).mm_s * kSecondsPerMinute;
  const double most = state.surface_speed.max_per_min;
  return surface_mm >= most * kTwoPi * radius_mm ? most : surface_mm / (kTwoPi * radius_mm);
}

EventMove SpindleDrive::turn(const ModalState& state, Spindle direction) {
  followed_ = surface_following(state);
  return {.kind = direction == Spindle::clockwise ? EventKind::spindle_cw : EventKind::spindle_ccw,
          .value = spindle_per_min(state),
          .surface = followed_};
}

void SpindleDrive::follow_moved_axis(const MoveSink& at, const ModalState& state) {
  if (state.spindle != Spindle::off && surface_following(state) != followed_) {
    at.push_move(state).shape = turn(state, state.spindle);
  }
}

std::optional<SpindleWait> wait_for_speed(const MachineSource& machine, std::uint64_t block,
                                          const SpeedChange& change) {
  if (!machine.waits_for_spindle) {
    return std::nullopt;
  }
  if (machine.asks_in(block)) {
    return EventMove{.kind = EventKind::ask_machine,
                     .question = {.kind = MachineQuestion::Kind::at_speed}};
  }
  const double time_s = machine.assumed != nullptr ? machine.assumed->spindle_time_s(
                                                         change.from_per_min, change.to_per_min)
                                                   : 0.0;
  const double had_s = change.from_per_min == 0.0 ? machine.spindle_start_s : 0.0;
  return DwellMove{.duration_s = std::max(time_s - had_s, 0.0) + machine.answer_s, .assumed = true};
}

void SpindleDrive::turn_on(const MoveSink& at, const ModalState& state,
                           const MachineSource& machine) {
  const EventMove event = turn(state, state.spindle);
  at.push_event(state, event);
  const double before_per_min = std::exchange(turns_per_min_, turns_per_min(event));
  if (const auto wait =
          wait_for_speed(machine, at.block_number,
                         {.from_per_min = before_per_min, .to_per_min = turns_per_min_})) {
    std::visit([&](const auto& shape) { at.push_move(state).shape = shape; }, *wait);
  }
}

void SpindleDrive::turn_off(const MoveSink& at, const ModalState& state) {
  turns_per_min_ = 0.0;
  at.push_event(state, {EventKind::spindle_off});
}

Done SpindleDrive::start(const RunningBlock& at, ModalState& state, const MachineSource& machine) {
  if (state.spindle == Spindle::off) {  // M6 stops it, too
    turns_per_min_ = 0.0;
  }
  const Tenths code = at.codes[Group::spindle];
  if (code == 190) {
    turns_per_min_ = 0.0;
    return orient_spindle(at, state);
  }
  if (code == 50) {
    state.spindle = Spindle::off;
    turn_off(at, state);
    return {};
  }
  if (code != kNoCode) {
    state.spindle = code == 30 ? Spindle::clockwise : Spindle::counterclockwise;
  }
  const bool changed = code != kNoCode || at.block.has('S') || at.codes.has(Group::spindle_mode);
  if (changed && state.spindle != Spindle::off) {
    turn_on(at, state, machine);
  }
  return {};
}

}  // namespace kerf::parser
