// Everything a machine file says.
#pragma once

#include <string>

#include "lookahead/path/limits.hpp"
#include "machine/table_settings.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/modal/machine_data.hpp"
#include "profiles/profile.hpp"

namespace kerf {

struct MachineSettings {
  lookahead::PlanLimits limits{};
  machine::TableSettings table{};
  parser::Dialect dialect = parser::Dialect::rs274;  // of its programs, unless told otherwise
  parser::MachineData program{};  // offsets and tools, where a program starts from
  // A tool table that the file names but does not hold; empty: none. Whoever opens files reads it.
  std::string tool_file{};
};

}  // namespace kerf
