// G73, G74, G81 to G89: what the words of a block, with those of the blocks before, ask for.
#include <cmath>

#include "diagnostics/errors/cycles.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/moves/arc_geometry.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kMostSteps = 200'000.0;
constexpr double kStepsPerHole = 14.0;  // of G87, the longest but for pecks

bool needs_peck(Motion motion) {
  return motion == Motion::peck || motion == Motion::chip_breaking;
}

bool needs_dwell(Motion motion) {
  return motion == Motion::drill_with_dwell || motion == Motion::bore_with_stop ||
         motion == Motion::bore_by_hand || motion == Motion::bore_with_dwell;
}

}  // namespace

// The block's words join those that hold from before; what is then still missing is an error, said
// once and not again for each block behind it.
bool Interpreter::take_cycle_words() {
  CycleWords& words = state_.cycle.words;
  const double unit = mm_per_unit(state_.units);
  const char up = axis_letter(axes_of(state_.plane).normal);
  const auto take = [this](char letter, double factor, std::optional<double>& word) {
    if (block_->has(letter)) {
      word = block_->value(letter) * factor;
    }
  };
  take('R', unit, words.clearance_mm);
  take(up, unit, words.bottom_mm);
  take('Q', unit, words.peck_mm);
  take('P', dialect_ == Dialect::fanuc ? 0.001 : 1.0, words.dwell_s);
  for (std::size_t axis = 0; axis < 3 && state_.motion == Motion::back_bore; ++axis) {
    take(centre_letter(axis), unit, words.offset_mm[axis]);
  }
  const auto missing = [this](std::optional<double>& word, const diagnostics::ErrorPage& page,
                              char letter, double assumed) {
    word = assumed;
    return fail(motion_offset(), page, joined({motion_name(), " needs ", named(letter)}));
  };
  if (!words.clearance_mm) {
    return missing(words.clearance_mm, errors::kCycleWithoutClearance, 'R', 0.0);
  }
  if (!words.bottom_mm) {
    return missing(words.bottom_mm, errors::kCycleWithoutBottom, up, *words.clearance_mm);
  }
  if (needs_peck(state_.motion) && !words.peck_mm) {
    return missing(words.peck_mm, errors::kCycleWithoutPeck, 'Q', 1.0);
  }
  if (needs_dwell(state_.motion) && !words.dwell_s && dialect_ == Dialect::rs274) {
    return missing(words.dwell_s, errors::kCycleWithoutDwell, 'P', 0.0);
  }
  return true;
}

bool Interpreter::read_cycle(DrillCycle& cycle) {
  CycleWords& words = state_.cycle.words;
  cycle.kind = state_.motion;
  cycle.to_initial = state_.to_initial_level;
  if (needs_peck(cycle.kind)) {
    cycle.peck_mm = *words.peck_mm;
    if (!(cycle.peck_mm > 0.0)) {
      words.peck_mm = 1.0;
      return fail(block_->has('Q') ? block_->word('Q').offset : motion_offset(),
                  errors::kCyclePeckNotPositive,
                  joined({motion_name(), ": Q must be greater than 0"}));
    }
  }
  const bool dwells = needs_dwell(cycle.kind) || cycle.kind == Motion::tap ||
                      cycle.kind == Motion::tap_left ||
                      (dialect_ == Dialect::fanuc && needs_peck(cycle.kind));
  cycle.dwell_s = dwells ? words.dwell_s.value_or(0.0) : 0.0;
  if (cycle.dwell_s < 0.0) {
    words.dwell_s = 0.0;
    return fail(block_->has('P') ? block_->word('P').offset : motion_offset(),
                errors::kCycleNegativeDwell, joined({motion_name(), ": P must not be negative"}));
  }
  return set_cycle_levels(cycle) && set_back_bore(cycle) && set_cycle_repeats(cycle);
}

