// How a place where direction or curvature jumps shares the axes' limits with the motion around it.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/junction.hpp"
#include "lookahead/optimum/cell.hpp"

namespace kerf::lookahead {

// A third difference of positions that sees a jump adds up three things, each of which gets its
// share of the axes' limits: the jump at constant feedrate (junction.hpp), the acceleration along
// the path, which turns with the direction (3/4 a |du| / Ts <= its share of J), and what the cells
// within three ticks' way ask for.

// The limits with the share of the jump itself.
PlanLimits jump_limits(const PlanLimits& limits);

// How a joint may be passed.
struct Joint {
  Junction passing{.feedrate_mm_s = 0.0};  // a stop, unless said otherwise
  double acceleration_mm_s2 = kUnbounded;

  [[nodiscard]] bool is_stop() const noexcept { return passing.feedrate_mm_s == 0.0; }
  // Nothing jumps there.
  [[nodiscard]] bool is_smooth() const noexcept { return !is_stop() && passing.coast_s == 0.0; }
};

Joint joint_of(const JunctionQuery& query, const PlanLimits& limits);

// A boundary of cells, the one before cells[boundary] (0 and the count of cells are the ends), that
// is passed although something jumps there.
struct PassedJump {
  std::size_t boundary = 0;
  double feedrate_mm_s = 0.0;
  double acceleration_mm_s2 = kUnbounded;
};

// Caps feedrate and acceleration there, and leaves the cells around it their share.
void share_limits(std::vector<Cell>& cells, const PassedJump& jump, const PlanLimits& limits);

}  // namespace kerf::lookahead
