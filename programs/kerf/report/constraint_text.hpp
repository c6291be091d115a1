// Names and colours of the constraints.
#pragma once

#include <string>
#include <string_view>

#include "interp/constraint.hpp"

namespace kerf::program {

using interp::Constraint;

// "axis_y_jerk", "programmed_feedrate": in the trace and in JSON.
[[nodiscard]] std::string_view key_of(Constraint limit) noexcept;
// "axis y jerk".
[[nodiscard]] std::string text_of(Constraint limit);
// "#1f5fa8": a hue for each axis and one for the path, darker from velocity to jerk.
[[nodiscard]] std::string_view colour_of(Constraint limit) noexcept;

}  // namespace kerf::program
