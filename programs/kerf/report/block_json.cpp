#include "programs/kerf/report/block_json.hpp"

#include <spdlog/fmt/fmt.h>

#include "parser/modal/codes_in_force.hpp"
#include "programs/kerf/report/extra_axes.hpp"
#include "programs/kerf/report/place_json.hpp"

namespace kerf::program {

namespace {

// Keys in the order in which they are set.
using Json = nlohmann::ordered_json;

Json outputs_json(const parser::SwitchedOutputs& outputs) {
  Json json = {{"digital_on", Json::array()}, {"analog", outputs.analog}};
  for (unsigned output = 0; output < Outputs::kDigital; ++output) {
    if (((outputs.digital >> output) & 1U) != 0) {
      json["digital_on"].push_back(output);
    }
  }
  return json;
}

// What is in force before it.
Json state_json(const parser::WatchedBlock& block, parser::Letters extra) {
  const parser::ModalState& state = block.state;
  const parser::WorkOffset& work = state.coordinates.work(state.coordinates.system());
  const bool is_per_turn = state.feed_mode == parser::FeedMode::per_revolution;
  const auto turn_mm = is_per_turn ? state.feed_per_revolution_mm : std::nullopt;
  Json json = {{"text", block.text},
               {"codes", parser::codes_in_force(state)},
               {"position_mm", axes_json(state.position_mm)},
               {"program_position_mm", axes_json(state.coordinates.to_program(state.position_mm))},
               {"work_offset_mm", axes_json(work.origin_mm)},
               {"work_rotation_deg", work.rotation_deg},
               {"local_offset_mm", axes_json(state.coordinates.local_mm())},
               {"tool_offset_mm", axes_json(state.coordinates.tool_mm())},
               {"corner_tolerance_mm", state.blend_tolerance_mm},
               {"merge_tolerance_mm", state.merge_tolerance_mm},
               {"feedrate_mm_s", state.feedrate_mm_s ? Json(*state.feedrate_mm_s) : Json()},
               {"feed_mm_rev", turn_mm ? Json(*turn_mm) : Json()},
               {"spindle_speed", state.spindle_speed},
               {"tool", state.loaded_tool},
               {"selected_tool", state.tool},
               {"outputs", outputs_json(state.outputs)}};
  for (const ExtraAxis& axis : extra_axes(extra)) {
    const std::string unit = fmt::format("_{}", axis.unit);
    json["position" + unit][axis.name] = state.auxiliary_deg_mm[axis.index];
    json["program_position" + unit][axis.name] =
        state.coordinates.auxiliary_to_program(state.auxiliary_deg_mm)[axis.index];
  }
  return json;
}

}  // namespace

nlohmann::ordered_json block_json(const BlockReport& report, parser::Letters extra) {
  Json json = state_json(report.block, extra);
  json["line"] = report.line;
  json["begin_s"] = report.begin_s;
  json["duration_s"] = report.duration_s;
  return json;
}

nlohmann::ordered_json start_json(const StartReport& report, parser::Letters extra) {
  Json json = state_json(report.block, extra);
  json["line"] = report.place.line;
  json["round"] = report.place.round;
  json["calls"] = report.block.calls;
  if (!report.place.file.empty()) {
    json["file"] = report.place.file;
  }
  if (report.assumed_input_line != 0) {
    json["assumed_input_line"] = report.assumed_input_line;
  }
  return json;
}

}  // namespace kerf::program
