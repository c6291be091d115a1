#include "programs/report.hpp"

#include <spdlog/fmt/fmt.h>

#include "programs/number_text.hpp"

namespace kerf::program {

std::array<LimitUse, 12> limit_uses(const MotionReport& motion,
                                    const lookahead::PlanLimits& limits) {
  constexpr std::array<std::string_view, 4> kWhere{"path", "x", "y", "z"};
  std::array<LimitUse, 12> uses;
  for (std::size_t i = 0; i < kWhere.size(); ++i) {
    const Peaks& peaks = i == 0 ? motion.path : motion.axes[i - 1];
    const lookahead::MotionLimits& bound = i == 0 ? limits.path : limits.axes[i - 1];
    uses[3 * i] = {kWhere[i], "velocity", "mm/s", peaks.v_mm_s, bound.velocity_mm_s};
    uses[3 * i + 1] = {kWhere[i], "acceleration", "mm/s2", peaks.a_mm_s2, bound.acceleration_mm_s2};
    uses[3 * i + 2] = {kWhere[i], "jerk", "mm/s3", peaks.j_mm_s3, bound.jerk_mm_s3};
  }
  return uses;
}

std::string describe(const LimitUse& use) {
  return fmt::format("{}{} {} {} {} is {:.3g} times its limit of {} {}",
                     use.where == "path" ? "" : "axis ", use.where, use.quantity,
                     short_number(use.peak), use.unit, use.ratio(), short_number(use.limit),
                     use.unit);
}

}  // namespace kerf::program
