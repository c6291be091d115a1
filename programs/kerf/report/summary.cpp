#include "programs/kerf/report/summary.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/report/block_text.hpp"
#include "programs/kerf/report/extents_text.hpp"
#include "programs/kerf/report/speed_text.hpp"

namespace kerf::program {

namespace {

constexpr std::size_t kPartsShown = 30;  // tools, and operations; the JSON report has them all

std::string percent(double value, double limit) {
  return std::isfinite(limit) ? fmt::format("{:.0f} %", 100.0 * value / limit) : "-";
}

std::string verdict(ExitStatus status) {
  switch (status) {
    case ExitStatus::done:
      return "done";
    case ExitStatus::machine_fault:
      return "stopped by a fault of the machine";
    case ExitStatus::io_error:
      return "input or output failed";
    case ExitStatus::interrupted:
    case ExitStatus::terminated:
    case ExitStatus::hung_up:
      return "stopped on the path, as asked for";
    case ExitStatus::stopped:
      return "stopped on the path";
    case ExitStatus::emergency_stop:
      return "emergency stop";
    default:
      return "failed";
  }
}

std::string approach_text(const FileReport& report) {
  const double approach_s = static_cast<double>(report.motion->time.approach) * report.period_s;
  return fmt::format("{} of rapids before the first cut, {} without", clock_time(approach_s),
                     clock_time(report.plan->cycle_time_s - approach_s));
}

void append_peaks(std::string& text, const FileReport& report) {
  const bool has_unit = report.feed_unit != FeedUnit::mm_s;
  text += "  largest         velocity mm/s     acceleration mm/s2      jerk mm/s3";
  text += has_unit ? fmt::format("   velocity {}\n", name_of(report.feed_unit)) : "\n";
  const auto uses = limit_uses(*report.motion, report.limits, report.extra_axes);
  for (std::size_t row = 0; row < uses.size(); row += 3) {
    fmt::format_to(std::back_inserter(text), "    {:<4} ", uses[row].where);
    for (std::size_t i = row; i < row + 3; ++i) {
      fmt::format_to(std::back_inserter(text), "{:>12} {:>7}   ", short_number(uses[i].peak),
                     percent(uses[i].peak, uses[i].limit));
    }
    if (uses[row].unit == "deg/s") {
      text += "in degrees";
    } else if (has_unit) {
      fmt::format_to(std::back_inserter(text), "{:>{}}",
                     short_number(per_mm_s(report.feed_unit) * uses[row].peak),
                     4 + name_of(report.feed_unit).size());
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
}

std::string deviation_text(const smoothing::PathDeviation& deviation) {
  const curves::Position& at = deviation.at_mm;
  return fmt::format("{:.6f} mm, {} of {:.6g} mm, line {}, x {}, y {}, z {} mm",
                     deviation.distance_mm, percent(deviation.distance_mm, deviation.tolerance_mm),
                     deviation.tolerance_mm, deviation.line, fixed_number(at[0], 3),
                     fixed_number(at[1], 3), fixed_number(at[2], 3));
}

std::string path_mode_text(const PathControlUse& use) {
  const PathControl& control = use.control;
  const std::string_view by = use.by_program ? "of the program" : "of the machine";
  switch (control.mode) {
    case PathMode::exact_path:
      return fmt::format("G61 {}", by);
    case PathMode::exact_stop:
      return fmt::format("G61.1 {}", by);
    case PathMode::blend:
      break;
  }
  return fmt::format("G64 {}, P {:.6g}, Q {:.6g} mm", by, control.corner_tolerance_mm,
                     control.merge_tolerance_mm);
}

std::string path_modes_text(const std::vector<PathControlUse>& uses) {
  std::string text;
  for (const PathControlUse& use : uses) {
    text += (text.empty() ? "" : "; then ") + path_mode_text(use);
  }
  return text;
}

std::string wait_text(const PlanWait& wait) {
  constexpr std::array kCodes{"M0", "M1", "M60", "M6", "spindle start"};
  std::string text = kCodes.at(static_cast<std::size_t>(wait.kind));
  if (wait.kind == PlanWait::Kind::tool_change) {
    text += fmt::format(" to T{}", wait.tool);
  }
  text += fmt::format(" in line {}", wait.line);
  return wait.duration_s > 0.0 ? text + fmt::format(" ({} s)", short_number(wait.duration_s))
                               : text;
}

std::string waits_text(const PlanWaits& waits) {
  std::string text;
  for (std::size_t i = 0; i < waits.first.size() && i < waits.count; ++i) {
    text += (i == 0 ? "" : ", ") + wait_text(waits.first[i]);
  }
  if (waits.count > waits.first.size()) {
    text += fmt::format(" and {} more", waits.count - waits.first.size());
  }
  return waits.duration_s > 0.0
             ? text + fmt::format("; {} s of the cycle time", short_number(waits.duration_s))
             : text;
}

// Empty where all of the time is one kind of it.
std::string time_text(const TimeSplit& time, double period_s) {
  const std::array parts{std::pair{"cutting", time.cutting}, std::pair{"rapid", time.rapid},
                         std::pair{"rest", time.rest}, std::pair{"tool change", time.tool_change}};
  std::string text;
  int named = 0;
  for (const auto& [name, ticks] : parts) {
    if (ticks > 0) {
      text += fmt::format("{}{} {}", named++ > 0 ? ", " : "", name,
                          clock_time(static_cast<double>(ticks) * period_s));
    }
  }
  return named > 1 ? text : "";
}

// Where there are several.
void append_parts(std::string& text, const FileReport& report) {
  const TimeParts& parts = report.motion->parts;
  const auto append = [&](std::string_view what, const std::vector<TimePart>& rows) {
    for (std::size_t i = 0; i < rows.size() && i < kPartsShown; ++i) {
      const std::string split = time_text(rows[i].time, report.period_s);
      fmt::format_to(std::back_inserter(text), "  {:<15} {}  {}{}\n", i == 0 ? what : "",
                     clock_time(static_cast<double>(rows[i].ticks()) * report.period_s),
                     visible(rows[i].name), split.empty() ? "" : ": " + split);
    }
    if (rows.size() > kPartsShown) {
      fmt::format_to(std::back_inserter(text), "  {:<15} and {} more\n", "",
                     rows.size() - kPartsShown);
    }
  };
  if (parts.tools.size() > 1) {
    append("by tool", parts.tools);
  }
  if (parts.operations.size() > 1) {
    append("by operation", parts.operations);
  }
}

void append_motion(std::string& text, const FileReport& report) {
  const MotionReport& motion = *report.motion;
  const auto out = std::back_inserter(text);
  append_peaks(text, report);
  const double tolerance_mm = report.limits.chord_tolerance_mm;
  fmt::format_to(out, "  chord error     {:.6f} mm", motion.chord_error_mm);
  if (std::isfinite(tolerance_mm)) {
    fmt::format_to(out, ", {} of {:.6g} mm", percent(motion.chord_error_mm, tolerance_mm),
                   tolerance_mm);
  }
  fmt::format_to(out, "\n  contour error   {:.6f} mm at most, {:.6f} mm in the mean\n",
                 motion.max_contour_error_mm, motion.mean_contour_error_mm);
  const auto& following = motion.max_following_error_mm;
  fmt::format_to(out, "  following error x {:.4f}, y {:.4f}, z {:.4f} mm at most\n", following[0],
                 following[1], following[2]);
}

void append_time(std::string& text, const FileReport& report) {
  const PlanReport& plan = *report.plan;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  cycle time      {}   {} of {:g} ms, {}\n", clock_time(plan.cycle_time_s),
                 counted(static_cast<unsigned long long>(plan.ticks), "tick"),
                 1000.0 * report.period_s, report.profile);
  if (report.feed_override != 1.0) {
    fmt::format_to(out, "  feed override   {:g} %\n", 100.0 * report.feed_override);
  }
  if (report.start) {
    fmt::format_to(out, "  started at      {}\n", name_of(report.start->place));
  }
  if (const std::string split =
          report.motion ? time_text(report.motion->time, report.period_s) : "";
      !split.empty()) {
    fmt::format_to(out, "  time            {}\n", split);
  }
  if (report.motion) {
    append_parts(text, report);
  }
  if (report.motion && report.motion->time.approach > 0) {
    fmt::format_to(out, "  approach        {}\n", approach_text(report));
  }
}

void append_clock(std::string& text, const ClockReport& clock) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  clock           {}, the worst delay {:.3f} ms\n",
                 counted(clock.late_ticks, "late tick"), 1000.0 * clock.worst_delay_s);
  const TimeHistogram& delays = clock.delays;
  const TimeHistogram& ticks = clock.tick_times;
  if (ticks.count() > 0) {
    fmt::format_to(out,
                   "  delays          half up to {:.3f} ms, 99 % {:.3f} ms, 99.9 % {:.3f} ms\n",
                   1000.0 * delays.quantile_s(0.5), 1000.0 * delays.quantile_s(0.99),
                   1000.0 * delays.quantile_s(0.999));
    fmt::format_to(out,
                   "  ticks took      {:.1f} us, 99.9 % up to {:.1f} us, the worst {:.1f} us\n",
                   1e6 * ticks.mean_s(), 1e6 * ticks.quantile_s(0.999), 1e6 * ticks.worst_s());
  }
}

// A check is over in a line: there are often many files.
std::string check_line(const FileReport& report) {
  const PlanReport& plan = *report.plan;
  std::string text = fmt::format("{}: ok, {}, {:.3f} mm in {}, {}\n", visible(report.file),
                                 clock_time(plan.cycle_time_s), plan.path_length_mm,
                                 counted(plan.blocks, "block"), extents_text(report));
  for (const std::string& warning : report.warnings) {
    fmt::format_to(std::back_inserter(text), "  warning         {}\n", visible(warning));
  }
  return text;
}

}  // namespace

