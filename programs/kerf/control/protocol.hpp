// The JSON lines of `kerf run --control` (docs/control-protocol.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <kerf/controller.hpp>
#include <tl/expected.hpp>

#include "parser/moves/auxiliary_axes.hpp"
#include "programs/kerf/exit_status.hpp"

namespace kerf::program {

inline constexpr int kControlVersion = 1;

// What a client asks for. What it does not name stays as it is.
struct ControlRequest {
  enum class Kind : std::uint8_t {
    command,
    override,
    single_block,
    optional_stop,
    block_delete,
    status,
    events
  };
  Kind kind = Kind::command;
  kerf::Command command{};  // of all kinds but status and events
  std::optional<double> feed{};
  std::optional<double> rapid{};
  std::optional<double> spindle{};
  bool on = false;                  // of single_block and optional_stop
  BlockDelete switches{};           // of block_delete
  std::optional<double> every_s{};  // of a status: again and again; 0: no more
  std::uint64_t since = 0;          // of events
  std::string name{};               // of the command, as the client wrote it
  std::string id{"null"};           // JSON; goes back with the answer
};

struct BadRequest {
  std::string reason;
  std::string id{"null"};
};
tl::expected<ControlRequest, BadRequest> control_request(std::string_view line);

// Each is one object on one line, with its '\n'.
std::string hello_json(std::string_view file);
std::string accepted_json(const ControlRequest& request, ControllerState state);
std::string refused_json(const ControlRequest& request, ControllerState state,
                         std::string_view reason);
std::string bad_request_json(const BadRequest& request, ControllerState state);
// message: of an event that is one; nothing: it is forgotten.
std::string event_json(const ControllerEvent& event, const std::optional<ProgramMessage>& message);
std::string status_json(const ControllerStatus& status, parser::Letters extra);
std::string end_json(ExitStatus status);

}  // namespace kerf::program
