#include "programs/kerf/driver/driver.hpp"

#include <vector>

#include "programs/kerf/driver/loopback_machine.hpp"

namespace kerf::program {

namespace {

using Made = tl::expected<std::unique_ptr<machine::Machine>, std::string>;

std::vector<machine::ToolOffset> tools_of(const MachineSettings& settings) {
  std::vector<machine::ToolOffset> tools;
  for (const Tool& tool : settings.program.tools.listed()) {
    tools.push_back({.tool = tool.number, .offset_mm = tool.offset_mm});
  }
  return tools;
}

Made named_machine(const DriverOrder& order) {
  if (order.driver.name == "loopback") {
    if (order.driver.socket.empty()) {
      return tl::unexpected(
          std::string("the driver loopback needs a socket in [driver] of the machine file"));
    }
    return LoopbackMachine::open({.socket = order.driver.socket,
                                  .timeout_s = order.driver.timeout_s,
                                  .table = order.settings.table});
  }
  return tl::unexpected("there is no driver '" + order.driver.name + "'");
}

}  // namespace

tl::expected<Driver, std::string> Driver::open(const DriverOrder& order) {
  Driver driver;
  if (order.replay_file.empty() && order.driver.name == "simulated") {
    auto table = std::make_unique<FaultyTable>(
        std::make_unique<machine::SimulatedTable>(order.settings.table, order.settings.simulation,
                                                  tools_of(order.settings)),
        order.driver.faults, order.settings.limits.period_s);
    driver.table_ = table.get();
    driver.machine_ = std::move(table);
  } else if (order.replay_file.empty()) {
    auto made = named_machine(order);
    if (!made) {
      return tl::unexpected(made.error());
    }
    driver.machine_ = *std::move(made);
  } else {
    auto record = RecordReader::open(order.replay_file, order.settings.limits.period_s);
    if (!record) {
      return tl::unexpected(record.error());
    }
    auto replay = std::make_unique<ReplayingMachine>(*std::move(record));
    driver.replay_ = replay.get();
    driver.machine_ = std::move(replay);
  }
  if (order.record_file.empty()) {
    return driver;
  }
  auto record = RecordWriter::create(
      order.record_file, order.settings.limits.period_s,
      order.has_clock ? RecordWriter::WhenFull::drop : RecordWriter::WhenFull::wait);
  if (!record) {
    return tl::unexpected(record.error());
  }
  driver.record_file_ = order.record_file;
  driver.record_ = *std::move(record);
  driver.machine_ = std::make_unique<RecordingMachine>(std::move(driver.machine_), *driver.record_);
  return driver;
}

std::vector<std::string> Driver::warnings() const {
  if (record_ == nullptr || !record_->follows_incomplete()) {
    return {};
  }
  return {"an earlier run did not end cleanly: its " + record_file_ + ".incomplete is replaced"};
}

std::optional<std::string> Driver::finish(std::string_view plan_record) {
  return record_ == nullptr ? std::nullopt : record_->finish(plan_record);
}

std::size_t Driver::calls_left() const noexcept {
  return replay_ == nullptr ? 0 : replay_->calls_left();
}

}  // namespace kerf::program
