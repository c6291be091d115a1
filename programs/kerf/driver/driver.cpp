#include "programs/kerf/driver/driver.hpp"

#include "machine/simulated_table.hpp"

namespace kerf::program {

tl::expected<std::unique_ptr<machine::Machine>, std::string> open_driver(
    const DriverSettings& driver, const MachineSettings& settings) {
  if (driver.name == "simulated") {
    return std::make_unique<machine::SimulatedTable>(settings.table);
  }
  return tl::unexpected("there is no driver '" + driver.name + "'");
}

}  // namespace kerf::program
