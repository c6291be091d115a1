#include "parser/cycles/canned_cycle.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/moves/arc_geometry.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kMaxSteps = 200'000.0;
constexpr double kStepsPerHole = 14.0;  // of G87, the longest but for pecks

bool needs_peck(Motion motion) {
  return motion == Motion::peck || motion == Motion::chip_breaking;
}

bool needs_dwell(Motion motion) {
  return motion == Motion::drill_with_dwell || motion == Motion::bore_with_stop ||
         motion == Motion::bore_by_hand || motion == Motion::bore_with_dwell;
}

Done check_cycle_spindle(const RunningBlock& at, const ModalState& state) {
  const Motion motion = state.motion;
  const char* wanted = nullptr;
  if (motion == Motion::tap && state.spindle != Spindle::clockwise) {
    wanted = " running clockwise (M3)";
  } else if (motion == Motion::tap_left && state.spindle != Spindle::counterclockwise) {
    wanted = " running counterclockwise (M4)";
  } else if (state.spindle == Spindle::off &&
             (motion == Motion::bore_with_stop || motion == Motion::bore_by_hand ||
              motion == Motion::back_bore)) {
    wanted = " running (M3 or M4)";
  }
  if (wanted == nullptr) {
    return {};
  }
  return fail(at.motion_offset(), errors::kCycleSpindle,
              joined({motion_name(state), " needs the spindle", wanted}));
}

Done check_cycle_modes(const RunningBlock& at, const ModalState& state, ContourPhase phase) {
  if (phase == ContourPhase::held) {
    return fail(at.motion_offset(), errors::kCycleWhileCompensating,
                joined({motion_name(state), " cannot be used while G41/G42 is active"}));
  }
  if (state.feed_mode == FeedMode::inverse_time) {
    return fail(at.motion_offset(), errors::kCycleInverseTime,
                joined({motion_name(state), " cannot be used with G93: write G94 or G95"}));
  }
  if (!at.rules.back_bore_aside && state.motion == Motion::back_bore) {
    return fail(at.motion_offset(), errors::kFanucBackBore,
                "G87 with Fanuc's words (Q: the shift) is not supported");
  }
  return check_cycle_spindle(at, state);
}

// The block's words join those that hold from before; what is then still missing is an error, said
// once and not again for each block after it.
Done take_cycle_words(const RunningBlock& at, ModalState& state) {
  CycleWords& words = state.cycle.words;
  const double unit = mm_per_unit(state.units);
  const char up = axis_letter(axes_of(state.plane).normal);
  const auto take = [&at](char letter, double factor, std::optional<double>& word) {
    if (at.block.has(letter)) {
      word = at.block.value(letter) * factor;
    }
  };
  take('R', unit, words.clearance_mm);
  take(up, unit, words.bottom_mm);
  take('Q', unit, words.peck_mm);
  take('P', at.rules.cycle_dwell_unit_s, words.dwell_s);
  for (std::size_t axis = 0; axis < 3 && state.motion == Motion::back_bore; ++axis) {
    take(centre_letter(axis), unit, words.offset_mm[axis]);
  }
  const auto missing = [&](std::optional<double>& word, double assumed,
                           const diagnostics::ErrorPage& page, char letter) -> Done {
    word = assumed;
    return fail(at.motion_offset(), page, joined({motion_name(state), " needs ", named(letter)}));
  };
  if (!words.clearance_mm) {
    return missing(words.clearance_mm, 0.0, errors::kCycleWithoutClearance, 'R');
  }
  if (!words.bottom_mm) {
    return missing(words.bottom_mm, *words.clearance_mm, errors::kCycleWithoutBottom, up);
  }
  if (needs_peck(state.motion) && !words.peck_mm) {
    return missing(words.peck_mm, 1.0, errors::kCycleWithoutPeck, 'Q');
  }
  if (needs_dwell(state.motion) && !words.dwell_s && !at.rules.cycle_dwell_optional) {
    return missing(words.dwell_s, 0.0, errors::kCycleWithoutDwell, 'P');
  }
  return {};
}

Done set_cycle_levels(const RunningBlock& at, ModalState& state, DrillCycle& cycle) {
  CycleState& memory = state.cycle;
  const std::size_t up = axes_of(cycle.plane).normal;
  if (!memory.in_series) {
    memory.in_series = true;
    memory.initial_mm = cycle.hole_mm[up];
  }
  DrillLevels& levels = cycle.levels;
  levels.initial_mm = memory.initial_mm;
  CycleWords& words = memory.words;
  if (!at.rules.levels_keep_mode || at.block.has('R')) {
    words.clearance_adds = state.incremental;
  }
  if (!at.rules.levels_keep_mode || at.block.has(axis_letter(up))) {
    words.bottom_adds = state.incremental;
  }
  levels.clearance_mm = *words.clearance_mm + (words.clearance_adds ? levels.initial_mm : 0.0);
  levels.bottom_mm = *words.bottom_mm + (words.bottom_adds ? levels.clearance_mm : 0.0);
  if (levels.clearance_mm < levels.bottom_mm) {
    const char letter = axis_letter(up);
    const double unit = mm_per_unit(state.units);
    words.bottom_mm = words.bottom_adds ? 0.0 : levels.clearance_mm;
    return fail(at.block.has(letter) ? at.block.word(letter).offset : at.motion_offset(),
                errors::kCycleClearanceBelowBottom,
                joined({motion_name(state), ": R (", in_mm(levels.clearance_mm / unit),
                        ") is below ", named(letter), " (", in_mm(levels.bottom_mm / unit), ")"}));
  }
  return {};
}

