#include "programs/kerf/page/plan_document.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "diagnostics/errors/pages.hpp"
#include "programs/kerf/page/file_names.hpp"
#include "programs/kerf/page/packed_source.hpp"
#include "programs/kerf/page/plan_sections.hpp"
#include "programs/kerf/report/constraint_text.hpp"
#include "programs/kerf/report/diagnostic_document.hpp"
#include "programs/kerf/report/json_report.hpp"

namespace kerf::program {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "KERFPLAN";
constexpr double kPathUnit_mm = 1e-6;
constexpr double kTimeUnit_s = 1e-6;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json limits_json(const MotionLimits& limits, double factor = 1.0) {
  return {{"v", number_or_null(factor * limits.velocity_mm_s)},
          {"a", number_or_null(factor * limits.acceleration_mm_s2)},
          {"j", number_or_null(factor * limits.jerk_mm_s3)}};
}

// Axes as the page lists them: X, Y, Z, then those of the machine beside them.
Json axes_json(const MachineSettings& settings) {
  Json axes = Json::array();
  for (std::size_t k = 0; k < 3; ++k) {
    const Travel& travel = settings.table.axes[k].travel;
    axes.push_back({{"name", std::string(1, "xyz"[k])},
                    {"unit", "mm"},
                    {"limits", limits_json(settings.limits.axes[k])},
                    {"travel", {number_or_null(travel.min_mm), number_or_null(travel.max_mm)}}});
  }
  for (const ExtraAxis& axis : extra_axes(settings.program.extra_axes)) {
    const AuxiliaryTravel& travel = settings.table.extra[axis.index];
    axes.push_back({{"name", axis.name},
                    {"unit", axis.unit},
                    {"limits", limits_json(settings.limits.extra[axis.index], axis.factor)},
                    {"travel",
                     {number_or_null(axis.factor * travel.min_rad_mm),
                      number_or_null(axis.factor * travel.max_rad_mm)}}});
  }
  return axes;
}

Json machine_json(const MachineSettings& settings) {
  constexpr std::array kNames{"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
  Json offsets = Json::array();
  for (std::size_t k = 0; k < kWorkSystems; ++k) {
    const WorkOffset& work = settings.program.work[k];
    offsets.push_back(
        {{"name", kNames[k]}, {"origin_mm", work.origin_mm}, {"rotation_deg", work.rotation_deg}});
  }
  return {{"path_limits", limits_json(settings.limits.path)},
          {"axes", axes_json(settings)},
          {"work_offsets", std::move(offsets)},
          {"chord_tolerance_mm", number_or_null(settings.limits.chord_tolerance_mm)}};
}

Json constraints_json() {
  Json constraints = Json::array();
  for (std::size_t k = 0; k < interp::kConstraints; ++k) {
    const auto limit = static_cast<Constraint>(k);
    constraints.push_back(
        {{"key", key_of(limit)}, {"text", text_of(limit)}, {"colour", colour_of(limit)}});
  }
  return constraints;
}

float largest(const ColumnSeries& series) {
  float most = 0.0F;
  for (const auto* values : {&series.min, &series.max}) {
    for (const float value : *values) {
      most = std::max(most, std::abs(value));
    }
  }
  return most;
}

// Of single ticks there is one value, to 2^-22 of the largest; columns of several are coarser,
// and never narrower than what they stand for.
void add_series(Sections& sections, const std::string& name, const ColumnSeries& series,
                bool single) {
  const double most = largest(series);
  const double unit = most > 0.0 ? std::ldexp(most, single ? -22 : -13) : 1.0;
  if (single) {
    sections.add_numbers({name, unit}, series.min,
                         [unit](double value) { return std::llround(value / unit); });
    return;
  }
  sections.add_numbers({name + ".min", unit}, series.min, [unit](double value) {
    return static_cast<long long>(std::floor(value / unit));
  });
  sections.add_numbers({name + ".max", unit}, series.max, [unit](double value) {
    return static_cast<long long>(std::ceil(value / unit));
  });
}

void add_columns(Json& header, Sections& sections, const TickColumns& columns) {
  header["first_tick"] = columns.first_tick();
  header["ticks_per_column"] = columns.ticks_per_column();
  header["columns"] = columns.columns();
  std::vector<std::string> names{"path"};
  for (const Json& axis : header["machine"]["axes"]) {
    names.push_back(axis["name"]);
  }
  const bool single = columns.ticks_per_column() == 1;
  for (std::size_t i = 0; i < columns.series().size(); ++i) {
    const bool is_of_track = i / 3 < names.size();
    const std::string name = is_of_track  ? names[i / 3] + "." + std::string(1, "vaj"[i % 3])
                             : i % 3 == 0 ? "following_error"
                                          : "deviation";
    add_series(sections, name, columns.series()[i], single);
  }
  const std::vector<std::uint8_t> limits = columns.limits();
  sections.add_bytes("limit", std::string(limits.begin(), limits.end()));
}

void add_path(Json& header, Sections& sections, const TimedPath& path) {
  const std::vector<TimedPoint> points = path.points();
  header["path_tolerance_mm"] = path.tolerance_mm();
  header["path_tells_rapids"] = path.tells_rapids();
  sections.add_numbers({"path.tick"}, points, [](const TimedPoint& point) { return point.tick; });
  for (std::size_t k = 0; k < 3; ++k) {
    sections.add_numbers(
        {"path." + std::string(1, "xyz"[k]), kPathUnit_mm}, points,
        [k](const TimedPoint& point) { return std::llround(point.position_mm[k] / kPathUnit_mm); });
  }
  std::string rapid(points.size(), '\0');
  std::transform(points.begin(), points.end(), rapid.begin(),
                 [](const TimedPoint& point) { return point.rapid ? '\1' : '\0'; });
  sections.add_bytes("path.rapid", rapid);
}

void add_runs(Json& header, Sections& sections, const MotionRuns& motion) {
  const std::vector<LineRun>& runs = motion.runs();
  header["shortest_run_ticks"] = motion.shortest_ticks();
  sections.add_numbers({"runs.tick"}, runs, [](const LineRun& run) { return run.tick; });
  sections.add_numbers({"runs.line"}, runs,
                       [](const LineRun& run) { return std::int64_t{run.line}; });
  sections.add_numbers({"runs.tool"}, runs,
                       [](const LineRun& run) { return std::int64_t{run.tool}; });
  std::string kinds(runs.size(), '\0');
  std::transform(runs.begin(), runs.end(), kinds.begin(),
                 [](const LineRun& run) { return static_cast<char>(run.kind); });
  sections.add_bytes("runs.kind", kinds);
}

void add_nominal_lines(Sections& sections, const std::vector<NominalLines::Line>& all) {
  std::vector<std::uint32_t> lines;
  for (std::uint32_t line = 0; line < all.size(); ++line) {
    if (all[line].duration_s > 0.0) {
      lines.push_back(line);
    }
  }
  sections.add_numbers({"nominal.line"}, lines,
                       [](std::uint32_t line) { return std::int64_t{line}; });
  sections.add_numbers({"nominal.s", kTimeUnit_s}, lines, [&all](std::uint32_t line) {
    return std::llround(all[line].duration_s / kTimeUnit_s);
  });
  sections.add_numbers({"nominal.end", kPathUnit_mm}, lines, [&all](std::uint32_t line) {
    return std::llround(all[line].end_mm / kPathUnit_mm);
  });
}

// What is known before the motion.
void add_planned(Json& header, Sections& sections, const PageRecord& record) {
  if (record.planned) {
    add_path(header, sections, record.planned->outline());
  }
  if (record.nominal) {
    add_nominal_lines(sections, record.nominal->lines());
  }
}

void add_codes(Json& header, Sections& sections, const std::string& name, const CodeRuns& codes) {
  header[name] = codes.texts();
  sections.add_numbers({name + ".tick"}, codes.runs(), [](const CodeRun& run) { return run.tick; });
  sections.add_numbers({name + ".text"}, codes.runs(),
                       [](const CodeRun& run) { return std::int64_t{run.codes}; });
}

Json messages_json(const PlanGatherer& motion) {
  Json messages = Json::array();
  for (const ProgramMessage& message : motion.messages()) {
    messages.push_back({{"line", message.line}, {"text", message.text}});
  }
  return messages;
}

// A short text is as it is.
void add_source(Sections& sections, const std::string& source) {
  constexpr std::size_t kShort = 100'000;
  if (source.size() < kShort) {
    sections.add_bytes("source", source);
    return;
  }
  const PackedSource packed = packed_source(source);
  sections.add_bytes("source.text", packed.text);
  for (const auto& [name, found] : packed.numbers) {
    sections.add_packed({"source." + name}, found.count, found.numbers);
  }
}

// It has the words of a comment, a name in angle brackets that the program has made, or a
// quotation.
bool quotes_program(const diagnostics::Diagnostic& diagnostic) {
  const std::string& message = diagnostic.message;
  return diagnostic.page == &errors::kAborted || diagnostic.page == &errors::kMacroAlarm ||
         message.find('<') != std::string::npos || message.starts_with('\'') ||
         message.find(" '") != std::string::npos || message.find("('") != std::string::npos;
}

// The lowest byte first.
std::string four_bytes(std::uint32_t number) {
  std::string bytes;
  for (unsigned k = 0; k < 4; ++k) {
    bytes.push_back(static_cast<char>(number >> (8U * k) & 0xFFU));
  }
  return bytes;
}

}  // namespace

std::string plan_document(const FileReport& report, const MachineSettings& settings,
                          const PageRecord& record) {
  Json header;
  header["version"] = kPlanVersion;
  FileReport named = with_file_names(report);
  if (!record.quotes_text) {
    for (diagnostics::Diagnostic& diagnostic : named.diagnostics) {
      diagnostic.block = {};
      if (quotes_program(diagnostic)) {
        diagnostic.message = diagnostic.page->title;
      }
    }
    if (named.motion) {
      named.motion->parts.operations.clear();  // they have the words of comments
    }
  }
  header["report"] = Json::parse(json_report(named));
  header["diagnostics"] = Json::parse(json_diagnostics({named}))["diagnostics"];
  header["machine"] = machine_json(settings);
  header["constraints"] = constraints_json();
  if (record.extents) {
    header["extents"] = {{"min_mm", record.extents->min_mm}, {"max_mm", record.extents->max_mm}};
  }
  header["has_source"] = record.source.has_value();
  header["feed_unit"] = name_of(report.feed_unit);
  Sections sections;
  if (record.motion) {
    header["last_tick"] = record.motion->last_tick();
    add_columns(header, sections, record.motion->columns());
    add_path(header, sections, record.motion->path());
    add_runs(header, sections, record.motion->runs());
    add_codes(header, sections, "codes", record.motion->codes());
    add_codes(header, sections, "words", record.motion->words());
    header["messages"] = record.quotes_text ? messages_json(*record.motion) : Json::array();
  }
  if (!record.motion) {
    add_planned(header, sections, record);
  }
  if (record.source) {
    add_source(sections, *record.source);
  }
  header["sections"] = sections.list();
  const std::string text = header.dump(-1, ' ', true, Json::error_handler_t::replace);
  return std::string(kMagic) + four_bytes(static_cast<std::uint32_t>(text.size())) + text +
         sections.bytes();
}

}  // namespace kerf::program
