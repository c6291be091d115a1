// One tick: from its setpoint to the table and into the statistics.
#pragma once

#include <kerf/machine.hpp>

#include "kernel/run_statistics.hpp"
#include "machine/simulated_table.hpp"
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
  TickStage(const MachineSettings& settings, const curves::Position& start_mm)
      : table_(settings.table),
        statistics_(settings.limits.period_s, settings.program.extra_axes != 0) {
    table_.enable(start_mm);
  }

  // Real time: allocates nothing, takes no lock, throws nothing.
  TickRecord take(const Setpoint& setpoint, const TickDetail& detail) noexcept {
    table_.write(setpoint);
    const machine::MachineState state = table_.read();
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

  [[nodiscard]] const RunStatistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] TimeSplit time_split() const noexcept { return time_.split(); }
  [[nodiscard]] const MachineFault& fault() const noexcept { return fault_; }

 private:
  machine::SimulatedTable table_;
  RunStatistics statistics_;
  TimeAccount time_;
  MachineFault fault_{};
};

}  // namespace kerf::program
