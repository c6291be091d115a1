#include "programs/kerf/control/replies.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include <nlohmann/json.hpp>

#include "programs/kerf/report/constraint_text.hpp"
#include "programs/kerf/report/extra_axes.hpp"

namespace kerf::program {

namespace {

// Keys in the order in which they are set.
using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) {
  // Text of a program may be anything; what is no UTF-8 becomes U+FFFD.
  return json.dump(-1, ' ', true, Json::error_handler_t::replace) + '\n';
}

// Where it waits for an answer.
void set_wait_cause(Json& json, WaitCause cause) {
  if (cause != WaitCause::none) {
    json["wait_cause"] = key_of_name(name_of(cause));
  }
}

// Without what other units and rounding add to 110 %.
double rounded(double value) {
  constexpr double kDigits = 1e6;
  return std::round(value * kDigits) / kDigits;
}

double percent_of(double share) {
  return rounded(100.0 * share);
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
    set_wait_cause(json, event.wait_cause);
    json["line"] = event.line;
  } else {
    json["event"] = message ? kKinds.at(static_cast<std::size_t>(message->kind)) : kKinds[0];
    // 0: Kerf's own, about no line.
    json["line"] = message && message->line != 0 ? Json(message->line) : Json();
    json["text"] = message ? Json(message->text) : Json();
  }
  return line_of(json);
}

std::string status_json(std::string_view id, const ControllerStatus& status,
                        parser::Letters extra) {
  constexpr double kRadPerRevolution = 6.283185307179586477;
  const Setpoint& at = status.setpoint;
  Json json{{"type", "status"}};
  if (Json value = Json::parse(id); !value.is_null()) {
    json["id"] = std::move(value);
  }
  json["state"] = key_of_name(name_of(status.state));
  json["waits_for"] = name_of(status.waits_for);
  set_wait_cause(json, status.wait_cause);
  json["line"] = at.line;
  json["block"] = status.block;
  json["tick"] = at.tick;
  json["run_s"] = status.run_s;
  json["left_s"] = status.left_s ? Json(*status.left_s) : Json();
  set_position(json, at, extra);
  json["path_mm"] = at.s_mm;
  json["feedrate_mm_s"] = at.v_mm_s;
  json["limit"] = key_of(at.limit);
  json["overrides"] = {{"feed_percent", percent_of(status.overrides.feed)},
                       {"rapid_percent", percent_of(status.overrides.rapid)},
                       {"spindle_percent", percent_of(status.overrides.spindle)}};
  json["adaptive_feed_percent"] = percent_of(status.feed_inputs.adaptive);
  json["feed_stop"] = status.feed_inputs.stop;
  json["held_by_feed"] = status.is_held_by_feed;
  json["single_block"] = status.single_block;
  json["optional_stop"] = status.optional_stop;
  json["block_delete"] = Json::array();
  for (unsigned number = 1; number <= BlockDelete::kSwitches; ++number) {
    if (status.block_delete.is_on(number)) {
      json["block_delete"].push_back(number);
    }
  }
  json["unhomed"] = Json::array();
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (((status.unhomed >> axis) & 1U) != 0) {
      json["unhomed"].push_back(std::string(1, "xyz"[axis]));
    }
  }
  json["door_open"] = status.door_open;
  json["codes"] = std::string_view(status.codes.data(), status.codes.size())
                      .substr(0, ::strnlen(status.codes.data(), status.codes.size()));
  json["tool"] = at.outputs.tool;
  json["spindle_per_min"] = rounded(60.0 * at.outputs.spindle_rad_s / kRadPerRevolution);
  json["mist"] = at.outputs.mist;
  json["flood"] = at.outputs.flood;
  json["next_event"] = status.next_event;
  return line_of(json);
}

std::string end_json(ExitStatus status) {
  return line_of({{"type", "end"}, {"exit_status", to_int(status)}});
}

}  // namespace kerf::program
