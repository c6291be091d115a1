// An error or a warning about the program's text, as a value.
#pragma once

#include <kerf/diagnostic.hpp>

#include "diagnostics/excerpt.hpp"
#include "diagnostics/source_position.hpp"

namespace kerf::diagnostics {

using kerf::Diagnostic;
using kerf::ErrorPage;
using kerf::identifier;
using kerf::Severity;
using kerf::to_string;
using kerf::to_text;

}  // namespace kerf::diagnostics
