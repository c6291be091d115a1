// Fanuc: G54.1, G50 and G51, G50.1 and G51.1, G68 and G69.
#include <cmath>

#include "diagnostics/errors/shape.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

bool Interpreter::select_extended_offset() {
  const Word& code = code_word(*block_, codes_, Group::work_offset);
  if (!block_->has('P')) {
    return fail(code.offset, errors::kExtendedOffsetNumber, "G54.1 needs P");
  }
  const Word& word = block_->word('P');
  constexpr double kMost = Coordinates::kExtended;
  if (word.value != std::floor(word.value) || word.value < 1.0 || word.value > kMost) {
    return fail(word.offset, errors::kExtendedOffsetNumber,
                joined({"G54.1: P must be 1 to 300, found ", shortest(word.value)}));
  }
  state_.coordinates.select(Coordinates::kSystems + static_cast<std::size_t>(word.value) - 1);
  return true;
}

bool Interpreter::shape_program() {
  if (codes_[Group::scaling] == 500) {
    state_.coordinates.set_scaling({});
  }
  if (codes_[Group::program_turn] == 690) {
    state_.coordinates.set_program_turn({});
  }
  return (!codes_.has(Group::mirror) || mirror_program()) &&
         (codes_[Group::scaling] != 510 || scale_program()) &&
         (codes_[Group::program_turn] != 680 || turn_program());
}

// G51.1 mirrors each axis that has a word about the coordinate it names; G50.1 ends that for the
// axes that have a word, or for all. As on the control the mirror is around scaling and turn.
bool Interpreter::mirror_program() {
  const Word& code = code_word(*block_, codes_, Group::mirror);
  if (state_.coordinates.scaled_or_turned()) {
    return fail(code.offset, errors::kMirrorUnderShape,
                joined({upper(block_->text(code)),
                        " cannot be used while G51 or G68 is active: write G69 and G50 first"}));
  }
  if (!refuse_extra(joined({"with ", upper(block_->text(code))}))) {
    return false;
  }
  const bool ends = codes_[Group::mirror] == 501;
  if (!ends && !needs_axis_words()) {
    return false;
  }
  const Point here = state_.coordinates.to_program(state_.position_mm);
  const Point words = axis_words_mm();
  Mirror mirror = state_.coordinates.mirror();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block_->has(axis_letter(axis))) {
      mirror.mirrored[axis] = !ends;
      mirror.about_mm[axis] = ends ? 0.0 : words[axis] + (state_.incremental ? here[axis] : 0.0);
    }
  }
  state_.coordinates.set_mirror(block_->has_any(kAxisLetters) ? mirror : Mirror{});
  return true;
}

// A factor without a decimal point counts in thousandths, as on the control: P2000 is 2.
bool Interpreter::scale_factor(char letter, double& factor) {
  if (!block_->has(letter)) {
    return true;
  }
  const Word& word = block_->word(letter);
  const bool thousandths = block_->text(word).find_first_of(".[#") == std::string_view::npos;
  factor = word.value * (thousandths ? 0.001 : 1.0);
  constexpr double kLeast = 1e-5;
  constexpr double kMost = 1000.0;
  if (factor == 0.0) {
    return fail(word.offset, errors::kScaleZero, "G51: scale must not be 0");
  }
  if (!(std::fabs(factor) >= kLeast && std::fabs(factor) <= kMost)) {
    return fail(word.offset, errors::kScaleZero,
                joined({"G51: a scale of ", shortest(factor), " is outside 0.00001..1000"}));
  }
  return true;
}

// G51 X Y Z P, or I J K for one factor an axis. Axes without a word have the tool's place as
// centre; without any factor nothing is scaled.
bool Interpreter::scale_program() {
  if (!refuse_extra("with G51")) {
    return false;
  }
  const Point here = state_.coordinates.to_program(state_.position_mm);
  const Point words = axis_words_mm();
  Scaling scaling;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool given = block_->has(axis_letter(axis));
    scaling.centre_mm[axis] =
        !given ? here[axis] : words[axis] + (state_.incremental ? here[axis] : 0.0);
  }
  double all = 1.0;
  if (!scale_factor('P', all)) {
    return false;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    scaling.factor[axis] = all;
    if (!scale_factor(centre_letter(axis), scaling.factor[axis])) {
      return false;
    }
  }
  state_.coordinates.set_scaling(scaling);
  return true;
}

// G68 X Y R; with G91 the angle counts from the one before. Under G51 the centre is scaled, too
// [FANUC 30i user's manual B-63944EN-2, scaling and coordinate system rotation].
bool Interpreter::turn_program() {
  const Word& code = code_word(*block_, codes_, Group::program_turn);
  if (!block_->has('R')) {
    return fail(code.offset, errors::kTurnWithoutAngle, "G68 needs R");
  }
  if (!refuse_extra("with G68")) {
    return false;
  }
  if (state_.plane != Plane::xy) {
    return fail(code.offset, errors::kTurnPlane, "G68 works only in the XY plane (G17)");
  }
  const Point here = state_.coordinates.to_program(state_.position_mm);
  const Point words = axis_words_mm();
  const bool adds = state_.incremental;
  ProgramTurn turn;
  turn.angle_deg = block_->value('R') + (adds ? state_.coordinates.program_turn().angle_deg : 0.0);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const bool given = block_->has(axis_letter(axis));
    const double centre = !given ? here[axis] : words[axis] + (adds ? here[axis] : 0.0);
    turn.centre_mm[axis] = state_.coordinates.scaling().scaled(axis, centre);
  }
  state_.coordinates.set_program_turn(turn);
  return true;
}

// G52 and G92 would have to say in which of the two systems they count.
bool Interpreter::check_unshaped() {
  if (!state_.coordinates.shaped()) {
    return true;
  }
  const Word& code = code_word(*block_, codes_, Group::other);
  return fail(
      code.offset, errors::kOffsetUnderShape,
      joined({upper(block_->text(code)), " cannot be used while G51, G51.1 or G68 is active"}));
}

}  // namespace kerf::parser
