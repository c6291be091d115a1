#include "programs/kerf/report/report.hpp"

#include <utility>

#include <spdlog/fmt/fmt.h>

#include "diagnostics/errors/pages.hpp"
#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/report/extra_axes.hpp"

namespace kerf::program {

void FileReport::fail(ExitStatus why, std::string message) {
  if (status == ExitStatus::done) {
    status = why;
  }
  failures.push_back(std::move(message));
}

void FileReport::fail(const RunFault& fault) {
  const std::string line = fault.line != 0 ? ", in line " + std::to_string(fault.line) : "";
  fail(ExitStatus::internal_error, file + ": internal error" + line + ": " + fault.what);
}

void FileReport::take(const std::vector<diagnostics::Diagnostic>& found) {
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
}

void FileReport::fail_too_long(const TooLong& at) {
  take({{{.line = at.line, .column = 1},
         errors::kTooLong,
         fmt::format("up to here the program takes more than the {} s that are allowed",
                     at.max_time_s)}});
  if (status == ExitStatus::done) {
    status = ExitStatus::program_error;
  }
}

std::vector<LimitUse> limit_uses(const MotionReport& motion, const lookahead::PlanLimits& limits,
                                 parser::Letters extra_axes) {
  constexpr std::array<std::string_view, 4> kWhere{"path", "x", "y", "z"};
  std::vector<LimitUse> uses(12);
  for (std::size_t i = 0; i < kWhere.size(); ++i) {
    const Peaks& peaks = i == 0 ? motion.path : motion.axes[i - 1];
    const lookahead::MotionLimits& bound = i == 0 ? limits.path : limits.axes[i - 1];
    uses[3 * i] = {kWhere[i], "velocity", "mm/s", peaks.v_mm_s, bound.velocity_mm_s};
    uses[3 * i + 1] = {kWhere[i], "acceleration", "mm/s2", peaks.a_mm_s2, bound.acceleration_mm_s2};
    uses[3 * i + 2] = {kWhere[i], "jerk", "mm/s3", peaks.j_mm_s3, bound.jerk_mm_s3};
  }
  for (const ExtraAxis& axis : program::extra_axes(extra_axes)) {
    const Peaks& peaks = motion.extra[axis.index];
    const lookahead::MotionLimits& bound = limits.extra[axis.index];
    const bool rotary = parser::is_rotary(axis.index);
    const double k = axis.factor;
    uses.push_back({axis.name, "velocity", rotary ? "deg/s" : "mm/s", k * peaks.v_mm_s,
                    k * bound.velocity_mm_s});
    uses.push_back({axis.name, "acceleration", rotary ? "deg/s2" : "mm/s2", k * peaks.a_mm_s2,
                    k * bound.acceleration_mm_s2});
    uses.push_back(
        {axis.name, "jerk", rotary ? "deg/s3" : "mm/s3", k * peaks.j_mm_s3, k * bound.jerk_mm_s3});
  }
  return uses;
}

std::string describe(const LimitUse& use) {
  return fmt::format("{}{} {} {} {} is {:.3g} times its limit of {} {}",
                     use.where == "path" ? "" : "axis ", use.where, use.quantity,
                     short_number(use.peak), use.unit, use.ratio(), short_number(use.limit),
                     use.unit);
}

namespace {

std::string what_happens(const PlanDegradation& at) {
  using Kind = PlanDegradation::Kind;
  switch (at.kind) {
    case Kind::stop:
      return fmt::format("stops {:.6f} mm from the curve's begin", at.s_mm);
    case Kind::classical:
      return fmt::format(
          "follows a classical profile's plan from {:.6f} mm on, up to its next stop", at.s_mm);
    case Kind::slower:
      break;
  }
  return fmt::format("is slower than it could be from {:.6f} mm on, up to its next stop", at.s_mm);
}

}  // namespace

std::vector<std::string> describe(const PlanDegradations& degradations) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < degradations.kept(); ++i) {
    const PlanDegradation& at = degradations.first[i];
    const std::string what = what_happens(at);
    warnings.push_back(
        fmt::format("the time optimum was not found within its budget on line {}: the motion {}",
                    at.line, what));
  }
  if (degradations.count > warnings.size()) {
    warnings.push_back(fmt::format("the time optimum was not found at {}",
                                   counted(degradations.count - warnings.size(), "more place")));
  }
  return warnings;
}

}  // namespace kerf::program
