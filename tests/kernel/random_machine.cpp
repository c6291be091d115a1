#include "tests/kernel/random_machine.hpp"

#include <algorithm>
#include <cmath>

#include "lookahead/path/limits.hpp"
#include "parser/text/letters.hpp"

namespace kerf::test {

MachineSettings random_machine(std::uint64_t seed, Spread spread) {
  MachineSettings settings;
  auto pick = [state = seed * 2654435761U + 1]() mutable {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  for (lookahead::MotionLimits& axis : settings.limits.axes) {
    axis = {.velocity_mm_s = 50.0 + 450.0 * pick(),
            .acceleration_mm_s2 = 500.0 * std::pow(20.0, pick()),
            .jerk_mm_s3 = 5e3 * std::pow(100.0, pick())};
  }
  if (pick() < 0.5) {
    settings.limits.path = {
        .velocity_mm_s = 400.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 6e4};
  }
  settings.limits.chord_tolerance_mm = 1e-5 * std::pow(1000.0, pick());
  settings.program.extra_axes = parser::letters('A', 'U');
  for (const std::size_t axis : {0U, 3U}) {
    settings.limits.extra[axis] = {.velocity_mm_s = 2.0 + 20.0 * pick(),
                                   .acceleration_mm_s2 = 20.0 * std::pow(20.0, pick()),
                                   .jerk_mm_s3 = 5e2 * std::pow(50.0, pick())};
  }
  if (spread == Spread::wide) {
    for (lookahead::MotionLimits& axis : settings.limits.axes) {
      axis.velocity_mm_s *= std::pow(1e4, pick() - 0.5);
      axis.acceleration_mm_s2 *= std::pow(1e4, pick() - 0.5);
      axis.jerk_mm_s3 *= std::pow(1e4, pick() - 0.5);
    }
  }
  return settings;
}

double unhurried_mm(const MachineSettings& settings) {
  double slowest_mm_s = lookahead::kUnbounded;
  for (const lookahead::MotionLimits& axis : settings.limits.axes) {
    slowest_mm_s = std::min(slowest_mm_s, axis.velocity_mm_s);
  }
  return 2.0 * slowest_mm_s;
}

}  // namespace kerf::test
