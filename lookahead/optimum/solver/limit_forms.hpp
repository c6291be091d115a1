// The limits at one place of a path, each over what the motion along the path is there.
#pragma once

#include <array>
#include <cstddef>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

// |q' a + q'' v^2| <= A and |q' j + 3 q'' v a + q''' v^3| <= J, of the path or of an axis.
struct Form {
  double first = 0.0;
  double second_per_mm = 0.0;
  double third_per_mm2 = 0.0;
  double acceleration_mm_s2 = kUnbounded;
  double jerk_mm_s3 = kUnbounded;
};

// The path, then the axes.
inline constexpr std::size_t kForms = 4;
using Forms = std::array<Form, kForms>;

// With the cell's shares of the limits.
Forms forms_at(const Cell& cell, const PathSample& end, const PlanLimits& limits);

// What the motion may be at most at a place. A limit with q' alone bounds the motion along the
// path, and of those only the tightest counts.
struct Bounds {
  double squared_mm2_s2 = 0.0;
  double acceleration_mm_s2 = kUnbounded;
  double jerk_mm_s3 = kUnbounded;
  std::size_t tightest_acceleration = kForms;
  std::size_t tightest_jerk = kForms;
};

// cap: of the feedrate.
Bounds bounds_of(const Forms& forms, double cap_mm_s);

// Whether the other limits leave form k enough to come near its own.
bool acceleration_may_bind(const Forms& forms, std::size_t k, const Bounds& bounds);
bool jerk_may_bind(const Forms& forms, std::size_t k, const Bounds& bounds);

// The same acceleration at the end of a cell as at the begin of the next one.
bool are_one_place(const Forms& before, const Forms& after, double squared_mm2_s2);

}  // namespace kerf::lookahead
