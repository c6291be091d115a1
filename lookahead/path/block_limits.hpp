// The limits of the machine along one curve.
#pragma once

#include "curves/arc.hpp"
#include "curves/line.hpp"
#include "curves/nurbs_curve.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

// A bound along the path, and its origin.
struct Bound {
  double value = kUnbounded;
  Constraint from{};
};

// Takes the bound if it is lower than the present bound of the feedrate.
void bind_feedrate(BlockLimits& block, const Bound& bound);

// feedrate_mm_s: programmed, infinity for a rapid.

// The limits of the path alone.
BlockLimits path_limits(double feedrate_mm_s, const PlanLimits& limits);

// An axis moves by its share of the direction, so its limits divided by that share bind.
BlockLimits line_limits(const curves::Line& line, double feedrate_mm_s, const PlanLimits& limits);

// The extra axes move by their share of the length, and their limits divided by it bind, too.
void bind_extra(const curves::AuxiliaryAxisMotion& extra, const PlanLimits& limits,
                BlockLimits& block);

// How a path turns in the plane of an arc: bounds over its whole length.
struct Bend {
  int normal_axis = 2;
  double in_plane_share = 1.0;  // of the unit tangent: 1, less for a helix
  double normal_share = 0.0;
  double curvature_per_mm = 0.0;
  double third_per_mm2 = 0.0;       // of the third derivative by arc length
  bool third_along_tangent = true;  // on a circle
};

Bend bend_of(const curves::Arc& arc);
// For an arc whose ends have different radii, which became a spiral: sampled, with a margin.
Bend bend_of(const curves::NurbsCurve& spiral, int normal_axis);

// On an arc of radius R and in-plane share c an axis sees c a along and c^2 v^2 / R across, and in
// jerk c j - c^3 v^3 / R^2 along and 3 c^2 v a / R across. The feedrate is limited so that
// the centripetal terms leave room, and a and j get the rest: one set of constants for the whole
// arc.
BlockLimits arc_limits(const Bend& bend, double feedrate_mm_s, const PlanLimits& limits);

// The feedrate at which the chord of a tick leaves the arc by the tolerance.
double arc_chord_feedrate_mm_s(const Bend& bend, const PlanLimits& limits);

// Along a NURBS the limits of the path bind, and acceleration and jerk of the weakest moving axis,
// as if it ran along the curve: a first bound. The limits of each axis at each place are applied by
// axis_limit_scan in the classical schedule and by the cells of the time optimum.
BlockLimits nurbs_limits(const curves::NurbsCurve& curve, double feedrate_mm_s,
                         const PlanLimits& limits);

}  // namespace kerf::lookahead
