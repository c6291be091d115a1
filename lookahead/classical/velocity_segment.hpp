// A length of one block between two planned feedrates: acceleration, cruise, deceleration.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lookahead/classical/axis_limit_scan.hpp"
#include "lookahead/classical/slope.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/junction.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

struct VelocitySegment {
  double length_mm = 0.0;
  BlockLimits limits{};
  double begin_constant_velocity_s = 0.0;
  Junction end{};           // bounds the feedrate at its end
  double s_begin_mm = 0.0;  // on the block's curve
  bool ends_block = true;
  Slope rise{};  // from its beginning
  Slope fall{};  // from its end
  // The limits of the axes along it, beside `limits`; empty: they do not bind.
  AxisLimitCurve axis_limits{};
  std::array<MotionLimits, 3> axes{};  // for curvature
};

// The feedrates at the two ends of a segment.
struct SegmentEnds {
  double v_begin_mm_s = 0.0;
  double v_end_mm_s = 0.0;
};

// The parts of a segment, in this order; missing parts have no duration.
struct SegmentPlan {
  profiles::Transition begin_constant_velocity{};
  profiles::Transition acceleration{};
  profiles::Transition cruise{};
  profiles::Transition deceleration{};
  profiles::Transition end_constant_velocity{};

  [[nodiscard]] double duration_s() const noexcept;
};

// Which of its parts a plan has, as the papers name them [SineSeries]: "ACC + CF + DEC", "ACC +
// DEC", "ACC + CF", "CF + DEC", "ACC", "DEC" or "CF". Parts at constant velocity beside a junction
// do not count beside others.
std::string_view kind_of(const SegmentPlan& plan) noexcept;

struct BackwardQuery {
  double v_end_mm_s = 0.0;
  double cap_mm_s = 0.0;
};
// The largest feedrate <= cap at its beginning from which the segment can end with v_end_mm_s, or
// with less where a part at constant velocity at v_end would take the room to brake in.
double reach_backward_mm_s(const VelocitySegment& segment, const BackwardQuery& query,
                           const profiles::Profile& profile);

// The ends <= cap and <= v_end that take the least time at about their mean feedrate. Where a part
// at constant velocity takes much of the segment, a slower end lets it begin faster, and costs time
// after it.
SegmentEnds ends_backward(const VelocitySegment& segment, const BackwardQuery& query,
                          const profiles::Profile& profile);

// The largest feedrate <= wanted.v_end with which the segment can end that begins with
// wanted.v_begin. A part at constant velocity takes room at its feedrate, and braking to a third
// takes more room than braking to rest, so a slower end may fit where a faster one does not and the
// other way round. v_end_known: an end that this beginning or a higher one is known to join. Where
// the wanted end does not fit, v_end_known may be higher, and the result lies between them.
// Precondition: v_begin is at most what reach_backward gives for v_end or for v_end_known.
double end_feedrate_mm_s(const VelocitySegment& segment, const SegmentEnds& wanted,
                         double v_end_known_mm_s, const profiles::Profile& profile);

// Whether the segment has room for the direct transition between its ends, the parts at constant
// velocity included.
bool joins(const VelocitySegment& segment, const SegmentEnds& ends,
           const profiles::Profile& profile);

// The fastest plan: the cruise as high as length and limits allow; under a limit curve the cruise
// of least time. Precondition: the ends can be joined.
SegmentPlan plan_segment(const VelocitySegment& segment, const SegmentEnds& ends,
                         const profiles::Profile& profile);

// The plan of two ends that join, slowed down as a whole until it begins with v_begin_mm_s, which
// is lower: accelerations shrink with its square, jerks with its cube, so it keeps every limit that
// the plan kept, wherever on a curve.
SegmentPlan slowed_plan(const VelocitySegment& segment, const SegmentEnds& ends,
                        double v_begin_mm_s, const profiles::Profile& profile);

}  // namespace kerf::lookahead
