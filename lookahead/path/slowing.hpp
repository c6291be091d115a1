// How a motion slows down to feedrates that are lower than it has: after an override.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/path/block.hpp"
#include "lookahead/path/feed_override.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "lookahead/path/limits.hpp"
#include "profiles/shape_value.hpp"

namespace kerf::lookahead {

// Towards each feedrate the S-curve from the motion to it, drawn out over a longer way where curves
// leave less than the limits along the path.
//
// It is a bound and no plan: what is planned below it keeps all limits by itself. A bound that
// falls as a stop does, straight down to the feedrate, would not do: a motion below it has to give
// up its deceleration before it is there, and dives under the feedrate.
class Slowing {
 public:
  // motion: v > 0. ramp: finite. to_rest_mm: the way to rest that was found from there.
  Slowing(const profiles::PathMotion& motion, const profiles::RampLimits& ramp, double to_rest_mm);

  // The highest feedrate so far behind the begin where to_mm_s > 0 is allowed there; to_mm_s at the
  // least.
  struct Ahead {
    double way_mm = 0.0;
    double to_mm_s = 0.0;
  };
  [[nodiscard]] double bound_mm_s(const Ahead& ahead) const;
  // How far behind the begin the bound is down to to_mm_s.
  [[nodiscard]] double way_mm(double to_mm_s) const;
  // Nowhere higher than this or to_mm_s.
  [[nodiscard]] double max_mm_s() const;

 private:
  profiles::PathMotion motion_;
  profiles::RampLimits ramp_;
  double stretch_ = 1.0;
};

// Sets the limits of the blocks to which the motion comes before it is as slow as they allow under
// the override, and nowhere more than a thousandth above what they allowed so far. Returns how many
// they are, at the front; none may be left out that the motion comes to on its way to rest.
// Precondition: v > 0.
struct SlowingOrder {
  profiles::PathMotion motion{};  // s: on the first block
  double to_rest_mm = 0.0;
  FeedOverride by{};
  ScanFor plan = ScanFor::bounded_jerk;
};
std::size_t let_slow_down(const SlowingOrder& order, const PlanLimits& limits,
                          const std::vector<Block*>& blocks);

}  // namespace kerf::lookahead
