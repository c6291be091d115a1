// Modal words, feed and dwell.
#include <cmath>

#include "diagnostics/errors/modes.hpp"
#include "diagnostics/errors/motion.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG4 = 40;
constexpr double kLargestFeed = 1e9;

}  // namespace

void Interpreter::set_units(Units units) {
  state_.feed_from_other_units = state_.feed_from_other_units != (units != state_.units);
  state_.units = units;
}

// A change of the feed mode forgets the persistent F [NISTIR 6556, 3.5.19].
void Interpreter::set_feed_mode(FeedMode mode) {
  if (mode != state_.feed_mode) {
    state_.feed_mode = mode;
    state_.feedrate_mm_s.reset();
    state_.feed_per_revolution_mm.reset();
    stopped_spindle_reported_ = false;
  }
}

// What F needs to know.
void Interpreter::set_units_and_feed_mode() {
  if (codes_.has(Group::units)) {
    set_units(codes_[Group::units] == 200 ? Units::inch : Units::mm);
  }
  if (codes_.has(Group::feed_mode)) {
    set_feed_mode(feed_mode_of(codes_[Group::feed_mode]));
  }
}

// G4 comes before the modes.
bool Interpreter::set_modes() {
  if (codes_[Group::other] == kG4 && !dwell()) {
    return false;
  }
  if (codes_.has(Group::plane)) {
    state_.plane = plane_of(codes_[Group::plane]);
  }
  if (codes_.has(Group::cutter_compensation) && !set_compensation()) {
    return false;
  }
  if (codes_.has(Group::distance)) {
    state_.incremental = codes_[Group::distance] == 910;
  }
  if (codes_.has(Group::arc_distance)) {
    state_.absolute_centre = codes_[Group::arc_distance] == 901;
  }
  if (codes_.has(Group::retract)) {
    state_.to_initial_level = codes_[Group::retract] == 980;
  }
  if (codes_.has(Group::motion)) {
    set_motion(codes_[Group::motion]);
  }
  if (codes_.has(Group::length_offset) && !set_length_offset()) {
    return false;
  }
  if (!select_work_offset()) {
    return false;
  }
  change_local_offset();
  if (dialect_ == Dialect::fanuc && !shape_program()) {
    return false;
  }
  return set_path_mode();
}

bool Interpreter::set_path_mode() {
  const Tenths code = codes_[Group::path];
  if (code == kNoCode) {
    return true;
  }
  state_.path_mode = code == 640   ? PathMode::blend
                     : code == 611 ? PathMode::exact_stop
                                   : PathMode::exact_path;
  state_.blend_tolerance_mm = 0.0;
  state_.merge_tolerance_mm = 0.0;
  return code != 640 || set_tolerances();
}

// Of G64. P alone stands for both [rs274 sets the tolerance of its naive CAM detector so]; where it
// is missing LinuxCNC cuts corners without a bound, and here the machine's own bound holds.
bool Interpreter::set_tolerances() {
  state_.blend_tolerance_mm = machine_.corner_tolerance_mm;
  state_.merge_tolerance_mm = machine_.merge_tolerance_mm;
  if (block_->has('P')) {
    const Word& word = block_->word('P');
    if (word.value < 0.0) {
      return fail(word.offset, errors::kNegativeBlendTolerance,
                  "G64: P (tolerance) must not be negative");
    }
    state_.blend_tolerance_mm = word.value * mm_per_unit(state_.units);
    state_.merge_tolerance_mm = state_.blend_tolerance_mm;
  }
  if (block_->has('Q')) {
    const Word& word = block_->word('Q');
    if (word.value < 0.0) {
      return fail(word.offset, errors::kNegativeMergeTolerance,
                  "G64: Q (merging tolerance) must not be negative");
    }
    state_.merge_tolerance_mm = word.value * mm_per_unit(state_.units);
  }
  return true;
}

bool Interpreter::set_feed() {
  if (!block_->has('F')) {
    return true;
  }
  const Word& word = block_->word('F');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeFeed, "F must not be negative");
  }
  if (word.value > kLargestFeed) {
    return fail(word.offset, errors::kFeedOutOfRange,
                joined({"F: value ", upper(block_->text(word).substr(1, 40)), " is out of range"}));
  }
  state_.feed_word = word.value;
  state_.feed_from_other_units = false;
  if (state_.feed_mode == FeedMode::per_minute) {
    state_.feedrate_mm_s = feedrate_mm_s_from(word.value, state_.units);
  } else if (state_.feed_mode == FeedMode::per_revolution) {
    state_.feed_per_revolution_mm = word.value * mm_per_unit(state_.units);
  }
  return true;
}

bool Interpreter::dwell() {
  if (dialect_ == Dialect::fanuc) {
    return fanuc_dwell();
  }
  const Word& code = code_word(*block_, codes_, Group::other);
  if (!block_->has('P')) {
    return fail(code.offset, errors::kDwellWithoutTime, "G4 needs P (seconds)");
  }
  const Word& word = block_->word('P');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeDwell, "G4: P must not be negative");
  }
  push_move().shape = DwellMove{word.value};
  return true;
}

bool Interpreter::inverse_time_feedrate(double length_mm, double& feedrate_mm_s) {
  if (!block_->has('F')) {
    return fail(motion_offset(), errors::kInverseTimeWithoutFeed,
                "G93 is active: F is needed in every cutting block");
  }
  if (block_->value('F') == 0.0) {
    return fail(block_->word('F').offset, errors::kInverseTimeZeroFeed,
                "F must be greater than 0 with G93");
  }
  feedrate_mm_s = feedrate_mm_s_from(InverseTime{length_mm, block_->value('F')});
  return true;
}

// The feedrate of a cutting move of this block; `length_mm` is what G93 divides by the time.
bool Interpreter::cutting_feedrate(double length_mm, double& feedrate_mm_s) {
  const auto name = [this] {
    return joined({"G", shortest(static_cast<double>(state_.motion) / 10.0)});
  };
  if (state_.feed_mode == FeedMode::inverse_time) {
    return inverse_time_feedrate(length_mm, feedrate_mm_s);
  }
  if (state_.feed_mode == FeedMode::per_revolution && state_.feed_per_revolution_mm) {
    return feedrate_per_revolution(feedrate_mm_s);
  }
  if (!state_.feedrate_mm_s) {
    if (!no_feed_reported_) {
      no_feed_reported_ = true;
      return fail(motion_offset(), errors::kNoFeed, joined({"no feed set: ", name(), " needs F"}));
    }
    feedrate_mm_s = 1.0;
    return true;
  }
  if (*state_.feedrate_mm_s == 0.0) {
    return fail(block_->has('F') ? block_->word('F').offset : motion_offset(), errors::kZeroFeed,
                joined({"feed is zero: ", name(), " needs F greater than 0"}));
  }
  if (state_.feed_from_other_units) {
    state_.feed_from_other_units = false;
    const bool was_inch = state_.units == Units::mm;
    warn(motion_offset(), errors::kFeedFromOtherUnits,
         joined({"units changed: F", shortest(state_.feed_word), was_inch ? " in/min" : " mm/min",
                 " is now ", in_mm(*state_.feedrate_mm_s * 60.0 / mm_per_unit(state_.units)),
                 was_inch ? " mm/min" : " in/min"}));
  }
  feedrate_mm_s = *state_.feedrate_mm_s;
  return true;
}

}  // namespace kerf::parser
