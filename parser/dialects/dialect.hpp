// Which control's language a program is written in.
#pragma once

#include <kerf/program_data.hpp>

namespace kerf::parser {

using kerf::Dialect;

}  // namespace kerf::parser
