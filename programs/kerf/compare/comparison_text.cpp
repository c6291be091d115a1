#include "programs/kerf/compare/comparison_text.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "diagnostics/utf8.hpp"
#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/report/extents_text.hpp"

namespace kerf::program {

namespace {

constexpr std::size_t kTextBytes = 40;  // of a line of the program

// "+0.120", "-0.120", "0.000"
std::string signed_s(double time_s) {
  const std::string text = fixed_number(time_s, 3);
  return std::abs(time_s) < 0.0005 || time_s < 0.0 ? text : "+" + text;
}

std::string percent_of(const TwoTimes& times_s) {
  return times_s[0] > 0.0 ? fmt::format(", {:+.1f} %", 100.0 * difference_s(times_s) / times_s[0])
                          : "";
}

std::string span_text(const LineSpan& span) {
  if (span.is_empty()) {
    return "none";
  }
  return span.count() == 1 ? fmt::format("{}", span.first)
                           : fmt::format("{} to {}", span.first, span.last);
}

std::string place_text(const LineDifference& line) {
  const std::string first = span_text(line.lines[0].span);
  const std::string second = span_text(line.lines[1].span);
  return first == second ? first : first + " -> " + second;
}

std::string shown(const std::string& text) {
  const std::string_view begin = diagnostics::first_bytes(text, kTextBytes);
  return visible(begin) + (begin.size() < text.size() ? "..." : "");
}

std::string words_of(const LineDifference& line) {
  const std::string& first = line.lines[0].text;
  const std::string& second = line.lines[1].text;
  if (first == second || first.empty() || second.empty()) {
    return shown(first.empty() ? second : first);
  }
  return shown(first) + " -> " + shown(second);
}

// "path jerk", "path jerk -> programmed feedrate"
std::string limits_text(const LineDifference& line) {
  std::array<std::string, 2> names;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto& limits = line.lines[k].limits;
    names[k] = limits.empty() ? "none" : text_of(limits.front().limit);
  }
  return names[0] == names[1] ? names[0] : names[0] + " -> " + names[1];
}

std::string row(std::string_view name, const TwoTimes& times_s) {
  return fmt::format("    {:<22} {:>12} {:>12} {:>12}", name, fixed_number(times_s[0], 3),
                     fixed_number(times_s[1], 3), signed_s(difference_s(times_s)));
}

std::string heading(std::string_view what) {
  return fmt::format("  {:<24} {:>12} {:>12} {:>12}\n", what, "first, s", "second, s",
                     "difference");
}

std::string name_of(const FileReport& report) {
  return fmt::format("{} on {}", visible(report.file), visible(report.machine));
}

}  // namespace

std::string comparison_text(const ComparedReports& compared) {
  if (compared.comparison == nullptr) {
    return misfit_text(compared.first) + misfit_text(compared.second);
  }
  const Comparison& comparison = *compared.comparison;
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  first           {}   {}\n", clock_time(comparison.cycle_s[0]),
                 name_of(compared.first));
  fmt::format_to(out, "  second          {}   {}\n", clock_time(comparison.cycle_s[1]),
                 name_of(compared.second));
  fmt::format_to(out, "  difference      {} s{}\n", signed_s(difference_s(comparison.cycle_s)),
                 percent_of(comparison.cycle_s));
  text += heading("time");
  for (const auto& [name, times_s] :
       {std::pair{"cutting", comparison.cutting_s}, std::pair{"rapid", comparison.rapid_s},
        std::pair{"rest", comparison.rest_s}, std::pair{"tool change", comparison.tool_change_s}}) {
    if (times_s[0] > 0.0 || times_s[1] > 0.0) {
      text += row(name, times_s) + "\n";
    }
  }
  text += heading("limited by");
  for (const LimitDifference& limit : comparison.limits) {
    text += row(text_of(limit.limit), limit.times_s) + "\n";
  }
  if (comparison.lines.empty() && comparison.other_lines == 0) {
    return text + "  each line takes the same time in both\n";
  }
  text += heading("lines that differ most");
  for (const LineDifference& line : comparison.lines) {
    fmt::format_to(out, "{}   {}   {}\n", row(place_text(line), line.times_s), words_of(line),
                   limits_text(line));
  }
  if (comparison.other_lines > 0) {
    fmt::format_to(out, "    {:<22} {:>12} {:>12} {:>12}\n",
                   fmt::format("{} more", comparison.other_lines), "", "",
                   signed_s(comparison.other_lines_s));
  }
  return text;
}

}  // namespace kerf::program
