// A curve as the papers run it: from the feedrate that it allows at its begin to that at its end.
#pragma once

#include <string>
#include <vector>

#include "bench/curve_run.hpp"

namespace kerf::bench {

// The planner begins and ends at rest. So the tool comes in along the circle of the curve's
// curvature at its begin and leaves along that at its end; only the curve counts. It has a speed
// there as the chord error allows, on the circle as on the curve.
struct MotionRun {
  lookahead::Block block;
  double time_s = 0.0;    // of the plan
  std::size_t ticks = 0;  // on the curve
  Peaks path{};           // finite differences of the ticks on the curve
  double chord_error_mm = 0.0;
  std::vector<TickOfRun> on_curve{};  // s_mm counts from the curve's begin

  // At the parameter u, linear between ticks.
  [[nodiscard]] double feedrate_mm_s(double u) const;
  // How far the tool goes at the highest feedrate from the begin, or up to the end.
  [[nodiscard]] double first_stretch_mm(double feedrate_mm_s) const;
  [[nodiscard]] double last_stretch_mm(double feedrate_mm_s) const;
};

// The limits along the path that a paper prints.
struct PublishedLimits {
  lookahead::MotionLimits path;
  double chord_error_mm = 0.0;
};

// Whether the machine file has them, and the ticks keep them.
bool keeps(const MotionRun& run, const lookahead::PlanLimits& limits,
           const PublishedLimits& published);

MotionRun in_motion(const std::string& program, const lookahead::PlanLimits& limits,
                    const profiles::Profile& profile);

}  // namespace kerf::bench
