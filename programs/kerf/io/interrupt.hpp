// Signals as a question: has somebody asked us to stop?
#pragma once

#include <optional>

#include "programs/kerf/exit_status.hpp"

namespace kerf::program {

// From now on SIGINT, SIGQUIT (the terminal's Ctrl-\: without a way to rest it would leave a
// machine in motion), SIGTERM and, unless it is ignored by then, SIGHUP are requests to stop; a
// second one ends the process at once, with the terminal as it was. SIGPIPE and SIGXFSZ are
// ignored: a closed pipe or a full quota is an error of that write and nothing else.
void install_signal_handlers();

// From now on the second request is one for an emergency stop, and the third ends the process.
void expect_emergency_stop() noexcept;
[[nodiscard]] bool emergency_stop_requested() noexcept;

// The status that the first request asks for. Safe in every thread; one atomic load.
[[nodiscard]] std::optional<ExitStatus> stop_requested() noexcept;

}  // namespace kerf::program
