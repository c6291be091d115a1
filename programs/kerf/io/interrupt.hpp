// Signals as a question: has somebody asked us to stop?
#pragma once

#include <optional>

#include "programs/kerf/exit_status.hpp"

namespace kerf::program {

// From now on SIGINT, SIGTERM and SIGHUP are requests to stop; a second one ends the process at
// once. SIGPIPE and SIGXFSZ are ignored: a closed pipe or a full quota is an error of that write
// and nothing else.
void install_signal_handlers();

// The status that the first request asks for. Safe in every thread; one atomic load.
[[nodiscard]] std::optional<ExitStatus> stop_requested() noexcept;

}  // namespace kerf::program
