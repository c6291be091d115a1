#include "machine/simulated_world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::machine {
namespace {

bool finite(const Position& position) noexcept {
  return std::all_of(position.begin(), position.end(), [](double x) { return std::isfinite(x); });
}

bool is_valid_surface(const TouchBox& box) noexcept {
  for (std::size_t axis = 0; axis < box.min_mm.size(); ++axis) {
    if (!(box.min_mm[axis] <= box.max_mm[axis])) {
      return false;
    }
  }
  return true;
}

bool is_valid_surface(const TouchPlane& plane) noexcept {
  return finite(plane.point_mm) && finite(plane.normal) && curves::vec(plane.normal).norm() > 0.0;
}

bool is_valid_surface(const TouchSphere& sphere) noexcept {
  return finite(sphere.centre_mm) && sphere.radius_mm > 0.0 && std::isfinite(sphere.radius_mm);
}

bool is_valid_surface(const HeightMap& map) noexcept {
  const std::size_t rows = map.columns > 0 ? map.heights_mm.size() / map.columns : 0;
  return map.columns >= 2 && map.columns <= HeightMap::kMaxColumns && rows >= 2 &&
         rows <= HeightMap::kMaxColumns && rows * map.columns == map.heights_mm.size() &&
         map.spacing_mm[0] > 0.0 && map.spacing_mm[1] > 0.0 && std::isfinite(map.spacing_mm[0]) &&
         std::isfinite(map.spacing_mm[1]) && std::isfinite(map.origin_mm[0]) &&
         std::isfinite(map.origin_mm[1]) &&
         std::all_of(map.heights_mm.begin(), map.heights_mm.end(),
                     [](double z) { return std::isfinite(z); });
}

Position difference(const Position& a, const Position& b) noexcept {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Position sum(const Position& a, const Position& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

}  // namespace

bool is_valid(const SimulationSettings& settings) noexcept {
  const bool surface_is_valid =
      !settings.surface ||
      visit(*settings.surface, [](const auto& surface) { return is_valid_surface(surface); });
  return surface_is_valid && settings.spindle_rad_s2 >= 0.0 &&
         std::isfinite(settings.spindle_rad_s2) &&
         std::all_of(settings.analog.begin(), settings.analog.end(),
                     [](double value) { return std::isfinite(value); });
}

SimulatedWorld::SimulatedWorld(SimulationSettings settings, std::vector<ToolOffset> tools,
                               double period_s)
    : settings_(is_valid(settings) ? std::move(settings) : SimulationSettings{}),
      tools_(std::move(tools)),
      spindle_step_rad_s_(settings_.spindle_rad_s2 * period_s) {}

Position SimulatedWorld::tool_offset_mm(std::int32_t tool) const noexcept {
  const auto at = std::lower_bound(
      tools_.begin(), tools_.end(), tool,
      [](const ToolOffset& entry, std::int32_t number) { return entry.tool < number; });
  return at != tools_.end() && at->tool == tool ? at->offset_mm : Position{};
}

void SimulatedWorld::restart(const Position& place_mm, MachineState& state) noexcept {
  tool_ = state.outputs.tool;
  tip_mm_ = difference(place_mm, tool_offset_mm(tool_));
  touches_ = settings_.surface && touches(*settings_.surface, tip_mm_);
  feel(place_mm, state);
}

void SimulatedWorld::feel(const Position& place_mm, MachineState& state) noexcept {
  feel_probe(place_mm, state);
  feel_switches(place_mm, state.inputs);
  turn_spindle(state.outputs.spindle_rad_s);
  state.inputs.spindle_at_speed = spindle_rad_s_ == state.outputs.spindle_rad_s;
  state.inputs.digital = settings_.digital;
  state.inputs.analog = settings_.analog;
}

// The tip runs straight from one tick to the next. Another tool begins elsewhere.
void SimulatedWorld::feel_probe(const Position& place_mm, MachineState& state) noexcept {
  if (!settings_.surface) {
    return;
  }
  const Position offset_mm = tool_offset_mm(state.outputs.tool);
  const bool same_tool = std::exchange(tool_, state.outputs.tool) == state.outputs.tool;
  const Position before_mm = std::exchange(tip_mm_, difference(place_mm, offset_mm));
  const bool before = std::exchange(touches_, touches(*settings_.surface, tip_mm_));
  state.inputs.probe = touches_;
  state.has_latched = false;
  if (settings_.latches_probe && same_tool && touches_ != before) {
    const TipWay way{.from_mm = before_mm, .to_mm = tip_mm_};
    const auto change =
        touches_ ? first_contact(*settings_.surface, way) : end_of_contact(*settings_.surface, way);
    state.has_latched = change.has_value();
    state.latched_mm = change ? sum(*change, offset_mm) : Position{};
  }
}

void SimulatedWorld::feel_switches(const Position& place_mm, MachineInputs& inputs) const noexcept {
  inputs.home = inputs.lower_limit = inputs.upper_limit = 0;
  for (std::size_t axis = 0; axis < place_mm.size(); ++axis) {
    const AxisSwitches& switches = settings_.switches[axis];
    const double at_mm = place_mm[axis];
    const auto bit = static_cast<AxisBits>(1U << axis);
    inputs.home |= at_mm >= switches.home_min_mm && at_mm <= switches.home_max_mm ? bit : 0U;
    inputs.lower_limit |= at_mm <= switches.lower_limit_mm ? bit : 0U;
    inputs.upper_limit |= at_mm >= switches.upper_limit_mm ? bit : 0U;
  }
}

void SimulatedWorld::turn_spindle(double commanded_rad_s) noexcept {
  const double away = commanded_rad_s - spindle_rad_s_;
  spindle_rad_s_ = spindle_step_rad_s_ == 0.0 || std::abs(away) <= spindle_step_rad_s_
                       ? commanded_rad_s
                       : spindle_rad_s_ + std::copysign(spindle_step_rad_s_, away);
}

}  // namespace kerf::machine
