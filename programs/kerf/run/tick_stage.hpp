// One tick: from its setpoint to the machine and into the statistics.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include <kerf/machine.hpp>
#include <kerf/program_inputs.hpp>

#include "kernel/run_statistics.hpp"
#include "machine/machine.hpp"
#include "programs/kerf/report/tick_record.hpp"
#include "programs/kerf/report/time_split.hpp"
#include "programs/kerf/run/flight_recorder.hpp"
#include "programs/kerf/run/machine_watch.hpp"

namespace kerf::program {

class TickStage {
 public:
  struct Order {
    const MachineSettings& settings;
    ToolChange tool_change = ToolChange::takes_none;
    double spindle_timeout_s = 5.0;
    bool keeps_flight = false;  // flight() is wanted
  };
  TickStage(const Order& order, machine::Machine& machine)
      : machine_(&machine),
        watch_(order.spindle_timeout_s, order.settings.limits.period_s),
        flight_(order.keeps_flight ? order.settings.limits.period_s
                                   : std::numeric_limits<double>::infinity()),
        statistics_(order.settings.limits.period_s, order.settings.program.extra_axes != 0),
        time_(order.tool_change) {}

  // Real time, as take().
  void enable(const machine::AxisPlaces& places) noexcept {
    machine_->enable(places);
    state_ = machine_->read();
  }
  void disable() noexcept { machine_->disable(); }
  void set_unhomed(machine::AxisBits axes) noexcept { machine_->set_unhomed(axes); }

  // Real time: allocates nothing, takes no lock, throws nothing.
  TickRecord take(const Setpoint& setpoint, const TickDetail& detail) noexcept {
    tell(setpoint);
    const machine::MachineState& state = state_;
    statistics_.add(setpoint, state);
    if (state.inputs.emergency_loop_open && !emergency_) {
      emergency_ = EmergencyLoop{.line = setpoint.line, .tick = setpoint.tick};
    }
    TickRecord record = record_of(setpoint, detail, state);
    if (kind_of(record) == TickKind::rest) {
      record.rapid = was_rapid_;  // the way to the rest is still that of the motion
    }
    was_rapid_ = record.rapid;
    time_.add(record);
    flight_.add(record);
    return record;
  }

  // After the last tick, which is at rest: setpoints there follow, one a call of `next_period`,
  // until the machine has answered to it. A fault that is found so is the run's.
  template <typename NextPeriod>
  void hear_out(Setpoint last, const NextPeriod& next_period) noexcept {
    const std::int64_t tick = last.tick;
    last.v_mm_s = last.a_mm_s2 = last.j_mm_s3 = 0.0;
    last.velocity_mm_s = last.acceleration_mm_s2 = {};
    while (fault_.kind == machine::DriveFault::none && follows() && !machine_->has_answered(tick)) {
      next_period();
      ++last.tick;
      tell(last);
    }
  }

  // As of the latest tick.
  [[nodiscard]] const machine::MachineInputs& inputs() const noexcept { return state_.inputs; }
  // Of the latest tick, or of enable().
  [[nodiscard]] ProgramInputs program_inputs() const noexcept {
    return {.probe = state_.inputs.probe,
            .actual_mm = state_.actual_mm,
            .has_latched = state_.has_latched,
            .latched_mm = state_.latched_mm,
            .digital = state_.inputs.digital,
            .analog = state_.inputs.analog,
            .spindle_at_speed = state_.inputs.spindle_at_speed};
  }
  // Axes are coming to rest because of a fault.
  [[nodiscard]] bool is_stopping() const noexcept { return has(machine::AxisState::stopping); }
  // Setpoints count.
  [[nodiscard]] bool follows() const noexcept { return has(machine::AxisState::on); }
  [[nodiscard]] const RunStatistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] TimeSplit time_split() const noexcept { return time_.split(); }
  // The first one, which stays.
  [[nodiscard]] const MachineFault& fault() const noexcept { return fault_; }
  // The drives can still be brought to rest by setpoints in time: the machine asks for it.
  [[nodiscard]] bool stops_on_path() const noexcept {
    return follows() && state_.fault == fault_.kind;
  }
  // Where the loop of the emergency stop was found open.
  struct EmergencyLoop {
    std::uint32_t line = 0;
    std::int64_t tick = 0;
  };
  [[nodiscard]] const std::optional<EmergencyLoop>& emergency() const noexcept {
    return emergency_;
  }
  [[nodiscard]] const FlightRecorder& flight() const noexcept { return flight_; }

 private:
  void tell(const Setpoint& setpoint) noexcept {
    machine_->write(setpoint);
    state_ = machine_->read();
    if (const MachineFault seen = watch_.look(setpoint, state_);
        fault_.kind == machine::DriveFault::none) {
      fault_ = seen;
    }
  }
  [[nodiscard]] bool has(machine::AxisState wanted) const noexcept {
    return std::find(state_.axes.begin(), state_.axes.end(), wanted) != state_.axes.end();
  }

  machine::Machine* machine_;
  machine::MachineState state_{};
  MachineWatch watch_;
  FlightRecorder flight_;
  RunStatistics statistics_;
  TimeAccount time_;
  bool was_rapid_ = false;
  MachineFault fault_{};
  std::optional<EmergencyLoop> emergency_;
};

}  // namespace kerf::program
