// Everything a machine file says.
#pragma once

#include "lookahead/limits.hpp"
#include "machine/table_settings.hpp"
#include "profiles/profile.hpp"

namespace kerf {

struct MachineSettings {
  lookahead::PlanLimits limits{};
  machine::TableSettings table{};
};

}  // namespace kerf