// I, J and K: two of them are the way aside in the plane, that of the drilling axis is where the
// boring upwards ends; with G91 it is counted from the bottom.
Done set_back_bore(const RunningBlock& at, ModalState& state, DrillCycle& cycle) {
  if (cycle.kind != Motion::back_bore) {
    return {};
  }
  CycleWords& words = state.cycle.words;
  const std::size_t up = axes_of(cycle.plane).normal;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!words.offset_mm[axis]) {
      words.offset_mm[axis] = 0.0;
      return fail(at.motion_offset(), errors::kBackBoreWordMissing,
                  joined({"G87 needs ", named(centre_letter(axis))}));
    }
    cycle.aside_mm[axis] = axis == up ? 0.0 : *words.offset_mm[axis];
  }
  cycle.counter_mm = *words.offset_mm[up] + (state.incremental ? cycle.levels.bottom_mm : 0.0);
  return {};
}

Done set_cycle_repeats(const RunningBlock& at, const ModalState& state, DrillCycle& cycle) {
  const double unit = mm_per_unit(state.units);
  const std::size_t up = axes_of(cycle.plane).normal;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = axis_letter(axis);
    if (axis == up || !at.block.has(letter)) {
      continue;
    }
    const double value = at.block.value(letter) * unit;
    cycle.hole_mm[axis] = value + (state.incremental ? cycle.hole_mm[axis] : 0.0);
    cycle.between_mm[axis] = state.incremental ? value : 0.0;
  }
  const char letter = at.rules.repeats_in_k && at.block.has('K') ? 'K' : 'L';
  const double holes = at.block.value_or(letter, 1.0);
  const std::string name = joined({motion_name(state), " ", named(letter)});
  if (!(holes >= 0.0) || holes != std::floor(holes)) {
    return fail(
        at.block.word(letter).offset, errors::kCycleRepeats,
        joined({name, " (repeats) must be a whole number, 1 or more, found ", shortest(holes)}));
  }
  const double moves = holes * (kStepsPerHole + 3.0 * feeds_of(cycle));
  if (!(moves <= kMaxSteps)) {
    return fail(at.motion_offset(), errors::kCycleTooLong,
                joined({motion_name(state), ": the block makes more than 200000 moves"}));
  }
  if (holes == 0.0 && !at.rules.repeats_in_k) {
    at.warn(at.block.word(letter).offset, errors::kCycleZeroRepeats,
            joined({name, "0: nothing is drilled"}));
  }
  cycle.holes = static_cast<std::uint32_t>(holes);
  return {};
}

Done set_up(const RunningBlock& at, ModalState& state, DrillCycle& cycle) {
  CycleWords& words = state.cycle.words;
  cycle.kind = state.motion;
  cycle.to_initial = state.to_initial_level;
  if (needs_peck(cycle.kind)) {
    cycle.peck_mm = *words.peck_mm;
    if (!(cycle.peck_mm > 0.0)) {
      words.peck_mm = 1.0;
      return fail(at.block.has('Q') ? at.block.word('Q').offset : at.motion_offset(),
                  errors::kCyclePeckNotPositive,
                  joined({motion_name(state), ": Q must be greater than 0"}));
    }
  }
  const bool dwells = needs_dwell(cycle.kind) || cycle.kind == Motion::tap ||
                      cycle.kind == Motion::tap_left ||
                      (at.rules.cycle_dwell_optional && needs_peck(cycle.kind));
  cycle.dwell_s = dwells ? words.dwell_s.value_or(0.0) : 0.0;
  if (cycle.dwell_s < 0.0) {
    words.dwell_s = 0.0;
    return fail(at.block.has('P') ? at.block.word('P').offset : at.motion_offset(),
                errors::kCycleNegativeDwell,
                joined({motion_name(state), ": P must not be negative"}));
  }
  return set_cycle_levels(at, state, cycle)
      .and_then([&] { return set_back_bore(at, state, cycle); })
      .and_then([&] { return set_cycle_repeats(at, state, cycle); });
}

}  // namespace

Expected<std::optional<DrillCycle>> read_cycle(const RunningBlock& at, ModalState& state,
                                               ContourPhase phase) {
  const bool by_r = at.rules.r_alone_drills && at.block.has('R');
  if (Done fine = refuse_auxiliary(at, "in a canned cycle"); !fine) {
    return fault_of(fine);
  }
  if (!at.block.has_any(kAxisLetters) && !by_r) {
    if (!at.codes.has(Group::motion) && !at.block.has_any(letters('R', 'I', 'J', 'K'))) {
      return std::nullopt;
    }
    return fail(at.motion_offset(), errors::kCycleWithoutAxis,
                joined({motion_name(state), " needs at least one axis word"}));
  }
  Done ready =
      check_cycle_modes(at, state, phase).and_then([&] { return take_cycle_words(at, state); });
  if (!ready) {
    return fault_of(ready);
  }
  DrillCycle cycle;
  cycle.plane = state.plane;
  cycle.hole_mm = state.coordinates.to_program(state.position_mm);
  if (Done done = set_up(at, state, cycle); !done) {
    return fault_of(done);
  }
  if (cycle.holes == 0) {
    return std::nullopt;
  }
  return cycle;
}

Done expand_on_machine(const RunningBlock& at, const ModalState& state, const DrillCycle& cycle,
                       std::vector<CycleStep>& steps) {
  steps.clear();
  expand(cycle, state.coordinates.to_program(state.position_mm), steps);
  for (CycleStep& step : steps) {
    step.end_mm = state.coordinates.to_machine(step.end_mm);
    for (const double coordinate : step.end_mm) {
      if (!(std::fabs(coordinate) <= kLargestCoordinate_mm)) {
        return fail(at.motion_offset(), errors::kPositionOutOfRange,
                    joined({motion_name(state), " leads outside -999999.999..999999.999 mm"}));
      }
    }
  }
  return {};
}

}  // namespace kerf::parser
