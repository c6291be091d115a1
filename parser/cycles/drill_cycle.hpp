// The canned cycles as what they do: straight moves, dwells and the spindle, as LinuxCNC 2.9 does
// them and [NISTIR 6556, 3.5.16] describes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "parser/block/block.hpp"
#include "parser/dialects/dialect_rules.hpp"
#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

// A drilling axis has three heights, in the program's coordinates.
struct DrillLevels {
  double initial_mm = 0.0;    // where the tool was before the series of cycles began
  double clearance_mm = 0.0;  // R: feed begins here
  double bottom_mm = 0.0;     // Z; not above clearance
};

struct DrillCycle {
  Motion kind = Motion::drill;  // one of the cycles
  Plane plane = Plane::xy;      // its normal is the drilling axis
  DrillLevels levels;
  bool to_initial = false;  // G98: ends at the initial level, where that is above clearance
  Point hole_mm{};          // the first hole, in the program's coordinates; not its height
  Point between_mm{};       // from a hole to the next
  std::uint32_t holes = 1;
  double peck_mm = 0.0;     // Q > 0 of G73 and G83
  double dwell_s = 0.0;     // P at the bottom
  Point aside_mm{};         // of G87: how far the tool steps aside in the plane
  double counter_mm = 0.0;  // of G87: how far up the tool bores
};

enum class StepKind : std::uint8_t {
  rapid,
  feed,
  dwell,
  spindle_off,
  spindle_on,      // as it turned before the cycle
  spindle_turned,  // the other way round
  spindle_orient,
  program_stop,
};

struct CycleStep {
  StepKind kind = StepKind::rapid;
  Point end_mm{};  // of rapid and feed, in the program's coordinates
  double duration_s = 0.0;
};

// How far above the last depth the next rapid of G73 and G83 ends, as LinuxCNC has it.
inline constexpr double kChipGap_mm = 0.254;

// Letters that the cycle takes beside the axes: R, L and its own.
Letters letters_of_cycle(Motion motion, const DialectRules& rules);

// How often G73 and G83 feed for one hole; 1 for the other cycles.
double feeds_of(const DrillCycle& cycle);

// The steps from `from_mm` on, in order. Moves of no length are left out, but not those that
// rounding alone gives a length: what is too short to be a move is decided where moves leave the
// reader (short_moves.hpp).
void expand(const DrillCycle& cycle, const Point& from_mm, std::vector<CycleStep>& steps);

}  // namespace kerf::parser
