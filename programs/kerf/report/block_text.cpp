#include "programs/kerf/report/block_text.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include "parser/modal/codes_in_force.hpp"
#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/report/extra_axes.hpp"

namespace kerf::program {

namespace {

std::string point_text(const parser::Point& point_mm) {
  return fmt::format("x {}, y {}, z {} mm", fixed_number(point_mm[0], 3),
                     fixed_number(point_mm[1], 3), fixed_number(point_mm[2], 3));
}

std::string feed_text(const parser::ModalState& state, FeedUnit unit) {
  if (state.feed_mode == parser::FeedMode::per_revolution && state.feed_per_revolution_mm) {
    const bool in_inches = unit == FeedUnit::inch_min;
    return fmt::format("{} {}",
                       short_number(*state.feed_per_revolution_mm / (in_inches ? 25.4 : 1.0)),
                       in_inches ? "inch/rev" : "mm/rev");
  }
  return state.feedrate_mm_s
             ? fmt::format("{} {}", short_number(per_mm_s(unit) * *state.feedrate_mm_s),
                           name_of(unit))
             : "none yet";
}

void append_offsets(std::string& text, const parser::Coordinates& coordinates) {
  const auto out = std::back_inserter(text);
  const parser::WorkOffset& work = coordinates.work(coordinates.system());
  fmt::format_to(out, "  work offset     {}", point_text(work.origin_mm));
  if (work.rotation_deg != 0.0) {
    fmt::format_to(out, ", turned by {} degrees", short_number(work.rotation_deg));
  }
  fmt::format_to(out, "\n  G52, G92        {}\n  tool offset     {}\n",
                 point_text(coordinates.local_mm()), point_text(coordinates.tool_mm()));
}

std::string words_of(const parser::WatchedBlock& block) {
  std::string words = block.text;
  std::replace(words.begin(), words.end(), '\t', ' ');
  return visible(words);
}

// Those that are on, or not 0.
void append_outputs(std::string& text, const parser::SwitchedOutputs& outputs) {
  std::vector<std::string> told;
  for (unsigned output = 0; output < Outputs::kDigital; ++output) {
    if (((outputs.digital >> output) & 1U) != 0) {
      told.push_back(fmt::format("P{} on", output));
    }
  }
  for (std::size_t output = 0; output < outputs.analog.size(); ++output) {
    if (outputs.analog[output] != 0.0) {
      told.push_back(fmt::format("E{} {}", output, short_number(outputs.analog[output])));
    }
  }
  if (!told.empty()) {
    text += fmt::format("  outputs         {}\n", fmt::join(told, ", "));
  }
}

std::string state_text(const FileReport& report, const parser::WatchedBlock& block) {
  const parser::ModalState& state = block.state;
  const parser::Coordinates& coordinates = state.coordinates;
  std::string text = "  in force before it:\n";
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  codes           {}\n", fmt::join(parser::codes_in_force(state), " "));
  const bool is_beside = state.cutter_compensation != parser::ModalState{}.cutter_compensation;
  fmt::format_to(out, "  position        {} on the machine{}\n", point_text(state.position_mm),
                 is_beside ? ", of the program's path: the tool is beside it" : "");
  for (const ExtraAxis& axis : extra_axes(report.extra_axes)) {
    fmt::format_to(
        out, "                  {} {} {} on the machine, {} in the program\n", axis.name,
        fixed_number(state.auxiliary_deg_mm[axis.index], 3), axis.unit,
        fixed_number(coordinates.auxiliary_to_program(state.auxiliary_deg_mm)[axis.index], 3));
  }
  if (!coordinates.plain()) {
    fmt::format_to(out, "                  {} in the program\n",
                   point_text(coordinates.to_program(state.position_mm)));
    append_offsets(text, coordinates);
  }
  if (state.path_mode == parser::PathMode::blend) {
    fmt::format_to(out, "  G64             P {}, Q {} mm\n", short_number(state.blend_tolerance_mm),
                   short_number(state.merge_tolerance_mm));
  }
  fmt::format_to(out, "  feed            {}\n", feed_text(state, report.feed_unit));
  fmt::format_to(out, "  spindle         S{}\n", short_number(state.spindle_speed));
  fmt::format_to(out, "  tool            T{} loaded, T{} selected\n", state.loaded_tool,
                 short_number(state.tool));
  append_outputs(text, state.outputs);
  return text;
}

}  // namespace

std::string block_text(const FileReport& report) {
  if (!report.block) {
    return {};
  }
  const BlockReport& block = *report.block;
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}:{}: {}\n", visible(report.file), block.line, words_of(block.block));
  fmt::format_to(out, "  begins at       {} of {}", clock_time(block.begin_s),
                 clock_time(report.plan->cycle_time_s));
  if (block.duration_s > 0.0) {
    fmt::format_to(out, ", takes {} s", short_number(block.duration_s));
  }
  return text + "\n" + state_text(report, block.block);
}

std::string start_text(const FileReport& report) {
  const StartReport& start = *report.start;
  const std::string& file = start.place.file.empty() ? report.file : start.place.file;
  std::string text =
      fmt::format("{}:{}: {}\n", visible(file), start.place.line, words_of(start.block));
  const auto out = std::back_inserter(text);
  if (start.place.round > 1) {
    fmt::format_to(out, "  round           {}\n", start.place.round);
  }
  if (!start.block.calls.empty()) {
    fmt::format_to(out, "  called from     line {}\n", fmt::join(start.block.calls, ", line "));
  }
  text += state_text(report, start.block);
  if (start.assumed_input_line != 0) {
    fmt::format_to(out,
                   "  warning         the machine's answer to M66, first in line {}, is not known: "
                   "taken as [simulation] has it\n",
                   start.assumed_input_line);
  }
  text.pop_back();
  return text;
}

}  // namespace kerf::program