bool Interpreter::set_cycle_levels(DrillCycle& cycle) {
  CycleState& memory = state_.cycle;
  const std::size_t up = axes_of(cycle.plane).normal;
  if (!memory.in_series) {
    memory.in_series = true;
    memory.initial_mm = cycle.hole_mm[up];
  }
  DrillLevels& levels = cycle.levels;
  levels.initial_mm = memory.initial_mm;
  CycleWords& words = memory.words;
  if (dialect_ == Dialect::rs274 || block_->has('R')) {
    words.clearance_adds = state_.incremental;
  }
  if (dialect_ == Dialect::rs274 || block_->has(axis_letter(up))) {
    words.bottom_adds = state_.incremental;
  }
  levels.clearance_mm = *words.clearance_mm + (words.clearance_adds ? levels.initial_mm : 0.0);
  levels.bottom_mm = *words.bottom_mm + (words.bottom_adds ? levels.clearance_mm : 0.0);
  if (levels.clearance_mm < levels.bottom_mm) {
    const char letter = axis_letter(up);
    const double unit = mm_per_unit(state_.units);
    words.bottom_mm = words.bottom_adds ? 0.0 : levels.clearance_mm;
    return fail(block_->has(letter) ? block_->word(letter).offset : motion_offset(),
                errors::kCycleClearanceBelowBottom,
                joined({motion_name(), ": R (", in_mm(levels.clearance_mm / unit), ") is below ",
                        named(letter), " (", in_mm(levels.bottom_mm / unit), ")"}));
  }
  return true;
}

// I, J and K: two of them are the way aside in the plane, that of the drilling axis is where the
// boring upwards ends; with G91 it is counted from the bottom.
bool Interpreter::set_back_bore(DrillCycle& cycle) {
  if (cycle.kind != Motion::back_bore) {
    return true;
  }
  CycleWords& words = state_.cycle.words;
  const std::size_t up = axes_of(cycle.plane).normal;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!words.offset_mm[axis]) {
      words.offset_mm[axis] = 0.0;
      return fail(motion_offset(), errors::kBackBoreWordMissing,
                  joined({"G87 needs ", named(centre_letter(axis))}));
    }
    cycle.aside_mm[axis] = axis == up ? 0.0 : *words.offset_mm[axis];
  }
  cycle.counter_mm = *words.offset_mm[up] + (state_.incremental ? cycle.levels.bottom_mm : 0.0);
  return true;
}

bool Interpreter::set_cycle_repeats(DrillCycle& cycle) {
  const double unit = mm_per_unit(state_.units);
  const std::size_t up = axes_of(cycle.plane).normal;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = axis_letter(axis);
    if (axis == up || !block_->has(letter)) {
      continue;
    }
    const double value = block_->value(letter) * unit;
    cycle.hole_mm[axis] = value + (state_.incremental ? cycle.hole_mm[axis] : 0.0);
    cycle.between_mm[axis] = state_.incremental ? value : 0.0;
  }
  const char letter = dialect_ == Dialect::fanuc && block_->has('K') ? 'K' : 'L';
  const double holes = block_->value_or(letter, 1.0);
  const std::string name = joined({motion_name(), " ", named(letter)});
  if (!(holes >= 0.0) || holes != std::floor(holes)) {
    return fail(
        block_->word(letter).offset, errors::kCycleRepeats,
        joined({name, " (repeats) must be a whole number, 1 or more, found ", shortest(holes)}));
  }
  const double moves = holes * (kStepsPerHole + 3.0 * feeds_of(cycle));
  if (!(moves <= kMostSteps)) {
    return fail(motion_offset(), errors::kCycleTooLong,
                joined({motion_name(), ": the block makes more than 200000 moves"}));
  }
  if (holes == 0.0 && dialect_ == Dialect::rs274) {
    warn(block_->word(letter).offset, errors::kCycleZeroRepeats,
         joined({name, "0: nothing is drilled"}));
  }
  cycle.holes = static_cast<std::uint32_t>(holes);
  return true;
}

}  // namespace kerf::parser
