// Machines that write a record of a run, and that answer as a record says.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "machine/machine.hpp"
#include "programs/kerf/driver/machine_record.hpp"

namespace kerf::program {

// Another machine, and a record of what it is told and answers.
class RecordingMachine final : public machine::Machine {
 public:
  RecordingMachine(std::unique_ptr<machine::Machine> inner, RecordWriter& record) noexcept
      : inner_(std::move(inner)), record_(&record) {}

  void enable(const machine::AxisPlaces& places) noexcept override;
  void disable() noexcept override;
  void set_unhomed(machine::AxisBits axes) noexcept override { inner_->set_unhomed(axes); }
  void write(const machine::Setpoint& setpoint) noexcept override;
  [[nodiscard]] machine::MachineState read() const noexcept override { return inner_->read(); }
  [[nodiscard]] bool has_answered(std::int64_t tick) const noexcept override {
    return inner_->has_answered(tick);
  }

 private:
  void keep(const ToldFrame& told) noexcept;

  std::unique_ptr<machine::Machine> inner_;
  RecordWriter* record_;
};

// Answers as the machine of the record did, as long as it is told the same, bit for bit: the first
// difference is the fault another_run.
class ReplayingMachine final : public machine::Machine {
 public:
  explicit ReplayingMachine(RecordReader record) noexcept : record_(std::move(record)) {}

  void enable(const machine::AxisPlaces& places) noexcept override;
  void disable() noexcept override;
  void write(const machine::Setpoint& setpoint) noexcept override;
  [[nodiscard]] machine::MachineState read() const noexcept override { return state_; }
  // Not where the record goes on with setpoints.
  [[nodiscard]] bool has_answered(std::int64_t tick) const noexcept override;

  // Calls of the record that have not come.
  [[nodiscard]] std::size_t calls_left() const noexcept {
    return record_.calls().size() - std::min(next_, record_.calls().size());
  }

 private:
  void follow(const ToldFrame& told) noexcept;

  RecordReader record_;
  std::size_t next_ = 0;
  machine::MachineState state_{.fault = machine::DriveFault::not_enabled};
};

}  // namespace kerf::program