std::string summary(const FileReport& report) {
  if (report.syntax_only && report.status == ExitStatus::done) {
    return fmt::format("{}: ok, the text alone\n", visible(report.file));
  }
  if (!report.plan) {
    return misfit_text(report);
  }
  if (report.command == Subcommand::explain) {
    return block_text(report);
  }
  if (report.command == Subcommand::check) {
    return check_line(report);
  }
  const PlanReport& plan = *report.plan;
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}\n", visible(report.file), verdict(report.status));
  append_time(text, report);
  fmt::format_to(out, "  path            {:.3f} mm in {}\n", plan.path_length_mm,
                 counted(plan.blocks, "block"));
  text += extents_rows(report);
  if (!plan.path_controls.empty()) {
    fmt::format_to(out, "  path mode       {}\n", path_modes_text(plan.path_controls));
  }
  if (plan.waits.count > 0) {
    fmt::format_to(out, "  waits           {}\n", waits_text(plan.waits));
  }
  if (plan.deviates()) {
    fmt::format_to(out, "  deviation       {}\n", deviation_text(plan.deviation));
  }
  if (report.motion) {
    append_motion(text, report);
  }
  text += speed_text(report);
  if (report.clock) {
    append_clock(text, *report.clock);
  }
  for (const std::string& warning : report.warnings) {
    fmt::format_to(out, "  warning         {}\n", visible(warning));
  }
  return text;
}

}  // namespace kerf::program
