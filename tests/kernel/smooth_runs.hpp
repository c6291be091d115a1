// Long smooth paths, on which nothing but their end asks for a rest.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <kerf/machine.hpp>
#include <kerf/profile.hpp>
#include <kerf/report.hpp>

namespace kerf::test {

enum class SmoothKind : unsigned char {
  spline,       // degrees 2 to 9 of 2,500 points, three styles of knots, G61 and G64
  long_spline,  // the same of 20,000 points
  shipped,      // the shipped curves under random limits
  lines,        // 4,000 short lines through a smooth path, in G64
  random        // any random program: a rest of it that is not forced is one too many as well
};
inline constexpr std::array kSmoothKinds{SmoothKind::spline, SmoothKind::long_spline,
                                         SmoothKind::shipped, SmoothKind::lines,
                                         SmoothKind::random};

std::string_view name_of(SmoothKind kind);
std::size_t count_of(SmoothKind kind);

struct SmoothRun {
  std::string name;
  std::string text;
  MachineSettings settings;
};

// index < count_of(kind). The same index gives the same run.
SmoothRun smooth_run(SmoothKind kind, std::size_t index);

struct SmoothPlan {
  PlanDegradations degradations{};
  double time_s = 0.0;
  std::string complaint;  // the program has an error, or its plan is broken
};

// Without ticks.
SmoothPlan plan_of(const SmoothRun& run, ProfileKind profile = ProfileKind::time_optimal);

}  // namespace kerf::test
