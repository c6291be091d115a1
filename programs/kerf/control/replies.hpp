// What `kerf run --control` writes to its clients (docs/control-protocol.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <kerf/controller.hpp>

#include "parser/moves/auxiliary_axes.hpp"
#include "programs/kerf/control/request.hpp"
#include "programs/kerf/exit_status.hpp"

namespace kerf::program {

inline constexpr int kControlVersion = 1;

// Each is one object on one line, with its '\n'.
std::string hello_json(std::string_view file);
std::string accepted_json(const ControlRequest& request, ControllerState state);
std::string refused_json(const ControlRequest& request, ControllerState state,
                         std::string_view reason);
std::string bad_request_json(const BadRequest& request, ControllerState state);
// message: of an event that is one; nothing: it is forgotten.
std::string event_json(const ControllerEvent& event, const std::optional<ProgramMessage>& message);
// id: JSON, of the request; "null": it had none.
std::string status_json(std::string_view id, const ControllerStatus& status, parser::Letters extra);
std::string end_json(ExitStatus status);

}  // namespace kerf::program
