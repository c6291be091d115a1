// The feedrates at the ends of the segments in the window.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "lookahead/classical/velocity_segment.hpp"
#include "lookahead/path/window.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

// A segment in the window and the result of the passes for it.
struct WindowSegment {
  VelocitySegment segment{};
  double v_end_mm_s = 0.0;         // the highest from which the window can still end at rest
  bool brakes_for_window = false;  // the window's end limits v_end_mm_s
  // The highest beginning of all passes, with an end that it joins. The segment after it can begin
  // with that end, whatever later passes find.
  SegmentEnds sure{};
};

// From the last segment, which ends at rest, back to the first: each end gets the highest feedrate
// that its junction allows and from which the tool can brake within the rest of the window.
//
//        F  _____            ______
//          /     \__________/      \            junctions cap the valleys, the backward pass bends
//         /                         \           every end below the braking curve to the final rest
//        /                           \___ 0
//
// 1. The last end is 0: the machine can stop there whatever comes later.
// 2. An end is min(its junction, the most from which the segment after it still reaches its own
// end). A segment takes a slower end where a part at constant velocity at a faster one would let it
// begin much slower (ends_backward).
// 3. The forward pass is not a loop of its own: when a segment is planned for good its beginning is
//    known, and its end is lowered to what it reaches from there.
// 4. A pass may find less than the one before: under a jerk braking from v to v / 3 takes more room
//    than braking to rest, so where an end need not be a rest any more its beginning may have to be
//    slower; and where curvature binds, a segment may join a higher beginning to an end and not a
//    lower one. Segments emitted by then rely on the higher one. So each segment keeps the highest
//    pair that was found over the passes, and since these only rise, the end of one is
//    never above the beginning of the next: from any such beginning the motion can
//    follow the pairs to a rest, joining them or slowed down as a whole (slowed_plan).
// Acceleration is 0 at every end, so a segment's plan is independent of its neighbours. Known
// weakness: a run of short segments accelerates by one small step in each.
void backward_pass(Window<WindowSegment>& window, const profiles::Profile& profile);

// The end of a segment whose beginning was fixed by the segment before.
struct Ending {
  double v_end_mm_s = 0.0;
  bool is_slowed = false;  // the end of the sure plan, slowed down to that beginning
};
// The window begins in motion, at that feedrate and an acceleration of 0. False: that is
// too fast there, or from there it cannot come to rest. Precondition: backward_pass().
bool begin_in_motion(WindowSegment& first, double v_mm_s, const profiles::Profile& profile);

// The nearest end to wanted.v_end that can be joined. Precondition: wanted.v_begin is at most that
// of item.sure.
Ending ending_of(const WindowSegment& item, const SegmentEnds& wanted,
                 const profiles::Profile& profile);
// The plan from the same beginning to that end.
SegmentPlan plan_joined(const WindowSegment& item, const Ending& ending, double v_begin_mm_s,
                        const profiles::Profile& profile);

// How long the segments of a block take where nothing is known of the blocks beside it.
class BlockRuns {
 public:
  explicit BlockRuns(const profiles::Profile& profile) : profile_(profile) {}

  // Of each segment, from rest to rest.
  std::vector<double> rest_to_rest_s(const std::vector<VelocitySegment>& segments);
  // Of each, where lines come after the block, and in front of it unless it begins at rest, on
  // which the tool has the feedrates that the block's ends allow; each line, up to a rest, counts
  // to the segment beside it.
  std::vector<double> in_motion_s(const std::vector<VelocitySegment>& segments,
                                  bool begins_at_rest);

 private:
  // One that was asked for before, with the same ends, costs no plan: two of a block differ at most
  // by how valleys within a tick of each other were made one.
  std::vector<double> durations_s(Window<WindowSegment> window);

  const profiles::Profile& profile_;
  std::map<std::array<double, 4>, double> known_s_;  // where from, how far, and the feedrates there
};

}  // namespace kerf::lookahead
