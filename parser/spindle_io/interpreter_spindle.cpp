// Spindle: S, G96, G97, M3, M4, M5, M19, and the feed that follows it (G95).
#include <algorithm>
#include <cmath>

#include "diagnostics/errors/modes.hpp"
#include "diagnostics/errors/motion.hpp"
#include "diagnostics/errors/switches.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG92 = 920;
constexpr double kLargestSpeed = 1e9;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kTwoPi = 6.283185307179586477;
constexpr double kRadPerDegree = kTwoPi / 360.0;

}  // namespace

bool Interpreter::set_speed() {
  if (codes_.has(Group::spindle_mode) && !set_spindle_mode()) {
    return false;
  }
  if (!block_->has('S')) {
    return true;
  }
  const Word& word = block_->word('S');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeSpeed, "S must not be negative");
  }
  if (word.value > kLargestSpeed) {
    return fail(word.offset, errors::kSpeedOutOfRange,
                joined({"S: value ", upper(block_->text(word).substr(1, 40)), " is out of range"}));
  }
  if (dialect_ == Dialect::fanuc && codes_[Group::other] == kG92) {
    state_.surface_speed.most_per_min = word.value;
  } else {
    state_.spindle_speed = word.value;
  }
  return true;
}

bool Interpreter::set_spindle_mode() {
  if (codes_[Group::spindle_mode] == 970) {
    state_.spindle_speed = spindle_per_min();  // until S says otherwise
    state_.surface_speed.active = false;
    return true;
  }
  if (!block_->has('S')) {
    return fail(code_word(*block_, codes_, Group::spindle_mode).offset,
                errors::kSurfaceSpeedWithoutS, "G96 needs S (surface speed)");
  }
  if (dialect_ == Dialect::rs274) {
    state_.surface_speed = {};
  }
  state_.surface_speed.active = true;
  if (block_->has('D')) {
    const Word& word = block_->word('D');
    if (word.value < 0.0) {
      return fail(word.offset, errors::kNegativeMostSpeed,
                  "G96: D (highest speed) must not be negative");
    }
    state_.surface_speed.most_per_min = word.value;
  }
  return true;
}

// Revolutions per minute. With G96 those that give the surface speed S at the place where the tool
// is now.
double Interpreter::spindle_per_min() const {
  if (!state_.surface_speed.active) {
    return state_.spindle_speed;
  }
  const double radius_mm = std::fabs(state_.coordinates.to_program(state_.position_mm)[0]);
  const double surface_mm = surface_following().mm_s * kSecondsPerMinute;
  const double most = state_.surface_speed.most_per_min;
  return surface_mm >= most * kTwoPi * radius_mm ? most : surface_mm / (kTwoPi * radius_mm);
}

// What G96 has the machine follow: S in m/min or feet/min, about X0 of the program.
SurfaceFollowing Interpreter::surface_following() const {
  if (!state_.surface_speed.active) {
    return {};
  }
  const double metre_mm = state_.units == Units::inch ? 12.0 * 25.4 : 1000.0;
  const Coordinates::ProgramX x = state_.coordinates.program_x();
  return {.mm_s = state_.spindle_speed * metre_mm / kSecondsPerMinute,
          .most_per_min = state_.surface_speed.most_per_min,
          .per_x = x.per_x,
          .per_y = x.per_y,
          .at_origin_mm = x.at_origin_mm};
}

EventMove Interpreter::turn_spindle(Spindle direction) {
  surface_sent_ = surface_following();
  return {.kind = direction == Spindle::clockwise ? EventKind::spindle_cw : EventKind::spindle_ccw,
          .value = spindle_per_min(),
          .surface = surface_sent_};
}

// Another work offset, tool offset or unit has changed what X0 or S is to a turning spindle.
void Interpreter::follow_moved_axis() {
  if (state_.spindle != Spindle::off && surface_following() != surface_sent_) {
    push_move().shape = turn_spindle(state_.spindle);
  }
}

// M3, M4, M5; a new S while the spindle turns is sent as its direction once more.
bool Interpreter::start_spindle() {
  const Tenths code = codes_[Group::spindle];
  if (code == 190) {
    return orient_spindle();
  }
  if (code == 50) {
    state_.spindle = Spindle::off;
    push_event(EventKind::spindle_off, 0.0);
    return true;
  }
  if (code != kNoCode) {
    state_.spindle = code == 30 ? Spindle::clockwise : Spindle::counterclockwise;
    stopped_spindle_reported_ = false;
  }
  const bool changed = code != kNoCode || block_->has('S') || codes_.has(Group::spindle_mode);
  if (changed && state_.spindle != Spindle::off) {
    push_move().shape = turn_spindle(state_.spindle);
  }
  return true;
}

// M19 stops the spindle at the angle R (degrees). P: 0 the shorter way, 1 clockwise, 2
// counterclockwise; Q: how many seconds it may take at the most.
bool Interpreter::orient_spindle() {
  if (block_->has('P')) {
    const Word& word = block_->word('P');
    if (word.value != 0.0 && word.value != 1.0 && word.value != 2.0) {
      return fail(word.offset, errors::kOrientWay,
                  joined({"M19: P must be 0, 1 or 2, found ", shortest(word.value)}));
    }
  }
  if (block_->has('Q') && !(block_->value('Q') > 0.0)) {
    return fail(
        block_->word('Q').offset, errors::kOrientTime,
        joined({"M19: Q (seconds) must be greater than 0, found ", shortest(block_->value('Q'))}));
  }
  state_.spindle = Spindle::off;
  push_event(EventKind::spindle_orient, block_->value_or('R', 0.0) * kRadPerDegree);
  return true;
}

// G95. A spindle that stands would never feed; the speed that S gives is taken instead, since the
// spindle may be one that the operator switches on.
bool Interpreter::feedrate_per_revolution(double& feedrate_mm_s) {
  const double per_min = spindle_per_min();
  if (*state_.feed_per_revolution_mm == 0.0) {
    return fail(block_->has('F') ? block_->word('F').offset : motion_offset(), errors::kZeroFeed,
                joined({"feed is zero: G", shortest(static_cast<double>(state_.motion) / 10.0),
                        " needs F greater than 0"}));
  }
  if (per_min == 0.0) {
    return fail(motion_offset(), errors::kNoSpeedForFeed,
                "G95 is active: feed per revolution needs a spindle speed (S)");
  }
  if (state_.spindle == Spindle::off && !stopped_spindle_reported_) {
    stopped_spindle_reported_ = true;
    warn(motion_offset(), errors::kFeedOfStoppedSpindle,
         joined({"G95 with the spindle stopped: the feed of S", shortest(state_.spindle_speed),
                 " is taken"}));
  }
  feedrate_mm_s = *state_.feed_per_revolution_mm * per_min / 60.0;
  return true;
}

}  // namespace kerf::parser
