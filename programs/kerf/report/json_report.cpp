#include "programs/kerf/report/json_report.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "programs/kerf/report/block_json.hpp"
#include "programs/kerf/report/extra_axes.hpp"
#include "programs/kerf/report/place_json.hpp"

namespace kerf::program {

namespace {

// Keys in the order in which they are set.
using Json = nlohmann::ordered_json;

Json peaks_json(const Peaks& peaks) {
  return {{"v_mm_s", peaks.v_mm_s}, {"a_mm_s2", peaks.a_mm_s2}, {"j_mm_s3", peaks.j_mm_s3}};
}

// The linear ones of the machine's other axes go beside x, y and z, the rotary ones into a table
// of their own.
void add_extra(Json& in_mm, Json& in_deg, const FileReport& report,
               const curves::AuxiliaryPosition& values_rad_mm) {
  for (const ExtraAxis& axis : extra_axes(report.extra_axes)) {
    (axis.unit == "deg" ? in_deg : in_mm)[axis.name] = axis.factor * values_rad_mm[axis.index];
  }
}

Json extents_json(const FileReport& report) {
  const PlanReport& plan = *report.plan;
  Json extents{{"min_mm", axes_json(plan.extents.min_mm)},
               {"max_mm", axes_json(plan.extents.max_mm)}};
  Json min_deg;
  Json max_deg;
  add_extra(extents["min_mm"], min_deg, report, plan.extra_extents.min_rad_mm);
  add_extra(extents["max_mm"], max_deg, report, plan.extra_extents.max_rad_mm);
  if (!min_deg.empty()) {
    extents["min_deg"] = min_deg;
    extents["max_deg"] = max_deg;
  }
  return extents;
}

Json deviation_json(const smoothing::PathDeviation& deviation) {
  Json json{{"max_mm", deviation.distance_mm}};
  if (deviation.distance_mm > 0.0) {
    json["tolerance_mm"] = deviation.tolerance_mm;
    json["at_mm"] = axes_json(deviation.at_mm);
    json["line"] = deviation.line;
  }
  return json;
}

Json path_modes_json(const std::vector<PathControlUse>& uses) {
  constexpr std::array kCodes{"G61", "G61.1", "G64"};
  Json json = Json::array();
  for (const PathControlUse& use : uses) {
    Json mode{{"mode", kCodes.at(static_cast<std::size_t>(use.control.mode))},
              {"by", use.by_program ? "program" : "machine"}};
    if (use.control.mode == PathMode::blend) {
      mode["corner_tolerance_mm"] = use.control.corner_tolerance_mm;
      mode["merge_tolerance_mm"] = use.control.merge_tolerance_mm;
    }
    json.push_back(std::move(mode));
  }
  return json;
}

Json waits_json(const PlanWaits& waits) {
  constexpr std::array kKinds{"program_stop", "optional_stop", "pallet_change", "tool_change",
                              "spindle_start"};
  Json first = Json::array();
  for (std::size_t i = 0; i < waits.first.size() && i < waits.count; ++i) {
    const PlanWait& wait = waits.first[i];
    first.push_back({{"line", wait.line},
                     {"kind", kKinds.at(static_cast<std::size_t>(wait.kind))},
                     {"duration_s", wait.duration_s}});
    if (wait.kind == PlanWait::Kind::tool_change) {
      first.back()["tool"] = wait.tool;
    }
  }
  return {{"count", waits.count}, {"duration_s", waits.duration_s}, {"first", first}};
}

void set_plan(Json& json, const FileReport& report) {
  const PlanReport& plan = *report.plan;
  json["cycle_time_s"] = plan.cycle_time_s;
  json["ticks"] = plan.ticks;
  json["path_length_mm"] = plan.path_length_mm;
  json["blocks"] = plan.blocks;
  json["extents"] = extents_json(report);
  json["path_modes"] = path_modes_json(plan.path_controls);
  json["waits"] = waits_json(plan.waits);
  json["deviation"] = deviation_json(plan.deviation);
}

Json parts_json(const std::vector<TimePart>& parts, const char* name, double period_s) {
  Json rows = Json::array();
  for (const TimePart& part : parts) {
    const auto seconds = [period_s](std::int64_t ticks) {
      return static_cast<double>(ticks) * period_s;
    };
    Json& row = rows.emplace_back(Json{{name, part.name}});
    if (part.line > 0) {
      row["line"] = part.line;
    }
    row["cutting_s"] = seconds(part.time.cutting);
    row["rapid_s"] = seconds(part.time.rapid);
    row["rest_s"] = seconds(part.time.rest);
    row["tool_change_s"] = seconds(part.time.tool_change);
  }
  return rows;
}

void set_motion(Json& json, const FileReport& report) {
  const MotionReport& motion = *report.motion;
  const auto seconds = [&report](std::int64_t ticks) {
    return static_cast<double>(ticks) * report.period_s;
  };
  json["time_split"] = {{"cutting_s", seconds(motion.time.cutting)},
                        {"rapid_s", seconds(motion.time.rapid)},
                        {"rest_s", seconds(motion.time.rest)},
                        {"tool_change_s", seconds(motion.time.tool_change)}};
  if (report.command != Subcommand::run) {
    json["time_by_tool"] = parts_json(motion.parts.tools, "tool", report.period_s);
    json["time_by_operation"] = parts_json(motion.parts.operations, "operation", report.period_s);
  }
  json["approach"] = {{"time_s", seconds(motion.time.approach)},
                      {"cycle_time_without_s", seconds(report.plan->ticks - motion.time.approach)}};
  json["max"] = {{"path", peaks_json(motion.path)},
                 {"axes",
                  {{"x", peaks_json(motion.axes[0])},
                   {"y", peaks_json(motion.axes[1])},
                   {"z", peaks_json(motion.axes[2])}}}};
  for (const ExtraAxis& axis : extra_axes(report.extra_axes)) {
    const Peaks& peaks = motion.extra[axis.index];
    const double k = axis.factor;
    json["max"]["axes"][axis.name] = axis.unit == "mm" ? peaks_json(peaks)
                                                       : Json{{"v_deg_s", k * peaks.v_mm_s},
                                                              {"a_deg_s2", k * peaks.a_mm_s2},
                                                              {"j_deg_s3", k * peaks.j_mm_s3}};
  }
  json["limits_exceeded"] = Json::array();
  for (const LimitUse& use : limit_uses(motion, report.limits, report.extra_axes)) {
    if (use.is_exceeded()) {
      json["limits_exceeded"].push_back({{"where", use.where},
                                         {"quantity", use.quantity},
                                         {"unit", use.unit},
                                         {"value", use.peak},
                                         {"limit", use.limit},
                                         {"ratio", use.ratio()}});
    }
  }
  json["chord_error_mm"] = motion.chord_error_mm;
  json["contour_error"] = {{"max_mm", motion.max_contour_error_mm},
                           {"mean_mm", motion.mean_contour_error_mm}};
  json["following_error"] = {{"max_mm", axes_json(motion.max_following_error_mm)}};
  json["starved_ticks"] = motion.starved_ticks;
}

Json limits_json(const FileReport& report, const LineSpeed& line) {
  Json limits = Json::object();
  for (const LimitTime& part : line.limits) {
    const auto ticks = static_cast<double>(part.ticks);
    limits[key_of(part.limit)] = {{"time_s", ticks * report.period_s},
                                  {"share", ticks / static_cast<double>(line.ticks)}};
  }
  return limits;
}

void set_speed(Json& json, const FileReport& report) {
  const SpeedReport& speed = *report.speed;
  json["speed_limits"] = limits_json(report, speed.whole);
  json["stops"] = speed.stops;
  json["speed_limits_of_lines"] = Json::array();
  for (const LineSpeed& line : speed.lines) {
    json["speed_limits_of_lines"].push_back(
        {{"line", line.line},
         {"time_s", static_cast<double>(line.ticks) * report.period_s},
         {"limits", limits_json(report, line)}});
  }
  if (speed.tick) {
    json["speed_limit_at"] = {{"t_s", static_cast<double>(speed.tick->tick) * report.period_s},
                              {"line", speed.tick->line},
                              {"v_mm_s", speed.tick->v_mm_s},
                              {"limit", key_of(speed.tick->limit)}};
  }
}

void set_clock(Json& json, const FileReport& report) {
  const ClockReport& clock = *report.clock;
  json["driver"] = report.driver;
  json["late_ticks"] = clock.late_ticks;
  json["worst_delay_s"] = clock.worst_delay_s;
  json["delays"] = Json::array();
  for (const TimeHistogram::Step& step : clock.delays.steps()) {
    json["delays"].push_back({{"up_to_s", step.up_to_s}, {"ticks", step.count}});
  }
  json["tick_times"] = {{"mean_s", clock.tick_times.mean_s()},
                        {"most_s", clock.tick_times.quantile_s(0.999)},
                        {"worst_s", clock.tick_times.worst_s()}};
}

Json fault_json(const FaultReport& fault) {
  return {{"kind", fault.kind},
          {"axis", fault.axis.empty() ? Json() : Json(fault.axis)},
          {"line", fault.line},
          {"t_s", fault.t_s},
          {"needs_homing", fault.needs_homing}};
}

void set_messages(Json& json, const FileReport& report) {
  json["warnings"] = Json::array();
  json["errors"] = Json::array();
  for (const diagnostics::Diagnostic& diagnostic : report.diagnostics) {
    if (diagnostic.severity == diagnostics::Severity::warning) {
      json["warnings"].push_back(
          fmt::format("line {}{}: {}", diagnostic.source.line,
                      diagnostic.file.empty() ? "" : " of " + diagnostic.file, diagnostic.message));
      continue;
    }
    Json error = {{"line", diagnostic.source.line},
                  {"column", diagnostic.source.column},
                  {"message", diagnostic.message},
                  {"id", diagnostics::identifier(*diagnostic.page)}};
    if (!diagnostic.file.empty()) {
      error["file"] = diagnostic.file;
    }
    json["errors"].push_back(std::move(error));
  }
  for (const std::string& warning : report.warnings) {
    json["warnings"].push_back(warning);
  }
  for (const std::string& failure : report.failures) {
    json["errors"].push_back({{"message", failure}});
  }
}

}  // namespace

std::string json_report(const FileReport& report) {
  Json json;
  json["schema_version"] = kJsonSchemaVersion;
  json["file"] = report.file;
  json["command"] = name_of(report.command);
  json["exit_status"] = to_int(report.status);
  json["machine"] = report.machine;
  json["profile"] = report.profile;
  json["feed_override"] = report.feed_override;
  json["period_s"] = report.period_s;
  if (report.boxes) {
    json["path_boxes"] = boxes_json(*report.boxes);
  }
  if (report.fit) {
    json["fit"] = fit_json(*report.fit);
  }
  if (report.plan) {
    set_plan(json, report);
  }
  if (report.block) {
    json["block"] = block_json(*report.block, report.extra_axes);
  }
  if (report.start) {
    json["start"] = start_json(*report.start, report.extra_axes);
  }
  if (report.motion) {
    set_motion(json, report);
  }
  if (report.speed) {
    set_speed(json, report);
  }
  if (report.clock) {
    set_clock(json, report);
  }
  if (report.machine_fault) {
    json["fault"] = fault_json(*report.machine_fault);
  }
  set_messages(json, report);
  json["elapsed"] = {{"check_s", report.check_duration_s}, {"run_s", report.run_duration_s}};
  // ASCII alone, so that no control character of a name reaches a terminal. What is not UTF-8 in a
  // file name or a message becomes U+FFFD; what is not a number, null.
  return json.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace kerf::program
