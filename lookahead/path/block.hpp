// A block of the look-ahead: one smooth curve with its limits.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "curves/auxiliary_axis_motion.hpp"
#include "curves/curve.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/path_sample.hpp"
#include "profiles/shape_value.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::lookahead {

// Limits along the path that hold from end to end of a curve.
struct BlockLimits {
  double feedrate_mm_s = 0.0;
  profiles::RampLimits ramp{};
  LimitOrigins from{};
};

// The path at an end of a block, where it meets the next one.
struct BlockEnd : curves::PathDerivatives {
  double max_third_per_mm2 = 0.0;            // the largest |q'''| of the curve; 0: it does not bind
  curves::AuxiliaryPosition extra_per_mm{};  // how far the extra axes move per length of the path
};

using smoothing::LineMark;

struct Block {
  curves::Curve curve;
  curves::AuxiliaryAxisMotion extra{};
  std::uint32_t line = 0;
  std::uint64_t run_block = 0;  // parser::Move::block of the move that it begins with
  // Where each line of the program begins on the curve, ascending, the first at 0. Empty: all of it
  // belongs to `line`.
  std::vector<LineMark> marks{};
  bool rapid = false;
  double deviation_mm = 0.0;          // smoothing::PathSegment
  double feedrate_mm_s = kUnbounded;  // programmed; of a rapid, none
  parser::FollowedOverrides follows{};
  std::optional<int> arc_normal{};  // smoothing::PathSegment
  double length_mm = 0.0;
  BlockLimits limits{};
  // The same without the share that curvature takes of the limits of X, Y and Z: the programmed
  // feedrate, limits along the path and of further axes and, on an arc and on a sub-tick block,
  // chord error.
  BlockLimits along{};
  BlockEnd begin{};
  BlockEnd end{};
  bool stop_after = false;  // exact stop
  // Direction and curvature go on from the block before by construction; they differ by rounding
  // alone.
  bool continues = false;
  VelocityLimitCurve limit_curve{};  // empty: limits.feedrate_mm_s everywhere
  // A motion slows down on it that was faster than it now may be: its limits allow for that.
  bool slows = false;
  // Where this is what is left of a block (remainder_of): that block, and where on it this begins.
  std::shared_ptr<const Block> whole{};
  double begin_mm = 0.0;

  // The place on the whole block's curve, which the tick side knows.
  [[nodiscard]] double on_whole_mm(double s_mm) const {
    if (!whole) {
      return s_mm;
    }
    return s_mm == length_mm ? whole->length_mm : begin_mm + s_mm;
  }
  // The line at a place of the curve, and where on the curve it begins.
  [[nodiscard]] LineMark mark_at(double at_mm) const {
    return smoothing::mark_at(marks, at_mm, {.line = line, .run_block = run_block});
  }
};

}  // namespace kerf::lookahead
