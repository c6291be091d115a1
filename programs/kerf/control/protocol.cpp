#include "programs/kerf/control/protocol.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

#include "programs/kerf/report/constraint_text.hpp"
#include "programs/kerf/report/extra_axes.hpp"

namespace kerf::program {

namespace {

// Keys in the order in which they are set.
using Json = nlohmann::ordered_json;
using Kind = ControlRequest::Kind;

constexpr double kPercent = 0.01;

std::string line_of(const Json& json) {
  // Text of a program may be anything; what is no UTF-8 becomes U+FFFD.
  return json.dump(-1, ' ', true, Json::error_handler_t::replace) + '\n';
}

// "emergency_stop" of "emergency stop".
std::string key_of_name(std::string_view name) {
  std::string key(name);
  for (char& letter : key) {
    letter = letter == ' ' ? '_' : letter;
  }
  return key;
}

// Reads the keys of a request; what is wrong with the first wrong one stays.
class RequestKeys {
 public:
  explicit RequestKeys(const Json& object) : object_(object) {}

  template <typename T>
  void read(const char* key, T& value) {
    if (const Json* found = take(key)) {
      read_into(key, *found, value);
    }
  }
  [[nodiscard]] bool has(const char* key) const { return object_.contains(key); }
  [[nodiscard]] std::string complaint() const {
    if (!complaint_.empty()) {
      return complaint_;
    }
    return object_.size() > taken_ ? "a key that does not belong to the command" : "";
  }

 private:
  const Json* take(const char* key) {
    const auto found = object_.find(key);
    taken_ += found != object_.end() ? 1U : 0U;
    return found != object_.end() ? &*found : nullptr;
  }
  void complain(const char* key, const char* wanted) {
    if (complaint_.empty()) {
      complaint_ = std::string(key) + " is to be " + wanted;
    }
  }
  void read_into(const char* key, const Json& found, std::optional<double>& value) {
    if (found.is_number()) {
      value = found.get<double>();
    } else {
      complain(key, "a number");
    }
  }
  void read_into(const char* key, const Json& found, bool& value) {
    if (found.is_boolean()) {
      value = found.get<bool>();
    } else {
      complain(key, "true or false");
    }
  }
  void read_into(const char* key, const Json& found, std::uint64_t& value) {
    if (found.is_number_unsigned()) {
      value = found.get<std::uint64_t>();
    } else {
      complain(key, "a whole number of 0 or more");
    }
  }
  void read_into(const char* key, const Json& found, BlockDelete& value) {
    const auto is_switch = [](const Json& number) {
      return number.is_number_unsigned() && number.get<std::uint64_t>() >= 1 &&
             number.get<std::uint64_t>() <= BlockDelete::kSwitches;
    };
    if (!found.is_array() || !std::ranges::all_of(found, is_switch)) {
      complain(key, "numbers from 1 to 9, as in [1, 3]");
      return;
    }
    for (const Json& number : found) {
      value.switch_on(number.get<unsigned>());
    }
  }
  void read_into(const char* key, const Json& found, std::string& value) {
    if (found.is_string()) {
      value = found.get<std::string>();
    } else {
      complain(key, "a string");
    }
  }

  const Json& object_;
  std::size_t taken_ = 0;
  std::string complaint_;
};

void share_of(std::optional<double>& percent) {
  if (percent) {
    *percent *= kPercent;
  }
}

// Without what rounding adds to 110.
double percent_of(double share) {
  constexpr double kDigits = 1e6;
  return std::round(share / kPercent * kDigits) / kDigits;
}

// One program is run, from its start on: these would begin another one.
bool is_for_a_run(kerf::Command command) {
  return command != kerf::Command::enable && command != kerf::Command::disable &&
         command != kerf::Command::start && command != kerf::Command::reset;
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
  request.kind = request.name == "status" ? Kind::status : Kind::events;
  return request.name == "status" || request.name == "events";
}

std::string read_request(RequestKeys& keys, ControlRequest& request) {
  keys.read("command", request.name);
  if (!keys.has("command")) {
    return "an object with a command is wanted";
  }
  if (!find_command(request)) {
    return "there is no such command";
  }
  if (request.kind == Kind::override) {
    keys.read("feed_percent", request.feed);
    keys.read("rapid_percent", request.rapid);
    keys.read("spindle_percent", request.spindle);
    share_of(request.feed);
    share_of(request.rapid);
    share_of(request.spindle);
  } else if (request.kind == Kind::single_block || request.kind == Kind::optional_stop) {
    keys.read("on", request.on);
    if (!keys.has("on")) {
      return request.name + " takes on, true or false";
    }
  } else if (request.kind == Kind::block_delete) {
    keys.read("switches", request.switches);
    if (!keys.has("switches")) {
      return "block_delete takes switches, as in [1, 3]";
    }
  } else if (request.kind == Kind::status) {
    keys.read("every_s", request.every_s);
    if (request.every_s && !(*request.every_s >= 0.0 && *request.every_s <= 3600.0)) {
      return "every_s is to be 0 to 3600";
    }
  } else if (request.kind == Kind::events) {
    keys.read("since", request.since);
  }
  return keys.complaint();
}

Json answer_json(const std::string& id, const std::string& name, ControllerState state) {
  return {{"type", "answer"},
          {"id", Json::parse(id)},
          {"command", name.empty() ? Json() : Json(name)},
          {"state", key_of_name(name_of(state))}};
}

Json axes_json(const std::array<double, 3>& values) {
  return {{"x", values[0]}, {"y", values[1]}, {"z", values[2]}};
}

void set_position(Json& json, const Setpoint& setpoint, parser::Letters extra) {
  json["position_mm"] = axes_json(setpoint.position_mm);
  for (const ExtraAxis& axis : extra_axes(extra)) {
    json[axis.unit == "deg" ? "position_deg" : "position_mm"][std::string(axis.name)] =
        axis.factor * setpoint.extra_rad_mm[axis.index];
  }
}

}  // namespace

tl::expected<ControlRequest, BadRequest> control_request(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) {
    return tl::unexpected(BadRequest{.reason = "an object with a command is wanted"});
  }
  ControlRequest request;
  Json object = json;
  if (const auto id = object.find("id"); id != object.end()) {
    request.id = id->dump(-1, ' ', true, Json::error_handler_t::replace);
    object.erase("id");
  }
  RequestKeys keys(object);
  if (std::string reason = read_request(keys, request); !reason.empty()) {
    return tl::unexpected(BadRequest{.reason = std::move(reason), .id = request.id});
  }
  return request;
}

