// The path of a whole run, as later runs of the same program are to keep it.
#pragma once

#include <algorithm>
#include <vector>

#include "curves/position.hpp"
#include "interp/setpoint.hpp"

namespace kerf::test {

// How far a tick is from the path that the whole run has at its path length, at the least.
inline double off_path_mm(const std::vector<interp::Setpoint>& whole,
                          const interp::Setpoint& tick) {
  const auto after =
      std::lower_bound(whole.begin(), whole.end(), tick.s_mm,
                       [](const interp::Setpoint& a, double s) { return a.s_mm < s; });
  if (after == whole.end()) {
    return tick.s_mm - whole.back().s_mm;
  }
  return (curves::vec(after->position_mm) - curves::vec(tick.position_mm)).norm() -
         (after->s_mm - tick.s_mm);
}

}  // namespace kerf::test
