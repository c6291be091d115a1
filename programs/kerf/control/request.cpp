#include "programs/kerf/control/request.hpp"

#include <string>

#include "programs/kerf/control/request_keys.hpp"
#include "programs/kerf/control/request_text.hpp"

namespace kerf::program {

namespace {

using Kind = ControlRequest::Kind;

constexpr double kPercent = 0.01;

void share_of(std::optional<double>& percent) {
  if (percent) {
    *percent *= kPercent;
  }
}

// A run has its drives on from its start to its end.
bool is_for_a_run(kerf::Command command) {
  return command != kerf::Command::enable && command != kerf::Command::disable &&
         command != kerf::Command::reset;
}

Kind kind_of(kerf::Command command) {
  switch (command) {
    case kerf::Command::override:
      return Kind::override;
    case kerf::Command::single_block:
      return Kind::single_block;
    case kerf::Command::optional_stop:
      return Kind::optional_stop;
    case kerf::Command::block_delete:
      return Kind::block_delete;
    case kerf::Command::mdi:
      return Kind::mdi;
    case kerf::Command::jog:
      return Kind::jog;
    default:
      return Kind::command;
  }
}

// False: there is no such command.
bool find_command(ControlRequest& request) {
  for (std::size_t i = 0; i < kCommands; ++i) {
    const auto command = static_cast<kerf::Command>(i);
    if (is_for_a_run(command) && key_of_name(name_of(command)) == request.name) {
      request.command = command;
      request.kind = kind_of(command);
      return true;
    }
  }
  request.kind = request.name == "status"  ? Kind::status
                 : request.name == "input" ? Kind::input
                 : request.name == "fault" ? Kind::fault
                 : request.name == "tool"  ? Kind::tool
                                           : Kind::events;
  return request.kind != Kind::events || request.name == "events";
}

std::string read_input(RequestKeys& keys, ControlRequest& request) {
  keys.read("analog", request.analog);
  keys.read("digital", request.digital);
  std::optional<double> value;
  keys.read("value", value);
  if (keys.has("analog") == keys.has("digital") || !keys.has("value")) {
    return "input takes analog or digital, a number, and value";
  }
  request.value = value.value_or(0.0);
  if (keys.has("digital") && request.value != 0.0 && request.value != 1.0) {
    return "the value of a digital input is 0 or 1";
  }
  return keys.complaint();
}

// Distances are of a step, velocities of a jog that goes on.
std::string read_jog(RequestKeys& keys, ControlRequest& request) {
  constexpr std::string_view kAxes = "xyzabcuvw";
  constexpr std::size_t kLinear = 3;
  constexpr double kRad = 3.14159265358979323846 / 180.0;  // of a degree
  Jog& jog = request.jog;
  bool goes_on = false;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const bool turns = axis >= kLinear && axis < 2 * kLinear;
    const std::string key = kAxes[axis] + std::string(turns ? "_deg" : "_mm");
    double& value = axis < kLinear ? jog.mm[axis] : jog.extra_rad_mm[axis - kLinear];
    std::optional<double> number;
    jog.is_step = jog.is_step || keys.has(key.c_str());
    goes_on = goes_on || keys.has((key + "_s").c_str());
    keys.read(key.c_str(), number);
    keys.read((key + "_s").c_str(), number);
    value = number.value_or(0.0) * (turns ? kRad : 1.0);
  }
  std::optional<double> velocity_mm_s;
  keys.read("velocity_mm_s", velocity_mm_s);
  jog.step_mm_s = velocity_mm_s.value_or(jog.step_mm_s);
  if (jog.is_step == goes_on || (goes_on && velocity_mm_s)) {
    return "jog takes distances, as x_mm, and perhaps velocity_mm_s, or velocities, as x_mm_s";
  }
  return keys.complaint();
}

std::string read_fault(RequestKeys& keys, ControlRequest& request) {
  std::string kind;
  std::string axis;
  std::optional<double> jump_mm;
  keys.read("fault", kind);
  keys.read("axis", axis);
  keys.read("jump_mm", jump_mm);
  if (std::string complaint = keys.complaint(); !complaint.empty()) {
    return complaint;
  }
  const auto fault = planned_fault({.kind = kind, .axis = axis});
  if (!fault) {
    return fault.error();
  }
  request.fault = *fault;
  request.fault.jump_mm = jump_mm.value_or(request.fault.jump_mm);
  return "";
}

std::string read_tool(RequestKeys& keys, ControlRequest& request) {
  std::optional<std::uint64_t> number;
  std::optional<double> length_mm;
  std::optional<double> diameter_mm;
  keys.read("number", number);
  keys.read("length_mm", length_mm);
  keys.read("diameter_mm", diameter_mm);
  if (!keys.has("number") || !keys.has("length_mm")) {
    return "tool takes number and length_mm, and perhaps diameter_mm";
  }
  if (number.value_or(0) > ToolTable::kHighestNumber) {
    return "number is to be 0 to 99999";
  }
  request.tool = {.number = static_cast<std::int32_t>(number.value_or(0)),
                  .length_mm = length_mm.value_or(0.0),
                  .diameter_mm = diameter_mm};
  return keys.complaint();
}

std::string read_override(RequestKeys& keys, ControlRequest& request) {
  keys.read("feed_percent", request.feed);
  keys.read("rapid_percent", request.rapid);
  keys.read("spindle_percent", request.spindle);
  share_of(request.feed);
  share_of(request.rapid);
  share_of(request.spindle);
  return keys.complaint();
}

std::string read_status(RequestKeys& keys, ControlRequest& request) {
  keys.read("every_s", request.every_s);
  if (request.every_s && !(*request.every_s >= 0.0 && *request.every_s <= 3600.0)) {
    return "every_s is to be 0 to 3600";
  }
  return keys.complaint();
}

std::string read_request(RequestKeys& keys, ControlRequest& request) {
  keys.read("command", request.name);
  if (!keys.has("command")) {
    return "an object with a command is wanted";
  }
  if (!find_command(request)) {
    return "there is no such command";
  }
  switch (request.kind) {
    case Kind::override:
      return read_override(keys, request);
    case Kind::single_block:
    case Kind::optional_stop:
      keys.read("on", request.on);
      return keys.has("on") ? keys.complaint() : request.name + " takes on, true or false";
    case Kind::block_delete:
      keys.read("switches", request.switches);
      return keys.has("switches") ? keys.complaint() : "block_delete takes switches, as in [1, 3]";
    case Kind::mdi:
      keys.read("line", request.line);
      return keys.has("line") ? keys.complaint() : "mdi takes line, a string";
    case Kind::jog:
      return read_jog(keys, request);
    case Kind::input:
      return read_input(keys, request);
    case Kind::fault:
      return read_fault(keys, request);
    case Kind::tool:
      return read_tool(keys, request);
    case Kind::status:
      return read_status(keys, request);
    case Kind::events:
      keys.read("since", request.since);
      return keys.complaint();
    case Kind::command:
      return keys.complaint();
  }
  return keys.complaint();
}

}  // namespace

std::string key_of_name(std::string_view name) {
  std::string key(name);
  for (char& letter : key) {
    letter = letter == ' ' ? '_' : letter;
  }
  return key;
}

tl::expected<ControlRequest, BadRequest> control_request(std::optional<std::string_view> line) {
  if (!line) {
    return tl::unexpected(BadRequest{.reason = "the line is longer than 65,536 bytes"});
  }
  auto object = request_object(*line);
  if (!object) {
    return tl::unexpected(BadRequest{.reason = object.error()});
  }
  ControlRequest request;
  if (const auto id = object->find("id"); id != object->end()) {
    request.id = id->dump(-1, ' ', true, RequestKeys::Json::error_handler_t::replace);
    object->erase("id");
  }
  RequestKeys keys(*object);
  if (std::string reason = read_request(keys, request); !reason.empty()) {
    return tl::unexpected(BadRequest{.reason = std::move(reason), .id = request.id});
  }
  return request;
}

}  // namespace kerf::program
