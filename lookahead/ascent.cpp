#include "lookahead/ascent.hpp"

namespace kerf::lookahead {

using profiles::Profile;
using profiles::Ramp;
using profiles::Transition;

Ascent climb_to(const Slope& slope, const Ramp& ramp, const Span& span, const Profile& profile) {
  const Transition fastest = profile.fastest(ramp, span.limits.ramp);
  if (slope.empty()) {
    return {.law = fastest};
  }
  if (profile.kind() == profiles::ProfileKind::trapezoid && ramp.v_begin_mm_s > 0.0) {
    return {.law = fastest, .foot_mm = slope.delay_for_mm(fastest)};
  }
  return {.law = fastest.stretched(slope.stretch_for(fastest))};
}

double climb_length_mm(const Slope& slope, const Ramp& ramp, const Span& span,
                       const Profile& profile) {
  return slope.empty() ? profile.length_mm(ramp, span.limits.ramp)
                       : climb_to(slope, ramp, span, profile).length_mm();
}

}  // namespace kerf::lookahead