std::string hello_json(std::string_view file) {
  return line_of({{"type", "hello"}, {"schema_version", kControlVersion}, {"file", file}});
}

std::string accepted_json(const ControlRequest& request, ControllerState state) {
  Json json = answer_json(request.id, request.name, state);
  json["accepted"] = true;
  return line_of(json);
}

std::string refused_json(const ControlRequest& request, ControllerState state,
                         std::string_view reason) {
  Json json = answer_json(request.id, request.name, state);
  json["accepted"] = false;
  json["reason"] = reason;
  return line_of(json);
}

std::string bad_request_json(const BadRequest& request, ControllerState state) {
  Json json = answer_json(request.id, "", state);
  json["accepted"] = false;
  json["reason"] = request.reason;
  return line_of(json);
}

std::string event_json(const ControllerEvent& event, const std::optional<ProgramMessage>& message) {
  constexpr std::array kKinds{"message", "print", "debug"};
  Json json{{"type", "event"}, {"number", event.number}};
  if (event.kind == ControllerEvent::Kind::state) {
    json["event"] = "state";
    json["state"] = key_of_name(name_of(event.state));
    json["waits_for"] = name_of(event.waits_for);
    json["line"] = event.line;
  } else {
    json["event"] = message ? kKinds.at(static_cast<std::size_t>(message->kind)) : kKinds[0];
    json["line"] = message ? Json(message->line) : Json();
    json["text"] = message ? Json(message->text) : Json();
  }
  return line_of(json);
}

std::string status_json(const ControllerStatus& status, parser::Letters extra) {
  constexpr double kRadPerRevolution = 6.283185307179586477;
  const Setpoint& at = status.setpoint;
  Json json{{"type", "status"},
            {"state", key_of_name(name_of(status.state))},
            {"waits_for", name_of(status.waits_for)},
            {"line", at.line},
            {"tick", at.tick},
            {"run_s", status.run_s},
            {"left_s", status.left_s ? Json(*status.left_s) : Json()}};
  set_position(json, at, extra);
  json["path_mm"] = at.s_mm;
  json["feedrate_mm_s"] = at.v_mm_s;
  json["limit"] = key_of(at.limit);
  json["overrides"] = {{"feed_percent", percent_of(status.overrides.feed)},
                       {"rapid_percent", percent_of(status.overrides.rapid)},
                       {"spindle_percent", percent_of(status.overrides.spindle)}};
  json["single_block"] = status.single_block;
  json["optional_stop"] = status.optional_stop;
  json["block_delete"] = Json::array();
  for (unsigned number = 1; number <= BlockDelete::kSwitches; ++number) {
    if (status.block_delete.is_on(number)) {
      json["block_delete"].push_back(number);
    }
  }
  json["codes"] = std::string_view(status.codes.data(), status.codes.size())
                      .substr(0, ::strnlen(status.codes.data(), status.codes.size()));
  json["tool"] = at.outputs.tool;
  json["spindle_per_min"] = 60.0 * at.outputs.spindle_rad_s / kRadPerRevolution;
  json["mist"] = at.outputs.mist;
  json["flood"] = at.outputs.flood;
  json["next_event"] = status.next_event;
  return line_of(json);
}

std::string end_json(ExitStatus status) {
  return line_of({{"type", "end"}, {"exit_status", to_int(status)}});
}

}  // namespace kerf::program
