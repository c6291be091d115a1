// The feedrates at the ends of the spans in the window.
#pragma once

#include "lookahead/span.hpp"
#include "lookahead/window.hpp"

namespace kerf::lookahead {

// A span in the window and what the passes found for it.
struct WindowSpan {
  Span span{};
  double v_end_mm_s = 0.0;         // the highest from which the window can still end at rest
  double v_end_before_mm_s = 0.0;  // the same of the pass before, when the window was shorter
  bool brakes_for_window = false;  // it is the window's end that keeps v_end_mm_s down
  // Where turning binds: a beginning and an end that are known to join.
  SpanEnds sure{};

  // The end that a beginning has when the sure plan is slowed down to it.
  [[nodiscard]] double slowed_end_mm_s(double v_begin_mm_s) const {
    return sure.v_end_mm_s * v_begin_mm_s / sure.v_begin_mm_s;
  }
};

// From the last span, which ends at rest, back to the first: each end gets the highest feedrate
// that its junction allows and from which the rest of the window can be braked.
//
//        F  _____            ______
//          /     \__________/      \            junctions cap the valleys, the backward pass bends
//         /                         \           every end below the braking curve to the final rest
//        /                           \___ 0
//
// 1. The last end is 0: the machine can stop there whatever comes later.
// 2. An end is min(its junction, the most from which the span after it still reaches its own end).
// 3. The forward pass is not a loop of its own: when a span is planned for good its beginning is
//    known, and its end is lowered to what it reaches from there.
// 4. Where turning binds, a span may join a higher beginning to an end and not a lower one. So the
//    highest pair known to join is kept over the passes, and slowed down as a whole it joins from
//    any lower beginning (slowed_plan).
// Acceleration is 0 at every end, which is what keeps a span's plan independent of its neighbours,
// and the known weakness: a run of short spans climbs one small step in each.
void backward_pass(Window<WindowSpan>& window, const profiles::Profile& profile);

}  // namespace kerf::lookahead
