#include "bench/shortest_stop.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>

namespace kerf::bench {

namespace {

constexpr double kStep_s = 2e-5;
constexpr double kHardlyMoves = 1e-9;

struct Range {
  double low = 0.0;
  double high = 0.0;

  // |slope x + offset| <= limit
  void bind(double slope, double offset, double limit) {
    if (std::abs(slope) > kHardlyMoves && std::isfinite(limit)) {
      const double one = (-limit - offset) / slope;
      const double other = (limit - offset) / slope;
      low = std::max(low, std::min(one, other));
      high = std::min(high, std::max(one, other));
    }
  }
};

}  // namespace

double shortest_stop_mm(const test::PlannedPath& path, const PathState& from,
                        const MachineLimits& limits) {
  PathState at = from;
  while (at.v_mm_s > 0.0) {
    const curves::PathDerivatives q = path.derivatives_at(at.s_mm);
    const double v = at.v_mm_s;
    Range a{-limits.path.acceleration_mm_s2, limits.path.acceleration_mm_s2};
    Range j{-limits.path.jerk_mm_s3, limits.path.jerk_mm_s3};
    for (std::size_t k = 0; k < limits.axes.size(); ++k) {
      const MotionLimits& axis = limits.axes[k];
      a.bind(q.first[k], q.second_per_mm[k] * v * v, axis.acceleration_mm_s2);
      j.bind(q.first[k], 3.0 * q.second_per_mm[k] * v * at.a_mm_s2 + q.third_per_mm2[k] * v * v * v,
             axis.jerk_mm_s3);
    }
    if (j.low > j.high) {
      j = {-limits.path.jerk_mm_s3, limits.path.jerk_mm_s3};
    }
    // From here at a constant jerk to rest: t = 2v/|a|, so v t + a t^2/2 + j t^3/6 = 2/3 v^2/|a|.
    if (at.a_mm_s2 < 0.0 && 2.0 * v * j.high <= at.a_mm_s2 * at.a_mm_s2) {
      return at.s_mm - from.s_mm - 2.0 / 3.0 * v * v / at.a_mm_s2;
    }
    const double next_mm_s2 = std::max(at.a_mm_s2 + j.low * kStep_s, a.low);
    const double mean_mm_s2 = 0.5 * (at.a_mm_s2 + next_mm_s2);
    at.s_mm += kStep_s * (v + 0.5 * kStep_s * mean_mm_s2);
    at.v_mm_s += kStep_s * mean_mm_s2;
    at.a_mm_s2 = next_mm_s2;
  }
  return at.s_mm - from.s_mm;
}

void write_way(const std::string& file, const test::PlannedPath& path, const WayToRest& way) {
  constexpr double kBetween_mm = 0.002;
  constexpr double kFar = 1.5;
  std::ofstream out(file);
  out.precision(12);
  out << way.from.v_mm_s << ' ' << way.from.a_mm_s2 << ' ' << way.way_mm << '\n';
  for (const double a_mm_s2 : way.a_mm_s2) {
    out << a_mm_s2 << ' ';
  }
  out << '\n';
  const auto rows = static_cast<int>(std::ceil(kFar * way.way_mm / kBetween_mm));
  for (int i = 0; i < rows; ++i) {
    const double s_mm = i * kBetween_mm;
    const curves::PathDerivatives q = path.derivatives_at(way.from.s_mm + s_mm);
    out << s_mm;
    for (std::size_t k = 0; k < q.first.size(); ++k) {
      out << ' ' << q.first[k] << ' ' << q.second_per_mm[k] << ' ' << q.third_per_mm2[k];
    }
    out << '\n';
  }
}

}  // namespace kerf::bench
