// One tick: from its setpoint to the machine and into the statistics.
#pragma once

#include <algorithm>

#include <kerf/machine.hpp>

#include "kernel/run_statistics.hpp"
#include "machine/machine.hpp"
#include "programs/kerf/report/tick_record.hpp"
#include "programs/kerf/report/time_split.hpp"

namespace kerf::program {

struct MachineFault {
  machine::DriveFault kind = machine::DriveFault::none;
  std::int8_t axis = -1;
  std::uint32_t line = 0;
  std::int64_t tick = 0;
};

class TickStage {
 public:
  TickStage(const MachineSettings& settings, machine::Machine& machine)
      : machine_(&machine),
        statistics_(settings.limits.period_s, settings.program.extra_axes != 0) {}

  // Real time, as take().
  void enable(const machine::AxisPlaces& places) noexcept { machine_->enable(places); }
  void disable() noexcept { machine_->disable(); }

  // Real time: allocates nothing, takes no lock, throws nothing.
  TickRecord take(const Setpoint& setpoint, const TickDetail& detail) noexcept {
    machine_->write(setpoint);
    state_ = machine_->read();
    const machine::MachineState& state = state_;
    statistics_.add(setpoint, state);
    if (state.fault != machine::DriveFault::none && fault_.kind == machine::DriveFault::none) {
      fault_ = {.kind = state.fault,
                .axis = state.fault_axis,
                .line = setpoint.line,
                .tick = setpoint.tick};
    }
    const TickRecord record = record_of(setpoint, detail, state);
    time_.add(record);
    return record;
  }

  // As of the latest tick.
  [[nodiscard]] const machine::MachineInputs& inputs() const noexcept { return state_.inputs; }
  // Axes are coming to rest because of a fault.
  [[nodiscard]] bool is_stopping() const noexcept { return has(machine::AxisState::stopping); }
  // Setpoints count.
  [[nodiscard]] bool follows() const noexcept { return has(machine::AxisState::on); }
  [[nodiscard]] const RunStatistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] TimeSplit time_split() const noexcept { return time_.split(); }
  [[nodiscard]] const MachineFault& fault() const noexcept { return fault_; }

 private:
  [[nodiscard]] bool has(machine::AxisState wanted) const noexcept {
    return std::find(state_.axes.begin(), state_.axes.end(), wanted) != state_.axes.end();
  }

  machine::Machine* machine_;
  machine::MachineState state_{};
  RunStatistics statistics_;
  TimeAccount time_;
  MachineFault fault_{};
};

}  // namespace kerf::program
