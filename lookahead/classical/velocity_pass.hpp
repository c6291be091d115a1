// The feedrates at the ends of the segments in the window.
#pragma once

#include "lookahead/classical/velocity_segment.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

// A segment in the window and what the passes found for it.
struct WindowSegment {
  VelocitySegment segment{};
  double v_end_mm_s = 0.0;         // the highest from which the window can still end at rest
  bool brakes_for_window = false;  // it is the window's end that keeps v_end_mm_s down
  // Of all passes the highest beginning, with an end that it joins. The segment after it can begin
  // with that end, whatever later passes find.
  SegmentEnds sure{};
};

// From the last segment, which ends at rest, back to the first: each end gets the highest feedrate
// that its junction allows and from which the rest of the window can be braked.
//
//        F  _____            ______
//          /     \__________/      \            junctions cap the valleys, the backward pass bends
//         /                         \           every end below the braking curve to the final rest
//        /                           \___ 0
//
// 1. The last end is 0: the machine can stop there whatever comes later.
// 2. An end is min(its junction, the most from which the segment after it still reaches its own
// end).
// 3. The forward pass is not a loop of its own: when a segment is planned for good its beginning is
//    known, and its end is lowered to what it reaches from there.
// 4. A pass may find less than the one before: under a jerk braking from v to v / 3 takes more room
//    than braking to rest, so where an end need not be a rest any more its beginning may have to be
//    slower; and where curvature binds, a segment may join a higher beginning to an end and not a
//    lower one. What has left by then was promised the higher one. So each segment keeps the
//    highest pair that was found over the passes, and since these only rise, the end of one is
//    never above the beginning of the next: from any beginning that was promised the motion can
//    follow the pairs to a rest, joining them or slowed down as a whole (slowed_plan).
// Acceleration is 0 at every end, which is what keeps a segment's plan independent of its
// neighbours, and the known weakness: a run of short segments accelerates by one small step in
// each.
void backward_pass(Window<WindowSegment>& window, const profiles::Profile& profile);

// How a segment ends that begins with what was promised.
struct Ending {
  double v_end_mm_s = 0.0;
  bool is_slowed = false;  // as the sure plan does when it is slowed down to the beginning
};
// As close to wanted.v_end as it can be joined. Precondition: wanted.v_begin is at most that of
// item.sure.
Ending ending_of(const WindowSegment& item, const SegmentEnds& wanted,
                 const profiles::Profile& profile);

}  // namespace kerf::lookahead
