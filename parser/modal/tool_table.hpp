// The tools that a machine has, and their offsets.
#pragma once

#include <kerf/program_data.hpp>

namespace kerf::parser {

using kerf::read_tool_table;
using kerf::Tool;
using kerf::ToolTable;
using kerf::ToolTableError;

}  // namespace kerf::parser
