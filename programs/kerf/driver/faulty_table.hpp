// The simulated table with faults that come as planned, or as they are asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <boost/lockfree/spsc_queue.hpp>

#include "kernel/planned_fault.hpp"
#include "machine/simulated_table.hpp"

namespace kerf::program {

// Without a fault its ticks are those of the table, to the last bit.
class FaultyTable final : public machine::Machine {
 public:
  // faults: in the order of their time.
  FaultyTable(std::unique_ptr<machine::SimulatedTable> table, std::vector<PlannedFault> faults,
              double period_s);

  // At the next tick, whatever its time. One thread at a time. False: too many wait.
  bool ask(const PlannedFault& fault) noexcept { return asked_->push(fault); }

  void enable(const machine::AxisPlaces& places) noexcept override;
  void disable() noexcept override { table_->disable(); }
  void set_unhomed(machine::AxisBits axes) noexcept override { table_->set_unhomed(axes); }
  void write(const machine::Setpoint& setpoint) noexcept override;
  [[nodiscard]] machine::MachineState read() const noexcept override;

 private:
  // By the next tick.
  void break_what_is_due() noexcept;
  void apply(const PlannedFault& fault) noexcept;
  void apply_to_inputs(const PlannedFault& fault) noexcept;

  // What broken wires say in place of the table.
  struct StuckInputs {
    machine::AxisBits home_closed = 0;
    machine::AxisBits home_open = 0;
    machine::AxisBits lower_limit = 0;
    machine::AxisBits upper_limit = 0;
    bool emergency_loop_open = false;
    bool door_open = false;
    bool spindle = false;
    bool probe = false;
  };
  using Asked = boost::lockfree::spsc_queue<PlannedFault, boost::lockfree::capacity<16>>;

  std::unique_ptr<machine::SimulatedTable> table_;
  std::vector<PlannedFault> planned_;
  double period_s_;
  std::unique_ptr<Asked> asked_ = std::make_unique<Asked>();
  std::size_t next_ = 0;  // of planned_
  std::int64_t ticks_ = 0;
  StuckInputs stuck_{};
};

}  // namespace kerf::program
