#include "programs/kerf/report/constraint_text.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace kerf::program {

namespace {

constexpr auto kFirstOfAxes = static_cast<std::size_t>(Constraint::x_velocity);

constexpr std::array<std::string_view, kFirstOfAxes> kColours{
    "#e3e6ea", "#9aa3ad", "#d5bfe6", "#a878cc", "#6f3d99", "#f2a900", "#333333", "#e754a6"};
// Velocity, acceleration, jerk.
using Hue = std::array<std::string_view, 3>;
constexpr Hue kOfFurtherAxes{"#cdb79e", "#a2845e", "#6b4f2c"};
constexpr std::array<Hue, 3> kHues{{{"#f0b3ad", "#dc6a5f", "#a8271b"},
                                    {"#b4dfc0", "#5fb57a", "#1f7a3d"},
                                    {"#b3d1f0", "#5f9bdc", "#1b5aa8"}}};

// Of an axis' limit.
struct AxisLimit {
  std::size_t quantity = 0;
  std::size_t axis = 0;
};

AxisLimit axis_limit(Constraint limit) noexcept {
  const std::size_t number = static_cast<std::size_t>(limit) - kFirstOfAxes;
  return {.quantity = number / interp::kLimitedAxes, .axis = number % interp::kLimitedAxes};
}

bool is_of_axis(Constraint limit) noexcept {
  return static_cast<std::size_t>(limit) >= kFirstOfAxes;
}

constexpr std::array<std::string_view, interp::kConstraints> kKeys{"rest",
                                                                   "programmed_feedrate",
                                                                   "path_velocity",
                                                                   "path_acceleration",
                                                                   "path_jerk",
                                                                   "chord_error",
                                                                   "joint",
                                                                   "window_end",
                                                                   "axis_x_velocity",
                                                                   "axis_y_velocity",
                                                                   "axis_z_velocity",
                                                                   "axis_a_velocity",
                                                                   "axis_b_velocity",
                                                                   "axis_c_velocity",
                                                                   "axis_u_velocity",
                                                                   "axis_v_velocity",
                                                                   "axis_w_velocity",
                                                                   "axis_x_acceleration",
                                                                   "axis_y_acceleration",
                                                                   "axis_z_acceleration",
                                                                   "axis_a_acceleration",
                                                                   "axis_b_acceleration",
                                                                   "axis_c_acceleration",
                                                                   "axis_u_acceleration",
                                                                   "axis_v_acceleration",
                                                                   "axis_w_acceleration",
                                                                   "axis_x_jerk",
                                                                   "axis_y_jerk",
                                                                   "axis_z_jerk",
                                                                   "axis_a_jerk",
                                                                   "axis_b_jerk",
                                                                   "axis_c_jerk",
                                                                   "axis_u_jerk",
                                                                   "axis_v_jerk",
                                                                   "axis_w_jerk"};

}  // namespace

std::string_view key_of(Constraint limit) noexcept {
  return kKeys[static_cast<std::size_t>(limit)];
}

std::string text_of(Constraint limit) {
  std::string text(key_of(limit));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string_view colour_of(Constraint limit) noexcept {
  if (!is_of_axis(limit)) {
    return kColours[static_cast<std::size_t>(limit)];
  }
  const AxisLimit of = axis_limit(limit);
  return of.axis < kHues.size() ? kHues[of.axis][of.quantity] : kOfFurtherAxes[of.quantity];
}

}  // namespace kerf::program
