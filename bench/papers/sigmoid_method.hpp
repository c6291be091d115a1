// The method of [Sigmoid] as its text has it, to find what its figures are made of. Kerf's own plan
// is not this one: docs/math.md, 12.
#pragma once

#include <cstddef>
#include <vector>

#include "bench/papers/parametric_curve.hpp"
#include "curves/nurbs_curve.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/path_sample.hpp"
#include "profiles/profile.hpp"

namespace kerf::bench {

// How the error of a tick is measured while the curve is scanned: the text names the largest
// distance, and approximates it by the circle of curvature at the tick's begin [Sigmoid, equation
// 17].
enum class ChordRule { largest_distance, at_middle_parameter, circle_of_curvature };

struct MethodCurve {
  const ParametricCurve& by_parameter;
  const curves::NurbsCurve& by_length;
};

// One row of ticks from u = 0 on, each as fast as its chord error allows; at the last one the
// feedrate before.
lookahead::VelocityLimitCurve method_scan(const MethodCurve& curve, ChordRule rule,
                                          const lookahead::PlanLimits& limits);

// The scan of the papers knows the feedrate at its ticks alone, and between two valleys only their
// feedrates and their distance count: each transition as short as the limits allow, the highest
// feedrate that fits between [Sigmoid, equations 64 and 65].
struct MethodPlan {
  double time_s = 0.0;
  double chord_error_mm = 0.0;  // the largest of the ticks
  std::size_t ticks = 0;
};

// A valley, a critical point, an end: its feedrate at the most.
struct MethodPlace {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
};

// The time over the places, the first and the last being the ends.
double time_over_s(std::vector<MethodPlace> places, const profiles::Profile& profile,
                   const lookahead::PlanLimits& limits);

// dips: of the two shallow valleys beside the ends of the butterfly, too, which a screening value
// leaves out that finds 37 breaking points.
MethodPlan method_plan(const MethodCurve& curve, const lookahead::VelocityLimitCurve& scan,
                       const profiles::Profile& profile, const lookahead::PlanLimits& limits,
                       bool dips);

}  // namespace kerf::bench
