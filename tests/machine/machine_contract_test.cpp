// The simulated table owes what every machine does.
#include "tests/machine/machine_contract.hpp"

#include <memory>
#include <string>

#include "machine/simulated_table.hpp"
#include "tests/machine/tables.hpp"

namespace kerf::machine::test {
namespace {

INSTANTIATE_TEST_SUITE_P(Machines, MachineContract,
                         testing::Values(NamedMaker{
                             "Simulated", [] { return std::make_unique<SimulatedTable>(real()); }}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace kerf::machine::test
