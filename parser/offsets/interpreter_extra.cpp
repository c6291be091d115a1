// A, B, C, U, V and W, where the machine file names them.
#include <cmath>

#include "diagnostics/errors/blocks.hpp"
#include "diagnostics/errors/motion.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/moves/short_moves.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG53 = 530;

}  // namespace

// Where the block's words send the extra axes, on the machine; those without a word stay.
bool Interpreter::resolve_extra(ExtraWords& end_deg_mm) {
  end_deg_mm = state_.extra_deg_mm;
  if (!block_->has_any(machine_.extra_axes)) {
    return true;
  }
  if (compensation_.busy()) {
    return refuse_extra(compensation_.on() ? "while G41/G42 is active"
                                           : "in the move that ends G41/G42");
  }
  ExtraWords words{};
  for (std::size_t axis = 0; axis < kExtraAxes; ++axis) {
    words[axis] =
        block_->has(kExtraNames[axis]) ? extra_word_deg_mm(*block_, axis, state_.units) : 0.0;
  }
  const bool on_machine = state_.incremental || codes_[Group::other] == kG53;
  const ExtraWords target = on_machine ? words : state_.coordinates.extra_to_machine(words);
  for (std::size_t axis = 0; axis < kExtraAxes; ++axis) {
    if (!block_->has(kExtraNames[axis])) {
      continue;
    }
    end_deg_mm[axis] =
        state_.incremental ? sum_of_decimals(end_deg_mm[axis], target[axis]) : target[axis];
    if (!(std::fabs(end_deg_mm[axis]) <= kLargestCoordinate_mm)) {
      const Word& word = block_->word(kExtraNames[axis]);
      return fail(
          word.offset, errors::kPositionOutOfRange,
          joined({named(kExtraNames[axis]), ": ", upper(block_->text(word).substr(1, 40)),
                  " leads outside -999999.999..999999.999", turns(axis) ? " degrees" : " mm"}));
    }
  }
  return true;
}

// False, with the fault: the block has a word of an extra axis. `where`: "with G5".
bool Interpreter::refuse_extra(std::string_view where) {
  const Word* const word = leftmost(*block_, machine_.extra_axes);
  return word == nullptr ||
         fail(word->offset, errors::kExtraAxisHere,
              joined({named(letter_of(*block_, *word)), " cannot be used ", where}));
}

// The move takes the extra axes there.
void Interpreter::carry_extra(Move& move, const ExtraWords& end_deg_mm) {
  if (machine_.extra_axes != 0) {
    move.extra = extra_way(state_.extra_deg_mm, end_deg_mm);
    state_.extra_deg_mm = end_deg_mm;
  }
}

// G10 L2, or L20 where the place of the axes gets the coordinates of the words.
void Interpreter::set_extra_origin(WorkOffset& offset, bool from_position) const {
  const bool adds = dialect_ == Dialect::fanuc && state_.incremental && !from_position;
  for (std::size_t axis = 0; axis < kExtraAxes; ++axis) {
    if (!block_->has(kExtraNames[axis])) {
      continue;
    }
    double& origin = offset.extra_deg_mm[axis];
    const double word = extra_word_deg_mm(*block_, axis, state_.units);
    origin = from_position
                 ? state_.extra_deg_mm[axis] - state_.coordinates.local_extra_deg_mm()[axis] - word
                 : word + (adds ? origin : 0.0);
  }
}

// F is along X, Y and Z where one of them moves.
bool Interpreter::straight_move_with_extra(const Point& end_mm) {
  ExtraWords extra_end;
  if (!resolve_extra(extra_end)) {
    return false;
  }
  const Point& from = state_.position_mm;
  const double distance_mm =
      std::hypot(end_mm[0] - from[0], end_mm[1] - from[1], end_mm[2] - from[2]);
  const ExtraWay extra = extra_way(state_.extra_deg_mm, extra_end);
  const bool alone = extra.moves() && distance_mm < kShortestWay_mm;
  const bool rapid = state_.motion == Motion::rapid;
  double feedrate_mm_s = 0.0;
  if (!rapid && !(alone ? extra_feedrate(extra, feedrate_mm_s)
                        : cutting_feedrate(distance_mm, feedrate_mm_s))) {
    return false;
  }
  if (end_mm == from && !extra.moves()) {
    return true;
  }
  Move& move = push_move();
  move.shape = LineMove{end_mm};
  move.rapid = rapid;
  move.feedrate_mm_s = feedrate_mm_s;
  carry_extra(move, extra_end);
  state_.position_mm = end_mm;
  return true;
}

// Along U, V and W where one of them moves, else along A, B and C: then F counts degrees.
bool Interpreter::extra_feedrate(const ExtraWay& alone, double& feedrate_mm_s) {
  if (!cutting_feedrate(alone.length_rad_mm(), feedrate_mm_s)) {
    return false;
  }
  // No F was ever read: that was said, and the feedrate is any.
  const bool assumed = state_.feed_word == 0.0;
  if (alone.only_turns() && state_.feed_mode != FeedMode::inverse_time && !assumed) {
    const double per_word =
        state_.feed_mode == FeedMode::per_revolution && state_.feed_per_revolution_mm
            ? feedrate_mm_s * 60.0 / *state_.feed_per_revolution_mm  // turns of the spindle
            : 1.0;
    feedrate_mm_s = feedrate_rad_s_from(state_.feed_word * per_word);
  }
  return true;
}

}  // namespace kerf::parser
