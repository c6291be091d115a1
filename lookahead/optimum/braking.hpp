// The shortest way to rest from a motion.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"
#include "profiles/cell_law.hpp"
#include "profiles/s_curve_stop.hpp"
#include "profiles/time_law.hpp"

namespace kerf::lookahead {

// A motion on the first of some blocks that follow each other; none: it is at the end of the last,
// about to rest.
struct BrakingFrom {
  std::vector<const Block*> blocks;
  const Block* before = nullptr;  // the one before them; null: there is a rest between
  double s_mm = 0.0;              // on the first
  StartState state{};             // v > 0
  // Where the plan so far changes its jerk: it is one of those that are looked for.
  struct Place {
    std::size_t block = 0;
    double s_mm = 0.0;
  };
  std::vector<Place> ends{};
};

// The way after a junction on which its jump is seen.
inline double junction_zone_mm(const StartState& motion, const PlanLimits& limits) {
  constexpr double kTicks = 4.0;
  return kTicks * limits.period_s * motion.v_mm_s;
}

// A rest so near the end of a block is at its end: what would be left is hardly a curve.
inline constexpr double kAtBlockEnd_mm = 1e-6;

// A part of the way to rest.
struct BrakingPart {
  std::size_t block = 0;  // of BrakingFrom::blocks
  profiles::TimeLaw law{};
  double s_end_mm = 0.0;  // on the block
  bool ends_block = false;
  Constraint limit{};
};

// A part of the way to rest that does not end with blocks.
struct BrakingLaw {
  profiles::CellLaw law{};
  bool is_steady = false;  // its acceleration is constant; else it rides on the jerk
};

// Of the way to rest that the laws are, one after the other from the motion on. Nothing: they leave
// the blocks, or rest so near the end of one that what would be left is hardly a curve.
std::optional<std::vector<BrakingPart>> parts_of(std::span<const BrakingLaw> laws,
                                                 const BrakingFrom& from);
std::array<BrakingLaw, 3> laws_of(const profiles::SCurveStop& stop);

// Asked between the tries of a search. True: a shorter way would come too late.
using IsLate = std::function<bool()>;
inline bool never_late() {
  return false;
}

// On a line alone, the S-curve from any acceleration to rest, in closed form. Elsewhere the
// shortest that is found in time of that S-curve, laid over the blocks, of steps, and of time
// optima to rests at distances between; over more than some hundred cells of the first two alone.
// Nothing: no way was found; from a place farther on there may be one, as where the plan already
// lands.
std::optional<std::vector<BrakingPart>> find_braking(const BrakingFrom& from,
                                                     const PlanLimits& limits,
                                                     const IsLate& is_late = never_late);

// Any way from any of the motions, for it is cheap: on a line as above, else one S-curve, or the
// optimum to a rest at one distance, far enough that there is a way in most cases. Where there is
// none, a try costs several times what one costs that ends well: other motions come before other
// distances.
struct FoundBraking {
  std::size_t motion = 0;
  std::vector<BrakingPart> parts;
};
std::optional<FoundBraking> find_any_braking(const std::vector<BrakingFrom>& motions,
                                             const PlanLimits& limits);

}  // namespace kerf::lookahead
