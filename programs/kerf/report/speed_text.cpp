#include "programs/kerf/report/speed_text.hpp"

#include <iterator>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/number_text.hpp"

namespace kerf::program {

namespace {

constexpr double kShown = 0.005;  // of a line's time: shares below are left out there

double share_of(std::int64_t ticks, const LineSpeed& whole) {
  return whole.ticks > 0 ? static_cast<double>(ticks) / static_cast<double>(whole.ticks) : 0.0;
}

std::string limits_text(const LineSpeed& line) {
  std::string text;
  for (const LimitTime& part : line.limits) {
    if (const double share = share_of(part.ticks, line); share >= kShown) {
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", text_of(part.limit),
                          100.0 * share);
    }
  }
  return text;
}

// "20 mm/s (1200 mm/min)"
std::string feed_text(double v_mm_s, FeedUnit unit) {
  const std::string text = short_number(v_mm_s) + " mm/s";
  return unit == FeedUnit::mm_s ? text
                                : fmt::format("{} ({} {})", text,
                                              short_number(per_mm_s(unit) * v_mm_s), name_of(unit));
}

}  // namespace

std::string speed_text(const FileReport& report) {
  if (!report.speed) {
    return {};
  }
  const SpeedReport& speed = *report.speed;
  const auto seconds = [&report](std::int64_t ticks) {
    return static_cast<double>(ticks) * report.period_s;
  };
  std::string text = "  limited by\n";
  const auto out = std::back_inserter(text);
  for (const LimitTime& part : speed.whole.limits) {
    fmt::format_to(out, "    {:<22} {:>10.3f} s {:>6.1f} %\n", text_of(part.limit),
                   seconds(part.ticks), 100.0 * share_of(part.ticks, speed.whole));
  }
  fmt::format_to(out, "  comes to rest   {}\n",
                 counted(static_cast<unsigned long long>(speed.stops), "time"));
  if (report.speed_question.line && speed.lines.empty()) {
    fmt::format_to(out, "  line {} takes no time\n", *report.speed_question.line);
  } else if (!report.speed_question.line) {
    text += "  lines that take the longest\n";
  }
  for (const LineSpeed& line : speed.lines) {
    fmt::format_to(out, "    line {:<7} {:>10.3f} s {:>6.1f} %   {}\n", line.line,
                   seconds(line.ticks), 100.0 * share_of(line.ticks, speed.whole),
                   limits_text(line));
  }
  if (speed.tick) {
    fmt::format_to(out, "  at {} s: line {}, {}, limited by {}\n",
                   fixed_number(seconds(speed.tick->tick), 3), speed.tick->line,
                   feed_text(speed.tick->v_mm_s, report.feed_unit), text_of(speed.tick->limit));
  } else if (report.speed_question.time_s) {
    fmt::format_to(out, "  at {} s the program does not run\n",
                   fixed_number(*report.speed_question.time_s, 3));
  }
  return text;
}

}  // namespace kerf::program
