#include <nlohmann/json.hpp>

#include "programs/kerf/compare/comparison_text.hpp"
#include "programs/kerf/report/json_report.hpp"

namespace kerf::program {

namespace {

// Keys in the order in which they are set.
using Json = nlohmann::ordered_json;

Json lines_json(const ComparedLines& lines, double time_s) {
  if (lines.span.is_empty()) {
    return nullptr;
  }
  Json limits = Json::object();
  for (const LimitShare& part : lines.limits) {
    limits[key_of(part.limit)] = part.time_s;
  }
  return {{"from_line", lines.span.first},
          {"to_line", lines.span.last},
          {"text", lines.text},
          {"time_s", time_s},
          {"limits_s", limits}};
}

Json times_json(const TwoTimes& times_s) {
  return {
      {"first_s", times_s[0]}, {"second_s", times_s[1]}, {"difference_s", difference_s(times_s)}};
}

Json difference_json(const Comparison& comparison) {
  Json json{{"cycle_time", times_json(comparison.cycle_s)},
            {"time_split",
             {{"cutting", times_json(comparison.cutting_s)},
              {"rapid", times_json(comparison.rapid_s)},
              {"rest", times_json(comparison.rest_s)},
              {"tool_change", times_json(comparison.tool_change_s)}}}};
  json["speed_limits"] = Json::object();
  for (const LimitDifference& limit : comparison.limits) {
    json["speed_limits"][key_of(limit.limit)] = times_json(limit.times_s);
  }
  json["lines"] = Json::array();
  for (const LineDifference& line : comparison.lines) {
    json["lines"].push_back({{"difference_s", difference_s(line.times_s)},
                             {"first", lines_json(line.lines[0], line.times_s[0])},
                             {"second", lines_json(line.lines[1], line.times_s[1])}});
  }
  json["other_lines"] = {{"count", comparison.other_lines},
                         {"difference_s", comparison.other_lines_s}};
  return json;
}

}  // namespace

std::string comparison_json(const ComparedReports& compared, ExitStatus status) {
  Json json{
      {"schema_version", kJsonSchemaVersion},
      {"command", "compare"},
      {"exit_status", to_int(status)},
      {"programs",
       {Json::parse(json_report(compared.first)), Json::parse(json_report(compared.second))}}};
  if (compared.comparison != nullptr) {
    json["difference"] = difference_json(*compared.comparison);
  }
  return json.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace kerf::program
