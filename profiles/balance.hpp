// The fastest member of a family of shapes, one of whose peaks grows as the other falls.
//
// T = max(a* dv / A, sqrt(j* dv / J)) depends on the member through j* / a*^2 against the severity
// kappa = dv J / A^2 alone. Three cases [SineSeries, figure 5]: jerk binds even for the member
// of the lowest j*; acceleration binds even for the one of the lowest a*; else the two are equal,
// j* = kappa a*^2, for one member between. That also turns the reach into one equation in the
// member p instead of two nested ones: dv = A^2/J j*/a*^2 and T = A/J j*/a* at the balance.
//
// Family:
//   static constexpr double kJerkBest, kAccelerationBest;  // the parameters of these two members
//   static ShapePeaks peaks(double p) noexcept;  // j* / a*^2 is monotone between them
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/roots.hpp>

#include "profiles/reach.hpp"

namespace kerf::profiles {

// The root of a function that is positive at `positive` and not positive at `other`.
struct Bracket {
  double positive = 0.0;
  double other = 0.0;
};

template <class Function>
double bracketed_root(const Bracket& bracket, Function function) {
  const double at_positive = function(bracket.positive);
  const double at_other = function(bracket.other);
  if (!(at_positive > 0.0)) {
    return bracket.positive;
  }
  if (!(at_other < 0.0)) {
    return bracket.other;
  }
  std::uintmax_t steps = 100;
  const boost::math::tools::eps_tolerance<double> tolerance(50);
  const bool ascending = bracket.other < bracket.positive;
  const auto root =
      ascending ? boost::math::tools::toms748_solve(function, bracket.other, bracket.positive,
                                                    at_other, at_positive, tolerance, steps)
                : boost::math::tools::toms748_solve(function, bracket.positive, bracket.other,
                                                    at_positive, at_other, tolerance, steps);
  return ascending ? root.first : root.second;  // the end where the function is not positive
}

inline double severity_ratio(const ShapePeaks& peaks) noexcept {
  return peaks.jerk / (peaks.acceleration * peaks.acceleration);
}

// The parameter of the fastest member for a change of feedrate of either sign.
template <class Family>
double balanced_parameter(double change_mm_s, const RampLimits& limits) {
  const double severity = std::abs(change_mm_s) / limits.acceleration_mm_s2 *
                          (limits.jerk_mm_s3 / limits.acceleration_mm_s2);
  if (!(severity > severity_ratio(Family::peaks(Family::kJerkBest)))) {
    return Family::kJerkBest;
  }
  if (severity >= severity_ratio(Family::peaks(Family::kAccelerationBest))) {
    return Family::kAccelerationBest;
  }
  return bracketed_root(
      {.positive = Family::kAccelerationBest, .other = Family::kJerkBest},
      [&](double p) { return std::log(severity_ratio(Family::peaks(p)) / severity); });
}

// See reach.hpp; for the fastest members.
template <class Family>
double balanced_reachable_change(const Approach& approach, const RampLimits& limits) {
  struct Balance {
    double change_mm_s;
    double length_mm;
  };
  const auto balance = [&](double p) {
    const ShapePeaks peaks = Family::peaks(p);
    const double time_s =
        limits.acceleration_mm_s2 / limits.jerk_mm_s3 * peaks.jerk / peaks.acceleration;
    const double change = limits.acceleration_mm_s2 * time_s / peaks.acceleration;
    return Balance{change, (approach.v_mm_s + 0.5 * change) * time_s};
  };
  const double jerk_best_mm = balance(Family::kJerkBest).length_mm;
  if (!(approach.length_mm > jerk_best_mm)) {
    return reachable_change(approach, Family::peaks(Family::kJerkBest), limits);
  }
  if (approach.length_mm >= balance(Family::kAccelerationBest).length_mm) {
    return reachable_change(approach, Family::peaks(Family::kAccelerationBest), limits);
  }
  const double p = bracketed_root(
      {.positive = Family::kAccelerationBest, .other = Family::kJerkBest},
      [&](double at) { return std::log(balance(at).length_mm / approach.length_mm); });
  return balance(p).change_mm_s;
}

}  // namespace kerf::profiles
