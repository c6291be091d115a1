#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/modal/end_point.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

// G51.1 mirrors each axis that has a word about the coordinate it names; G50.1 ends that for the
// axes that have a word, or for all. As on the control the mirror is around scaling and turn.
Done mirror_program(const RunningBlock& at, ModalState& state) {
  if (state.coordinates.scaled_or_turned()) {
    return fail(at.code_word(Group::mirror).offset, errors::kMirrorUnderShape,
                joined({at.name_of(Group::mirror),
                        " cannot be used while G51 or G68 is active: write G69 and G50 first"}));
  }
  if (Done fine = refuse_auxiliary(at, joined({"with ", at.name_of(Group::mirror)})); !fine) {
    return fine;
  }
  const bool ends = at.codes[Group::mirror] == 501;
  if (Done given = needs_axis_words(at); !ends && !given) {
    return given;
  }
  const Point here = state.coordinates.to_program(state.position_mm);
  const Point words = axis_words_mm(at.block, state.units);
  Mirror mirror = state.coordinates.mirror();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.block.has(axis_letter(axis))) {
      mirror.mirrored[axis] = !ends;
      mirror.about_mm[axis] = ends ? 0.0 : words[axis] + (state.incremental ? here[axis] : 0.0);
    }
  }
  state.coordinates.set_mirror(at.block.has_any(kAxisLetters) ? mirror : Mirror{});
  return {};
}

// A factor without a decimal point counts in thousandths, as on the control: P2000 is 2.
Expected<double> scale_factor(const BlockWords& block, const Word& word) {
  const bool thousandths = block.text(word).find_first_of(".[#") == std::string_view::npos;
  const double factor = word.value * (thousandths ? 0.001 : 1.0);
  constexpr double kMin = 1e-5;
  constexpr double kMax = 1000.0;
  if (factor == 0.0) {
    return fail(word.offset, errors::kScaleZero, "G51: scale must not be 0");
  }
  if (!(std::fabs(factor) >= kMin && std::fabs(factor) <= kMax)) {
    return fail(word.offset, errors::kScaleZero,
                joined({"G51: a scale of ", shortest(factor), " is outside 0.00001..1000"}));
  }
  return factor;
}

// G51 X Y Z P, or I J K for one factor an axis. Axes without a word have the tool's place as
// centre; without any factor nothing is scaled.
Done scale_program(const RunningBlock& at, ModalState& state) {
  if (Done fine = refuse_auxiliary(at, "with G51"); !fine) {
    return fine;
  }
  const Point here = state.coordinates.to_program(state.position_mm);
  const Point words = axis_words_mm(at.block, state.units);
  Scaling scaling;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool given = at.block.has(axis_letter(axis));
    scaling.centre_mm[axis] =
        !given ? here[axis] : words[axis] + (state.incremental ? here[axis] : 0.0);
  }
  Expected<double> all = at.block.has('P') ? scale_factor(at.block, at.block.word('P')) : 1.0;
  if (!all) {
    return fault_of(all);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = centre_letter(axis);
    Expected<double> factor =
        at.block.has(letter) ? scale_factor(at.block, at.block.word(letter)) : *all;
    if (!factor) {
      return fault_of(factor);
    }
    scaling.factor[axis] = *factor;
  }
  state.coordinates.set_scaling(scaling);
  return {};
}

// G68 X Y R; with G91 the angle counts from the one before. Under G51 the centre is scaled, too
// [FANUC 30i user's manual B-63944EN-2, scaling and coordinate system rotation].
Done turn_program(const RunningBlock& at, ModalState& state) {
  const Word& code = at.code_word(Group::program_turn);
  if (!at.block.has('R')) {
    return fail(code.offset, errors::kTurnWithoutAngle, "G68 needs R");
  }
  if (Done fine = refuse_auxiliary(at, "with G68"); !fine) {
    return fine;
  }
  if (state.plane != Plane::xy) {
    return fail(code.offset, errors::kTurnPlane, "G68 works only in the XY plane (G17)");
  }
  const Point here = state.coordinates.to_program(state.position_mm);
  const Point words = axis_words_mm(at.block, state.units);
  const bool adds = state.incremental;
  ProgramTurn turn;
  turn.angle_deg = at.block.value('R') + (adds ? state.coordinates.program_turn().angle_deg : 0.0);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const bool given = at.block.has(axis_letter(axis));
    const double centre = !given ? here[axis] : words[axis] + (adds ? here[axis] : 0.0);
    turn.centre_mm[axis] = state.coordinates.scaling().scaled(axis, centre);
  }
  state.coordinates.set_program_turn(turn);
  return {};
}

}  // namespace

Done select_extended_offset(const RunningBlock& at, ModalState& state) {
  const Word& code = at.code_word(Group::work_offset);
  if (!at.block.has('P')) {
    return fail(code.offset, errors::kExtendedOffsetNumber, "G54.1 needs P");
  }
  const Word& word = at.block.word('P');
  constexpr double kMax = Coordinates::kExtended;
  if (word.value != std::floor(word.value) || word.value < 1.0 || word.value > kMax) {
    return fail(word.offset, errors::kExtendedOffsetNumber,
                joined({"G54.1: P must be 1 to 300, found ", shortest(word.value)}));
  }
  state.coordinates.select(Coordinates::kSystems + static_cast<std::size_t>(word.value) - 1);
  return {};
}

Done shape_program(const RunningBlock& at, ModalState& state) {
  if (at.codes[Group::scaling] == 500) {
    state.coordinates.set_scaling({});
  }
  if (at.codes[Group::program_turn] == 690) {
    state.coordinates.set_program_turn({});
  }
  Done done = at.codes.has(Group::mirror) ? mirror_program(at, state) : Done();
  if (done && at.codes[Group::scaling] == 510) {
    done = scale_program(at, state);
  }
  if (done && at.codes[Group::program_turn] == 680) {
    done = turn_program(at, state);
  }
  return done;
}

}  // namespace kerf::parser
