#include "parser/interpreter/feed.hpp"

#include "diagnostics/errors/pages.hpp"
#include "parser/spindle_io/spindle.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLargestFeed = 1e9;

Expected<double> inverse_time_feedrate(const RunningBlock& at, double length_mm) {
  if (!at.block.has('F')) {
    return fail(at.motion_offset(), errors::kInverseTimeWithoutFeed,
                "G93 is active: F is needed in every cutting block");
  }
  if (at.block.value('F') == 0.0) {
    return fail(at.block.word('F').offset, errors::kInverseTimeZeroFeed,
                "F must be greater than 0 with G93");
  }
  return feedrate_mm_s_from(InverseTime{length_mm, at.block.value('F')});
}

}  // namespace

void set_units(ModalState& state, Units units) {
  state.feed_from_other_units = state.feed_from_other_units != (units != state.units);
  state.units = units;
}

void Feed::set_mode(ModalState& state, FeedMode mode) {
  if (mode != state.feed_mode) {
    state.feed_mode = mode;
    state.feedrate_mm_s.reset();
    state.feed_per_revolution_mm.reset();
    stopped_spindle_reported_ = false;
  }
}

Done set_feed(const RunningBlock& at, ModalState& state) {
  if (!at.block.has('F')) {
    return {};
  }
  const Word& word = at.block.word('F');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeFeed, "F must not be negative");
  }
  if (word.value > kLargestFeed) {
    return fail(
        word.offset, errors::kFeedOutOfRange,
        joined({"F: value ", upper(at.block.text(word).substr(1, 40)), " is out of range"}));
  }
  state.feed_word = word.value;
  state.feed_from_other_units = false;
  if (state.feed_mode == FeedMode::per_minute) {
    state.feedrate_mm_s = feedrate_mm_s_from(word.value, state.units);
  } else if (state.feed_mode == FeedMode::per_revolution) {
    state.feed_per_revolution_mm = word.value * mm_per_unit(state.units);
  }
  return {};
}

// G95. A spindle that stands would never feed; the speed that S gives is taken instead, since the
// spindle may be one that the operator switches on.
Expected<double> Feed::per_revolution(const RunningBlock& at, const ModalState& state) {
  const double per_min = spindle_per_min(state);
  if (*state.feed_per_revolution_mm == 0.0) {
    return fail(at.block.has('F') ? at.block.word('F').offset : at.motion_offset(),
                errors::kZeroFeed,
                joined({"feed is zero: ", motion_name(state), " needs F greater than 0"}));
  }
  if (per_min == 0.0) {
    return fail(at.motion_offset(), errors::kNoSpeedForFeed,
                "G95 is active: feed per revolution needs a spindle speed (S)");
  }
  if (state.spindle == Spindle::off && !stopped_spindle_reported_) {
    stopped_spindle_reported_ = true;
    at.warn(at.motion_offset(), errors::kFeedOfStoppedSpindle,
            joined({"G95 with the spindle stopped: the feed of S", shortest(state.spindle_speed),
                    " is taken"}));
  }
  return *state.feed_per_revolution_mm * per_min / 60.0;
}

Expected<double> Feed::worked_out(const RunningBlock& at, ModalState& state, double length_mm) {
  if (state.feed_mode == FeedMode::inverse_time) {
    return inverse_time_feedrate(at, length_mm);
  }
  if (state.feed_mode == FeedMode::per_revolution && state.feed_per_revolution_mm) {
    return per_revolution(at, state);
  }
  if (!state.feedrate_mm_s) {
    if (!no_feed_reported_) {
      no_feed_reported_ = true;
      return fail(at.motion_offset(), errors::kNoFeed,
                  joined({"no feed set: ", motion_name(state), " needs F"}));
    }
    return 1.0;
  }
  if (*state.feedrate_mm_s == 0.0) {
    return fail(at.block.has('F') ? at.block.word('F').offset : at.motion_offset(),
                errors::kZeroFeed,
                joined({"feed is zero: ", motion_name(state), " needs F greater than 0"}));
  }
  if (state.feed_from_other_units) {
    state.feed_from_other_units = false;
    const bool was_inch = state.units == Units::mm;
    at.warn(at.motion_offset(), errors::kFeedFromOtherUnits,
            joined({"units changed: F", shortest(state.feed_word), was_inch ? " in/min" : " mm/min",
                    " is now ", in_mm(*state.feedrate_mm_s * 60.0 / mm_per_unit(state.units)),
                    was_inch ? " mm/min" : " in/min"}));
  }
  return *state.feedrate_mm_s;
}

Expected<double> Feed::auxiliary_axes(const RunningBlock& at, ModalState& state,
                                      const AuxiliaryMove& way) {
  Expected<double> feedrate = cutting(at, state, way.length_rad_mm());
  // No F was ever read: that was said, and the feedrate is any.
  const bool assumed = state.feed_word == 0.0;
  if (!feedrate || !way.only_turns() || state.feed_mode == FeedMode::inverse_time || assumed) {
    return feedrate;
  }
  const double per_word =
      state.feed_mode == FeedMode::per_revolution && state.feed_per_revolution_mm
          ? *feedrate * 60.0 / *state.feed_per_revolution_mm  // turns of the spindle
          : 1.0;
  return feedrate_rad_s_from(state.feed_word * per_word);
}

}  // namespace kerf::parser
