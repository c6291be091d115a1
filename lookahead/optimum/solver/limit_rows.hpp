// All limits of a sequence of cells as linear forms over the coefficients of its spline.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/solver/barrier.hpp"
#include "lookahead/optimum/solver/feed_spline.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

// |q' a + q'' v^2| <= A and |q' j + 3 q'' v a + q''' v^3| + jumps v^2 <= J, of the path or of an
// axis.
struct Form {
  double first = 0.0;
  double second_per_mm = 0.0;
  double third_per_mm2 = 0.0;
  double acceleration_mm_s2 = kUnbounded;
  double jerk_mm_s3 = kUnbounded;
  double jumps_per_mm_s = 0.0;
};

// The path, then the axes.
inline constexpr std::size_t kForms = 4;
using Forms = std::array<Form, kForms>;

// With the cell's shares of the limits.
Forms forms_at(const Cell& cell, const PathSample& end, const PlanLimits& limits);

// Bounds of the motion along the path at a place. A limit with q' alone bounds the motion along the
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

// Two neighbouring cells of the spline side by side. c: the three coefficients of each.
struct CellPair {
  SimdPair length_mm = SimdPair::Zero();
  std::array<SimdPair, 3> middle{};   // b in the middle of the cell
  SimdPair begin = SimdPair::Zero();  // b at its begin is begin c0 + (1 - begin) c1
  SimdPair end = SimdPair::Zero();    // b at its end is (1 - end) c1 + end c2
  SimdPair cap = SimdPair::Zero();  // 1 over the largest c1: the spline lies below its coefficients
  // How many rows there are of each kind, in this order.
  std::uint8_t caps = 0;               // r0 c0 + r1 c1 <= 1, at its begin
  std::uint8_t accelerations = 0;      // |r0 c0 + r1 c1| <= 1, at its begin
  std::uint8_t end_accelerations = 0;  // |r1 c1 + r2 c2| <= 1, at its end
  std::uint8_t jerks = 0;              // sqrt(b) |r0 c0 + r1 c1 + r2 c2| <= 1, at its begin
  std::uint8_t end_jerks = 0;          // the same at its end
  std::uint8_t jump_jerks = 0;         // sqrt(b) |r0 c0 + r1 c1 + r2 c2| + r3 b <= 1, at its begin
  std::uint8_t end_jump_jerks = 0;     // the same at its end
};

// Along the path: v^2 <= cap^2, |b'| / 2 <= A, sqrt(b) |b''| / 2 <= J; on an axis: |q' b' / 2 + q''
// b| <= A and sqrt(b) |q' b'' / 2 + 3/2 q'' b' + q''' b| + jumps b <= J, divided by the limit
// (docs/math.md, 5.1). Each limit has a row where its value may be largest, but only one: between
// two continuous cells the acceleration once, of limits with a common direction along the path the
// tightest, and none that the others keep below half of it.
struct LimitRows {
  std::vector<CellPair> pairs;  // a cell without neighbour has one of no length
  std::vector<SimdPair> rows;   // of all pairs, in order
};

// basis: of the cells.
LimitRows limit_rows(std::span<const Cell> cells, std::span<const CellBasis> basis,
                     const PlanLimits& limits);

}  // namespace kerf::lookahead
