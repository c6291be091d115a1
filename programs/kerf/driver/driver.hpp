// The machine that a run drives, by its name, and the record of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "kernel/driver_settings.hpp"
#include "machine/machine.hpp"
#include "programs/kerf/driver/faulty_table.hpp"
#include "programs/kerf/driver/machine_record.hpp"
#include "programs/kerf/driver/recording_machine.hpp"

namespace kerf::program {

struct DriverOrder {
  const DriverSettings& driver;
  const MachineSettings& settings;
  std::string record_file{};  // to write; empty: none
  std::string replay_file{};  // in place of the driver; empty: none
  bool has_clock = false;
};

class Driver {
 public:
  // Error: why there is none.
  static tl::expected<Driver, std::string> open(const DriverOrder& order);

  // Not enabled yet.
  [[nodiscard]] machine::Machine& machine() noexcept { return *machine_; }
  // It says what its inputs are. What the simulated table's are is for who watches it to say; a
  // record that is replayed says what followed from them.
  [[nodiscard]] bool has_inputs() const noexcept { return table_ == nullptr && replay_ == nullptr; }
  // Breaks something at the next tick. One thread at a time. False: it is no simulated table, or
  // too many faults wait.
  [[nodiscard]] bool break_down(const PlannedFault& fault) noexcept {
    return table_ != nullptr && table_->ask(fault);
  }
  // An earlier run left this behind.
  [[nodiscard]] std::vector<std::string> warnings() const;
  // After the last tick, with what the planning side did, where that is to be kept. Error: why the
  // record is not whole.
  [[nodiscard]] std::optional<std::string> finish(std::string_view plan_record);
  // Of a record that is replayed: how many calls of it never came.
  [[nodiscard]] std::size_t calls_left() const noexcept;

 private:
  Driver() = default;

  std::string record_file_;
  std::unique_ptr<RecordWriter> record_;
  const ReplayingMachine* replay_ = nullptr;  // of machine_, as table_
  FaultyTable* table_ = nullptr;
  std::unique_ptr<machine::Machine> machine_;
};

}  // namespace kerf::program
