#include "machine/setpoint_gate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kerf::machine {

namespace {

// The place of the first coordinate that is not finite.
template <std::size_t kCount>
std::optional<std::int8_t> not_finite_axis(const std::array<double, kCount>& position) {
  for (std::size_t axis = 0; axis < kCount; ++axis) {
    if (!std::isfinite(position[axis])) {
      return static_cast<std::int8_t>(axis);
    }
  }
  return std::nullopt;
}

std::optional<std::int8_t> not_finite_axis(const AxisPlaces& places) {
  if (const auto axis = not_finite_axis(places.mm)) {
    return axis;
  }
  const auto extra = not_finite_axis(places.extra_rad_mm);
  return extra ? std::optional(static_cast<std::int8_t>(3 + *extra)) : std::nullopt;
}

std::optional<std::int8_t> not_finite_axis(const Setpoint& setpoint) {
  for (const Position* vector : {&setpoint.velocity_mm_s, &setpoint.acceleration_mm_s2}) {
    if (const auto axis = not_finite_axis(*vector)) {
      return axis;
    }
  }
  if (const auto axis = not_finite_axis(
          AxisPlaces{.mm = setpoint.position_mm, .extra_rad_mm = setpoint.extra_rad_mm})) {
    return axis;
  }
  const bool finite = std::isfinite(setpoint.s_mm) && std::isfinite(setpoint.v_mm_s) &&
                      std::isfinite(setpoint.a_mm_s2) && std::isfinite(setpoint.j_mm_s3);
  return finite ? std::nullopt : std::optional<std::int8_t>(std::int8_t{-1});
}

Envelope bounded(Envelope envelope) {
  for (Travel& travel : envelope) {
    travel.min_mm = std::max(travel.min_mm, -SetpointGate::kFarthestMm);
    travel.max_mm = std::min(travel.max_mm, SetpointGate::kFarthestMm);
  }
  return envelope;
}

}  // namespace

SetpointGate::SetpointGate(const TableSettings& settings) noexcept
    : travel_(bounded(envelope_of(settings))), envelope_(travel_), extra_(settings.extra) {}

void SetpointGate::set_unhomed(AxisBits axes) noexcept {
  constexpr Travel kAnywhere{.min_mm = -kFarthestMm, .max_mm = kFarthestMm};
  for (std::size_t axis = 0; axis < envelope_.size(); ++axis) {
    envelope_[axis] = ((axes >> axis) & 1U) != 0U ? kAnywhere : travel_[axis];
  }
}

std::optional<SetpointGate::Refusal> SetpointGate::refusal(
    const Setpoint& setpoint) const noexcept {
  if (const auto axis = not_finite_axis(setpoint)) {
    return Refusal{.why = DriveFault::not_finite, .axis = *axis};
  }
  if (const auto excess = outside_travel(envelope_, setpoint.position_mm)) {
    return Refusal{.why = DriveFault::soft_limit, .axis = excess->axis};
  }
  if (const auto excess = outside_travel(extra_, setpoint.extra_rad_mm)) {
    return Refusal{.why = DriveFault::soft_limit, .axis = excess->axis};
  }
  return std::nullopt;
}

std::optional<SetpointGate::Refusal> SetpointGate::refusal(const AxisPlaces& places) noexcept {
  const auto axis = not_finite_axis(places);
  return axis ? std::optional(Refusal{.why = DriveFault::not_finite, .axis = *axis}) : std::nullopt;
}

}  // namespace kerf::machine
