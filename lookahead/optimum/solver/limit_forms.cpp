#include <algorithm>
#include <cmath>

#include "lookahead/optimum/solver/limit_rows.hpp"

namespace kerf::lookahead {

namespace {

// A limit that the others keep below this share of it cannot bind.
constexpr double kCannotBind = 0.5;
// Derivatives that differ by less, over a limit, are those of one place.
constexpr double kSamePlace = 1e-4;

}  // namespace

Forms forms_at(const Cell& cell, const PathSample& end, const PlanLimits& limits) {
  Forms forms;
  forms[0] = {.first = 1.0,
              .acceleration_mm_s2 = cell.shares.acceleration * cell.along.acceleration_mm_s2,
              .jerk_mm_s3 = cell.shares.jerk * cell.along.jerk_mm_s3};
  for (std::size_t k = 0; k + 1 < kForms; ++k) {
    forms[k + 1] = {
        .first = end.first[k],
        .second_per_mm = end.second_per_mm[k],
        .third_per_mm2 = end.third_per_mm2[k],
        .acceleration_mm_s2 = cell.shares.acceleration * limits.axes[k].acceleration_mm_s2,
        .jerk_mm_s3 = cell.shares.jerk * limits.axes[k].jerk_mm_s3,
        .jumps_per_mm_s = cell.jumps_per_mm_s[k]};
  }
  return forms;
}

Bounds bounds_of(const Forms& forms, double cap_mm_s) {
  Bounds bounds{.squared_mm2_s2 = cap_mm_s * cap_mm_s};
  double min_acceleration = kUnbounded;
  double min_jerk = kUnbounded;
  for (std::size_t k = 0; k < kForms; ++k) {
    const double size = std::abs(forms[k].first);
    if (size == 0.0) {
      continue;
    }
    const double a =
        (forms[k].acceleration_mm_s2 + std::abs(forms[k].second_per_mm) * bounds.squared_mm2_s2) /
        size;
    bounds.acceleration_mm_s2 = std::min(bounds.acceleration_mm_s2, a);
    if (forms[k].second_per_mm == 0.0 && a < min_acceleration) {
      min_acceleration = a;
      bounds.tightest_acceleration = k;
    }
  }
  for (std::size_t k = 0; k < kForms; ++k) {
    const double size = std::abs(forms[k].first);
    if (size == 0.0) {
      continue;
    }
    const double from_curvature =
        3.0 * std::abs(forms[k].second_per_mm) * cap_mm_s * bounds.acceleration_mm_s2 +
        std::abs(forms[k].third_per_mm2) * cap_mm_s * bounds.squared_mm2_s2;
    const double j = (forms[k].jerk_mm_s3 + (from_curvature > 0.0 ? from_curvature : 0.0)) / size;
    bounds.jerk_mm_s3 = std::min(bounds.jerk_mm_s3, j);
    if (forms[k].second_per_mm == 0.0 && forms[k].third_per_mm2 == 0.0 && j < min_jerk) {
      min_jerk = j;
      bounds.tightest_jerk = k;
    }
  }
  return bounds;
}

bool acceleration_may_bind(const Forms& forms, std::size_t k, const Bounds& bounds) {
  const Form& form = forms[k];
  if (!std::isfinite(form.acceleration_mm_s2)) {
    return false;
  }
  if (form.second_per_mm == 0.0) {
    return k == bounds.tightest_acceleration;
  }
  const double most = std::abs(form.first) * bounds.acceleration_mm_s2 +
                      std::abs(form.second_per_mm) * bounds.squared_mm2_s2;
  return !(most < kCannotBind * form.acceleration_mm_s2);
}

bool jerk_may_bind(const Forms& forms, std::size_t k, const Bounds& bounds) {
  const Form& form = forms[k];
  if (!std::isfinite(form.jerk_mm_s3)) {
    return false;
  }
  if (form.jumps_per_mm_s > 0.0) {
    return true;
  }
  if (form.second_per_mm == 0.0 && form.third_per_mm2 == 0.0) {
    return k == bounds.tightest_jerk;
  }
  const double v = std::sqrt(bounds.squared_mm2_s2);
  const double most = std::abs(form.first) * bounds.jerk_mm_s3 +
                      3.0 * std::abs(form.second_per_mm) * v * bounds.acceleration_mm_s2 +
                      std::abs(form.third_per_mm2) * bounds.squared_mm2_s2 * v;
  return !(most < kCannotBind * form.jerk_mm_s3);
}

bool are_one_place(const Forms& before, const Forms& after, double squared_mm2_s2) {
  for (std::size_t k = 0; k < kForms; ++k) {
    const double limit = std::min(before[k].acceleration_mm_s2, after[k].acceleration_mm_s2);
    if (std::abs(before[k].first - after[k].first) > kSamePlace ||
        std::abs(before[k].second_per_mm - after[k].second_per_mm) * squared_mm2_s2 >
            kSamePlace * limit) {
      return false;
    }
  }
  return true;
}

}  // namespace kerf::lookahead
