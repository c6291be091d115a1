// What is known of one cause of an error or a warning: its identifier and the words of its page in
// docs/errors.md, which is generated from these.
#pragma once

#include <kerf/diagnostic.hpp>

namespace kerf::diagnostics {

using kerf::ErrorPage;
using kerf::Repeated;
using kerf::Severity;

}  // namespace kerf::diagnostics

namespace kerf::errors {

using diagnostics::ErrorPage;
using diagnostics::Repeated;
using diagnostics::Severity;

}  // namespace kerf::errors
