// One tick: from the kernel to the table and into the statistics.
#pragma once

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "kernel/run_statistics.hpp"
#include "machine/simulated_table.hpp"
#include "programs/kerf/report/tick_record.hpp"

namespace kerf::program {

struct MachineFault {
  machine::Fault kind = machine::Fault::none;
  std::int8_t axis = -1;
  std::uint32_t line = 0;
  std::int64_t tick = 0;
};

class TickStage {
 public:
  TickStage(Kernel& kernel, const MachineSettings& settings, const curves::Position& start_mm)
      : kernel_(&kernel),
        table_(settings.table),
        statistics_(settings.limits.period_s, settings.program.extra_axes != 0) {
    table_.enable(start_mm);
  }

  // Before step(), where planning has no thread of its own.
  void reach_tick() { kernel_->reach_tick(); }

  // Real time: allocates nothing, takes no lock, throws nothing.
  interp::TickStatus step(TickRecord& record) noexcept {
    interp::Setpoint setpoint;
    const interp::TickStatus status = kernel_->tick(setpoint);
    table_.write(setpoint);
    const machine::MachineState state = table_.read();
    statistics_.add(setpoint, state);
    record = record_of(setpoint, state);
    if (state.fault != machine::Fault::none && fault_.kind == machine::Fault::none) {
      fault_ = {.kind = state.fault,
                .axis = state.fault_axis,
                .line = setpoint.line,
                .tick = setpoint.tick};
    }
    return status;
  }

  [[nodiscard]] const RunStatistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] const MachineFault& fault() const noexcept { return fault_; }

 private:
  Kernel* kernel_;
  machine::SimulatedTable table_;
  RunStatistics statistics_;
  MachineFault fault_{};
};

}  // namespace kerf::program
