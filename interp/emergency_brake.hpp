// The fastest way to rest along the path, by the limits of acceleration alone.
#pragma once

#include <cstdint>

#include <kerf/axes.hpp>

#include "interp/motion_queue.hpp"

namespace kerf::interp {

// Brakes without a plan, so it works where planning is dead: each part of a tick takes the largest
// deceleration along the path that leaves every axis within its acceleration, curvature included.
// Where a bend lets none brake, it speeds up as little as they allow, and less than the plan. Jerk
// has no bound. Where the plan is within the same limits, the tool is never faster than planned, so
// the path that was handed over is long enough. It may pass over a rest of the plan by what a tick
// rounds, some micrometres.
class EmergencyBrake {
 public:
  EmergencyBrake(const MachineLimits& limits, double period_s) noexcept
      : limits_(limits), period_s_(period_s) {}

  struct Motion {
    CurvePiece piece{};
    double s_mm = 0.0;           // on its curve
    double path_begin_mm = 0.0;  // of all curves before
    double v_mm_s = 0.0;
    double a_mm_s2 = 0.0;
  };
  // One tick on. Takes the pieces that it passes from the queue.
  void advance(Motion& motion, MotionQueue& queue) const noexcept;

 private:
  [[nodiscard]] double deceleration_mm_s2(const Motion& motion) const noexcept;
  void step(Motion& motion, MotionQueue& queue, double step_s) const noexcept;
  static void follow_path(Motion& motion, MotionQueue& queue) noexcept;

  MachineLimits limits_;
  double period_s_;
};

}  // namespace kerf::interp
