// What a client of `kerf run --control` writes (docs/control-protocol.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <kerf/controller.hpp>
#include <tl/expected.hpp>

#include "kernel/planned_fault.hpp"

namespace kerf::program {

// What was measured of a tool; nothing: not that.
struct MeasuredTool {
  std::int32_t number = 0;
  double length_mm = 0.0;
  std::optional<double> diameter_mm{};
};

// What a client asks for. What it does not name stays as it is.
struct ControlRequest {
  enum class Kind : std::uint8_t {
    command,
    override,
    single_block,
    optional_stop,
    block_delete,
    mdi,
    jog,
    input,
    fault,
    tool,
    status,
    events
  };
  Kind kind = Kind::command;
  kerf::Command command{};  // of all kinds from command to jog
  std::string line{};       // of mdi
  Jog jog{};                // of jog
  std::optional<double> feed{};
  std::optional<double> rapid{};
  std::optional<double> spindle{};
  bool on = false;                        // of single_block and optional_stop
  BlockDelete switches{};                 // of block_delete
  std::optional<std::uint64_t> analog{};  // of an input: its number, and none of the other kind
  std::optional<std::uint64_t> digital{};
  double value = 0.0;               // of an input
  PlannedFault fault{};             // of a fault
  MeasuredTool tool{};              // of a tool
  std::optional<double> every_s{};  // of a status: again and again; 0: no more
  std::uint64_t since = 0;          // of events
  std::string name{};               // of the command, as the client wrote it
  std::string id{"null"};           // JSON; goes back with the answer
};

struct BadRequest {
  std::string reason;
  std::string id{"null"};
};
// Nothing: the line was too long.
tl::expected<ControlRequest, BadRequest> control_request(std::optional<std::string_view> line);

// "emergency_stop" of "emergency stop": states and commands as JSON has them.
std::string key_of_name(std::string_view name);

}  // namespace kerf::program
