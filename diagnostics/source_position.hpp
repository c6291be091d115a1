// A place in the text of a program.
#pragma once

#include <kerf/diagnostic.hpp>

namespace kerf::diagnostics {

using kerf::SourcePosition;

}  // namespace kerf::diagnostics
