#include "machine/simulated_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::machine {
namespace {

TableSettings valid_or_default(const TableSettings& settings) {
  return is_valid(settings) ? settings : TableSettings{};
}

bool positive(double value) {
  return value > 0.0 && std::isfinite(value);
}
bool not_negative(double value) {
  return value >= 0.0 && std::isfinite(value);
}

bool is_valid_axis(const AxisDrive& axis) {
  return axis.travel.min_mm < axis.travel.max_mm && positive(axis.drive_velocity_mm_s) &&
         positive(axis.drive_acceleration_mm_s2) && positive(axis.screw_lead_mm) &&
         axis.counts_per_rev > 0.0 && positive(axis.position_gain_per_s) &&
         positive(axis.velocity_gain_per_s) && not_negative(axis.velocity_integral_per_s2) &&
         axis.feed_forward >= 0.0 && axis.feed_forward <= 1.0 &&
         not_negative(axis.coulomb_friction_mm_s2) && not_negative(axis.viscous_friction_per_s) &&
         positive(axis.max_following_error_mm);
}

}  // namespace

bool is_valid(const TableSettings& settings) noexcept {
  return settings.period_s >= 1e-5 && settings.period_s <= 0.1 &&
         std::all_of(settings.axes.begin(), settings.axes.end(), is_valid_axis) &&
         std::all_of(settings.extra.begin(), settings.extra.end(),
                     [](const AuxiliaryTravel& t) { return t.min_rad_mm < t.max_rad_mm; });
}

SimulatedTable::SimulatedTable(const TableSettings& settings, const SimulationSettings& world,
                               std::vector<ToolOffset> tools)
    : settings_(valid_or_default(settings)),
      gate_(settings_),
      axes_{AxisModel(settings_.axes[0], settings_.period_s),
            AxisModel(settings_.axes[1], settings_.period_s),
            AxisModel(settings_.axes[2], settings_.period_s)},
      world_(world, std::move(tools), settings_.period_s),
      valid_(is_valid(settings)) {}

void SimulatedTable::enable(const AxisPlaces& places) noexcept {
  if (!valid_) {
    return;
  }
  if (const auto refusal = SetpointGate::refusal(places)) {
    state_.fault = DriveFault::none;
    fault(refusal->why, refusal->axis);
    return;
  }
  commanded_mm_ = places.mm;
  path_.restart(places.mm);
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    axes_[axis].reset(places.mm[axis]);
  }
  state_ = {.actual_mm = places.mm, .extra_rad_mm = places.extra_rad_mm};
  state_.axes.fill(AxisState::on);
  observe();
  world_.restart(true_place_mm(), state_);
}

void SimulatedTable::disable() noexcept {
  if (state_.fault == DriveFault::none) {
    fault(DriveFault::not_enabled, -1);
  }
}

void SimulatedTable::write(const Setpoint& setpoint) noexcept {
  if (state_.fault == DriveFault::none && accepts(setpoint)) {
    commanded_mm_ = setpoint.position_mm;
    state_.extra_rad_mm = setpoint.extra_rad_mm;
    state_.outputs = setpoint.outputs;
    path_.append(commanded_mm_);
    AxisModel::follow_together(axes_, commanded_mm_);
  } else {
    stop_axes();
  }
  observe();
  world_.feel(true_place_mm(), state_);
}

Position SimulatedTable::true_place_mm() const noexcept {
  return {axes_[0].position_mm(), axes_[1].position_mm(), axes_[2].position_mm()};
}

void SimulatedTable::stop_axes() noexcept {
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    axes_[axis].stop();
    if (state_.axes[axis] == AxisState::stopping && axes_[axis].is_stopped()) {
      state_.axes[axis] = AxisState::off;
    }
  }
}

void SimulatedTable::fail_encoder(std::size_t axis, EncoderFailure failure,
                                  double jump_mm) noexcept {
  if (axis < axes_.size()) {
    axes_[axis].fail_encoder(failure, jump_mm);
  }
}

void SimulatedTable::weaken(std::size_t axis) noexcept {
  if (axis < axes_.size()) {
    axes_[axis].weaken();
  }
}

void SimulatedTable::jam(std::size_t axis) noexcept {
  if (axis < axes_.size()) {
    axes_[axis].jam();
  }
}

void SimulatedTable::trip(std::size_t axis) noexcept {
  if (axis < axes_.size()) {
    fault(DriveFault::drive_tripped, static_cast<std::int8_t>(axis));
  }
}

// In a period; more than the motor can be driven to, by what friction and load may add.
double SimulatedTable::longest_step_mm(std::size_t axis) const noexcept {
  const AxisDrive& drive = settings_.axes[axis];
  return 1.25 * drive.drive_velocity_mm_s * settings_.period_s +
         2.0 * drive.screw_lead_mm / drive.counts_per_rev;
}

bool SimulatedTable::accepts(const Setpoint& setpoint) noexcept {
  const auto refusal = gate_.refusal(setpoint);
  if (refusal) {
    fault(refusal->why, refusal->axis);
  }
  return !refusal;
}

void SimulatedTable::observe() noexcept {
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const double actual_mm = axes_[axis].encoder_mm();
    if (!std::isfinite(actual_mm)) {
      fault(DriveFault::not_finite, static_cast<std::int8_t>(axis));
      continue;
    }
    if (std::abs(actual_mm - state_.actual_mm[axis]) > longest_step_mm(axis)) {
      fault(DriveFault::encoder_jump, static_cast<std::int8_t>(axis));
    }
    state_.actual_mm[axis] = actual_mm;
    state_.following_error_mm[axis] = commanded_mm_[axis] - actual_mm;
    const double most_mm = settings_.axes[axis].max_following_error_mm;
    if (state_.axes[axis] == AxisState::on && std::abs(state_.following_error_mm[axis]) > most_mm) {
      fault(DriveFault::following_error, static_cast<std::int8_t>(axis));
    }
  }
  state_.contour_error_mm = path_.distance_mm(state_.actual_mm);
}

// The first fault stays until enable(). Every axis takes as long to rest as the slowest one.
void SimulatedTable::fault(DriveFault kind, std::int8_t axis) noexcept {
  if (state_.fault != DriveFault::none && state_.fault != DriveFault::not_enabled) {
    return;
  }
  state_.fault = kind;
  state_.fault_axis = axis;
  interp::apply({.kind = interp::OutputChangeKind::all_off}, state_.outputs);
  double ramp_s = 0.0;
  for (const AxisModel& model : axes_) {
    ramp_s = std::max(ramp_s, model.stopping_time_s());
  }
  for (AxisModel& model : axes_) {
    model.begin_stop(ramp_s);
  }
  state_.axes.fill(AxisState::off);  // those without drives are at rest at once
  std::fill_n(state_.axes.begin(), axes_.size(), AxisState::stopping);
}

}  // namespace kerf::machine
