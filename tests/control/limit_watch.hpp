// Every tick of a controller against the limits, whatever moves.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include <kerf/controller.hpp>

#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {

// By positions alone: the length of the way is summed here.
class LimitWatch {
 public:
  explicit LimitWatch(const MachineLimits& limits) : checker_(limits, true) {}

  void add(Setpoint setpoint) {
    double square = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double way_mm =
          is_first_ ? 0.0 : setpoint.position_mm[axis] - before_.position_mm[axis];
      square += way_mm * way_mm;
    }
    before_ = setpoint;
    is_first_ = false;
    way_mm_ += std::sqrt(square);
    setpoint.s_mm = way_mm_;
    checker_.add({.setpoint = setpoint, .feedrate_mm_s = std::numeric_limits<double>::infinity()});
  }
  [[nodiscard]] const std::string& complaint() const { return checker_.complaint(); }

 private:
  TickChecker checker_;
  Setpoint before_{};
  bool is_first_ = true;
  double way_mm_ = 0.0;
};

}  // namespace kerf::test
