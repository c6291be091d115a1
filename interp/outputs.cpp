#include "interp/outputs.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::interp {

namespace {

void stop_spindle(Outputs& outputs) noexcept {
  outputs.spindle_rad_s = 0.0;
  outputs.surface = {};
  outputs.spindle_held = false;
}

void set_digital(const OutputChange& change, Outputs& outputs) noexcept {
  const auto output = static_cast<std::size_t>(change.index);
  if (output < Outputs::kDigital) {
    const std::uint64_t bit = std::uint64_t{1} << output;
    outputs.digital = change.value != 0.0 ? outputs.digital | bit : outputs.digital & ~bit;
  }
}

}  // namespace

void apply(const OutputChange& change, Outputs& outputs) noexcept {
  switch (change.kind) {
    case OutputChangeKind::spindle:
      stop_spindle(outputs);
      outputs.spindle_rad_s = change.value;
      outputs.surface = change.surface;
      break;
    case OutputChangeKind::hold_spindle:
      stop_spindle(outputs);
      outputs.spindle_angle_rad = change.value;
      outputs.spindle_held = true;
      break;
    case OutputChangeKind::tool_change:
      stop_spindle(outputs);
      outputs.tool = static_cast<std::int32_t>(change.value);
      break;
    case OutputChangeKind::tool_number:
      outputs.tool = static_cast<std::int32_t>(change.value);
      break;
    case OutputChangeKind::mist_on:
      outputs.mist = true;
      break;
    case OutputChangeKind::flood_on:
      outputs.flood = true;
      break;
    case OutputChangeKind::coolant_off:
      outputs.mist = outputs.flood = false;
      break;
    case OutputChangeKind::speed_override:
      outputs.follows_speed_override = change.value != 0.0;
      break;
    case OutputChangeKind::adaptive_feed:
      outputs.follows_adaptive_feed = change.value != 0.0;
      break;
    case OutputChangeKind::feed_stop:
      outputs.heeds_feed_stop = change.value != 0.0;
      break;
    case OutputChangeKind::digital:
      set_digital(change, outputs);
      break;
    case OutputChangeKind::analog:
      if (static_cast<std::size_t>(change.index) < Outputs::kAnalog) {
        outputs.analog[static_cast<std::size_t>(change.index)] = change.value;
      }
      break;
    case OutputChangeKind::all_off:
      stop_spindle(outputs);
      outputs.mist = outputs.flood = false;
      break;
  }
}

void override_spindle(double share, Outputs& outputs) noexcept {
  if (!outputs.follows_speed_override) {
    return;
  }
  outputs.spindle_rad_s *= share;
  if (outputs.surface.mm_s != 0.0) {
    outputs.spindle_rad_s =
        std::clamp(outputs.spindle_rad_s, -outputs.surface.max_rad_s, outputs.surface.max_rad_s);
  }
}

void follow_surface(const curves::Position& position_mm, Outputs& outputs) noexcept {
  const SurfaceSpeed& surface = outputs.surface;
  if (surface.mm_s == 0.0) {
    return;
  }
  const double radius_mm = std::fabs(surface.per_x * position_mm[0] +
                                     surface.per_y * position_mm[1] + surface.at_origin_mm);
  const double speed_mm_s = std::fabs(surface.mm_s);
  const bool limited = speed_mm_s >= surface.max_rad_s * radius_mm;
  const double rad_s = limited ? surface.max_rad_s : speed_mm_s / radius_mm;
  outputs.spindle_rad_s = std::copysign(rad_s, surface.mm_s);
}

}  // namespace kerf::interp
