#include "programs/kerf/control/operator_order.hpp"

#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

namespace kerf::program {

namespace {

using Json = nlohmann::ordered_json;

// An array: what is asked for, and its values. A number that JSON does not have is null.
Json json_of(const kerf::Command& command) {
  return {"command", static_cast<int>(command)};
}
Json json_of(const Overrides& of) {
  return {"override", of.feed, of.rapid, of.spindle};
}
Json json_of(const SingleBlock& of) {
  return {"single_block", of.is_on};
}
Json json_of(const OptionalStop& of) {
  return {"optional_stop", of.is_on};
}
Json json_of(const BlockDelete& of) {
  Json json{"block_delete"};
  for (unsigned number = 1; number <= BlockDelete::kSwitches; ++number) {
    json.push_back(of.is_on(number));
  }
  return json;
}
Json json_of(const FeedInputs& of) {
  return {"feed_inputs", of.adaptive, of.stop};
}
Json json_of(const Tool& of) {
  return {"tool",
          of.number,
          of.pocket,
          of.offset_mm,
          of.diameter_mm,
          of.front_angle_deg,
          of.back_angle_deg,
          of.orientation,
          of.length_wear_mm,
          of.radius_wear_mm};
}
Json json_of(const Jog& of) {
  return {"jog", of.mm, of.extra_rad_mm, of.is_step, of.step_mm_s};
}
Json json_of(const MdiLine& of) {
  return {"mdi", of.text};
}

std::optional<OperatorOrder> command_from(const Json& json) {
  const int number = json.at(1).get<int>();
  if (number < 0 || number >= static_cast<int>(kCommands)) {
    return std::nullopt;
  }
  return static_cast<kerf::Command>(number);
}

BlockDelete block_delete_from(const Json& json) {
  BlockDelete switches;
  for (unsigned number = 1; number <= BlockDelete::kSwitches; ++number) {
    if (json.at(number).get<bool>()) {
      switches.switch_on(number);
    }
  }
  return switches;
}

Tool tool_from(const Json& json) {
  Tool tool;
  json.at(1).get_to(tool.number);
  json.at(2).get_to(tool.pocket);
  json.at(3).get_to(tool.offset_mm);
  json.at(4).get_to(tool.diameter_mm);
  json.at(5).get_to(tool.front_angle_deg);
  json.at(6).get_to(tool.back_angle_deg);
  json.at(7).get_to(tool.orientation);
  json.at(8).get_to(tool.length_wear_mm);
  json.at(9).get_to(tool.radius_wear_mm);
  return tool;
}

Jog jog_from(const Json& json) {
  Jog jog;
  json.at(1).get_to(jog.mm);
  json.at(2).get_to(jog.extra_rad_mm);
  json.at(3).get_to(jog.is_step);
  jog.step_mm_s = json.at(4).is_null() ? kUnbounded : json.at(4).get<double>();
  return jog;
}

std::optional<OperatorOrder> order_of(const Json& json) {
  const auto& kind = json.at(0).get_ref<const std::string&>();
  if (kind == "command") {
    return command_from(json);
  }
  if (kind == "override") {
    return Overrides{.feed = json.at(1), .rapid = json.at(2), .spindle = json.at(3)};
  }
  if (kind == "single_block") {
    return SingleBlock{.is_on = json.at(1)};
  }
  if (kind == "optional_stop") {
    return OptionalStop{.is_on = json.at(1)};
  }
  if (kind == "block_delete") {
    return block_delete_from(json);
  }
  if (kind == "feed_inputs") {
    return FeedInputs{.adaptive = json.at(1), .stop = json.at(2)};
  }
  if (kind == "tool") {
    return tool_from(json);
  }
  if (kind == "jog") {
    return jog_from(json);
  }
  if (kind == "mdi") {
    return MdiLine{.text = json.at(1)};
  }
  return std::nullopt;
}

}  // namespace

std::string text_of(const OperatorOrder& order) {
  const Json json = std::visit([](const auto& of) { return json_of(of); }, order);
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::optional<OperatorOrder> order_from(std::string_view text) {
  const auto json = Json::parse(text, nullptr, false);
  if (!json.is_array()) {
    return std::nullopt;
  }
  try {
    return order_of(json);
  } catch (const Json::exception&) {  // too few values, or of another type
    return std::nullopt;
  }
}

}  // namespace kerf::program
