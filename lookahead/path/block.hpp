// What the look-ahead plans: one smooth curve with its limits, or a rest.
#pragma once

#include <cstdint>
#include <vector>

#include "curves/auxiliary_axis_motion.hpp"
#include "curves/curve.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/velocity_limit_curve.hpp"
#include "profiles/shape_value.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::lookahead {

// Limits along the path that hold from end to end of a curve.
struct BlockLimits {
  double feedrate_mm_s = 0.0;
  profiles::RampLimits ramp{};
  LimitOrigins from{};
};

// The direction and curvature of the path where two blocks meet, and what bounds them there.
struct BlockEnd {
  curves::Position tangent{};
  curves::Position curvature_per_mm{};
  double third_per_mm2 = 0.0;  // bound of |q'''| of the curve, 0 where it does not bind
  curves::AuxiliaryPosition extra_per_mm{};  // what the extra axes move by the path's length
};

using smoothing::LineMark;

struct Block {
  curves::Curve curve;
  curves::AuxiliaryAxisMotion extra{};
  std::uint32_t line = 0;
  std::uint64_t run_block = 0;  // parser::Move::block of the move that it begins with
  // Where the curve stands for more than one line: ascending, the first at 0. Empty: it is of
  // `line` everywhere.
  std::vector<LineMark> marks{};
  bool rapid = false;
  double length_mm = 0.0;
  BlockLimits limits{};
  // The same without what curvature on a curve asks of X, Y and Z: programmed, along the path, of
  // further axes and, on an arc and on a curve that a tick passes over whole, by chord error.
  BlockLimits along{};
  BlockEnd begin{};
  BlockEnd end{};
  bool stop_after = false;  // exact stop
  // It goes on where and as the block before ends, in direction and curvature, by construction:
  // nothing of them jumps there but what rounding left.
  bool continues = false;
  VelocityLimitCurve limit_curve{};  // empty: limits.feedrate_mm_s everywhere

  // s_mm of the mark: where on the curve the line's part begins.
  [[nodiscard]] LineMark mark_at(double at_mm) const {
    return smoothing::mark_at(marks, at_mm, {.line = line, .run_block = run_block});
  }
};

}  // namespace kerf::lookahead
