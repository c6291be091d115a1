#include "lookahead/path/limits.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::lookahead {

const char* unbounded(const PlanLimits& limits) {
  const auto is_free = [&limits](double MotionLimits::*limit) {
    return !std::isfinite(limits.path.*limit) &&
           !std::all_of(limits.axes.begin(), limits.axes.end(),
                        [limit](const MotionLimits& axis) { return std::isfinite(axis.*limit); });
  };
  if (is_free(&MotionLimits::velocity_mm_s)) {
    return "velocity";
  }
  if (is_free(&MotionLimits::acceleration_mm_s2)) {
    return "acceleration";
  }
  return is_free(&MotionLimits::jerk_mm_s3) ? "jerk" : nullptr;
}

}  // namespace kerf::lookahead
