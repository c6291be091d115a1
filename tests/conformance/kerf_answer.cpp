// What Kerf makes of a program, in the words of a golden file.
#include <map>
#include <optional>
#include <sstream>
#include <variant>

#include "parser/modal/tool_table.hpp"
#include "parser/program_reader.hpp"
#include "tests/conformance/answer.hpp"

namespace kerf::conformance {

namespace {

using parser::Move;

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

const char* name_of(parser::Plane plane) {
  return plane == parser::Plane::xy ? "xy" : plane == parser::Plane::zx ? "zx" : "yz";
}

std::string text_of(const parser::EventMove& event) {
  using parser::EventKind;
  static const std::map<EventKind, std::string> kNames{
      {EventKind::program_stop, "stop"},
      {EventKind::optional_stop, "optional_stop"},
      {EventKind::spindle_cw, "spindle_cw"},
      {EventKind::spindle_ccw, "spindle_ccw"},
      {EventKind::spindle_off, "spindle_off"},
      {EventKind::tool_change, "tool"},
      {EventKind::mist_on, "mist"},
      {EventKind::flood_on, "flood"},
      {EventKind::coolant_off, "coolant_off"},
      {EventKind::pallet_change, "pallet"},
      {EventKind::tool_number, "tool_number"},
      {EventKind::spindle_orient, "orient"},
      {EventKind::digital_output, "digital"},
      {EventKind::analog_output, "analog"},
      {EventKind::digital_at_motion, "digital_at_motion"},
      {EventKind::analog_at_motion, "analog_at_motion"}};
  const auto name = kNames.find(event.kind);
  const double value =
      event.kind == EventKind::spindle_orient ? event.value * kDegrees : event.value;
  std::ostringstream text;
  text << (name == kNames.end() ? "unknown" : name->second) << ' ' << value << ' ' << event.index;
  return text.str();
}

std::optional<Step> step_of(const Move& move) {
  constexpr double kSecondsPerMinute = 60.0;
  Step step;
  step.feed_mm_min = move.feedrate_mm_s * kSecondsPerMinute;
  for (std::size_t k = 0; k < 3; ++k) {
    step.turned_deg[k] = move.auxiliary.end_rad_mm[k] * kDegrees;
  }
  if (const auto* line = std::get_if<parser::LineMove>(&move.shape)) {
    const bool turns_alone = line->end_mm == move.start_mm && move.auxiliary.moves();
    step.feed_mm_min *= turns_alone ? kDegrees : 1.0;
    step.kind = move.rapid ? "rapid" : "feed";
    step.end_mm = line->end_mm;
  } else if (const auto* arc = std::get_if<parser::ArcMove>(&move.shape)) {
    step.kind = "arc";
    step.end_mm = arc->end_mm;
    step.centre_mm = arc->centre_mm;
    step.way = std::string(arc->clockwise ? "cw " : "ccw ") + name_of(arc->plane) + " turns " +
               std::to_string(arc->turns);
  } else if (std::holds_alternative<parser::NurbsMove>(move.shape)) {
    step.kind = "spline";
  } else if (const auto* dwell = std::get_if<parser::DwellMove>(&move.shape)) {
    step.kind = "dwell";
    step.time_s = dwell->duration_s;
  } else {
    const auto& event = std::get<parser::EventMove>(move.shape);
    if (event.kind == parser::EventKind::program_end ||
        event.kind == parser::EventKind::speed_override ||
        event.kind == parser::EventKind::adaptive_feed ||
        event.kind == parser::EventKind::feed_stop) {
      return std::nullopt;
    }
    step.kind = "event";
    step.way = text_of(event);
  }
  return step;
}

}  // namespace

Answer kerf_answer(const std::filesystem::path& program) {
  parser::ReaderOptions options;
  options.subprograms = [&](std::string_view name) -> std::optional<parser::SubprogramText> {
    const auto file = program.parent_path() / "called" / (std::string(name) + ".ngc");
    if (!std::filesystem::exists(file)) {
      return std::nullopt;
    }
    return parser::SubprogramText{file.filename().string(), read_file(file)};
  };
  options.machine.tools =
      parser::read_tool_table(read_file(program.parent_path().parent_path() / "tools.tbl")).value();
  options.machine.extra_axes = program.parent_path().filename() == "axes"
                                   ? parser::letters('A', 'B', 'C')
                                   : parser::Letters{0};
  parser::ProgramReader reader(options);
  const bool events = program.parent_path().filename() == "events";
  Answer answer;
  Move move;
  const auto fetch = [&] {
    while (reader.next(move)) {
      const std::optional<Step> step = step_of(move);
      if (step && (events || step->kind != "event")) {
        answer.steps.push_back(*step);
      }
    }
  };
  reader.feed(read_file(program));
  fetch();
  reader.finish();
  fetch();
  for (const diagnostics::Diagnostic& diagnostic : reader.diagnostics()) {
    if (diagnostic.severity == diagnostics::Severity::error && answer.refusal.empty()) {
      answer.refusal = to_string(diagnostic, program.filename().string());
    }
  }
  return answer;
}

}  // namespace kerf::conformance
