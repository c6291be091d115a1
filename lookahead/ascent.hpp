// A transition from an end of a span upwards, below the span's ceiling.
#pragma once

#include "lookahead/span.hpp"

namespace kerf::lookahead {

// The law, and how far it cruises at that end first.
struct Ascent {
  profiles::Transition law{};
  double foot_mm = 0.0;

  [[nodiscard]] double length_mm() const { return foot_mm + law.length_mm(); }
  [[nodiscard]] double duration_s() const {
    const double v = law.ramp().v_begin_mm_s;
    return law.duration_s() + (foot_mm > 0.0 ? foot_mm / v : 0.0);
  }
};

// The fastest transition over ramp, which ascends, stretched until it stays below the slope; that
// of a trapezoid begins later instead. slope is the span's rise or fall, its foot at ramp.v_begin.
Ascent climb_to(const Slope& slope, const profiles::Ramp& ramp, const Span& span,
                const profiles::Profile& profile);

// The length of that ascent, cheaper where there is no slope.
double climb_length_mm(const Slope& slope, const profiles::Ramp& ramp, const Span& span,
                       const profiles::Profile& profile);

}  // namespace kerf::lookahead
