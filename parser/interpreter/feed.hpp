// F: what it says under G93, G94 and G95, for lengths and for turns.
#pragma once

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

void set_units(ModalState& state, Units units);
Done set_feed(const RunningBlock& at, ModalState& state);

// Reports a missing F or S once.
class Feed {
 public:
  // A change of the feed mode forgets the persistent F [NISTIR 6556, 3.5.19].
  void set_mode(ModalState& state, FeedMode mode);
  void spindle_started() { stopped_spindle_reported_ = false; }

  // The feedrate of a cutting move of this block; `length_mm` is what G93 divides by the time.
  Expected<double> cutting(const RunningBlock& at, ModalState& state, double length_mm) {
    const bool plain = state.feed_mode == FeedMode::per_minute && !state.feed_from_other_units;
    return plain && state.feedrate_mm_s.value_or(0.0) > 0.0 ? *state.feedrate_mm_s
                                                            : worked_out(at, state, length_mm);
  }
  // Of a move of the auxiliary axes alone: along U, V and W where one of them moves, else along A,
  // B and C: then F counts degrees.
  Expected<double> auxiliary_axes(const RunningBlock& at, ModalState& state,
                                  const AuxiliaryMove& way);

 private:
  Expected<double> worked_out(const RunningBlock& at, ModalState& state, double length_mm);
  Expected<double> per_revolution(const RunningBlock& at, const ModalState& state);

  bool no_feed_reported_ = false;
  bool stopped_spindle_reported_ = false;
};

}  // namespace kerf::parser
