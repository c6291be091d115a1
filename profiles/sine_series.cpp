// The integral of phi has no elementary form, but a closed one all the same. With z = r e^(i
// theta), theta = 2 pi x, phi = x - (1 - r) / (2 pi r) Im(-log(1 - z)) integrates to
//   x^2 / 2 - (1 - r) / (4 pi^2 r) (Li2(r) - Re Li2(z)).
// The dilogarithm Li2 comes from its Bernoulli series in u = -log(1 - z), which converges as
// (|u| / 2 pi)^n; Li2(z) = pi^2/6 - log z log(1 - z) - Li2(1 - z) keeps |u| below 1.05. Known
// weakness: near x = 0 phi and its integral are differences of nearly equal numbers, so they carry
// an absolute error of some 1e-16, not a relative one.
#include "profiles/sine_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "profiles/balance.hpp"

namespace kerf::profiles {
namespace {

constexpr double kPi = std::numbers::pi;

struct Complex {
  double real = 0.0;
  double imaginary = 0.0;
};

Complex product(const Complex& a, const Complex& b) noexcept {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}

// Re Li2(1 - e^-u) = Re(u - u^2/4 + sum over k of B_2k u^(2k+1) / (2k+1)!), for |u| < 1.1.
double dilogarithm_series(const Complex& u) noexcept {
  constexpr std::array<double, 10> kBernoulli{1.0 / 36.0,
                                              -1.0 / 3600.0,
                                              1.0 / 211680.0,
                                              -1.0 / 10886400.0,
                                              1.0 / 526901760.0,
                                              -4.0647616451442256e-11,
                                              8.921691020456452e-13,
                                              -1.9939295860721074e-14,
                                              4.518980029619918e-16,
                                              -1.0356517612181247e-17};
  const Complex square = product(u, u);
  Complex sum;
  for (std::size_t k = kBernoulli.size(); k-- > 0;) {
    sum.real += kBernoulli[k];
    sum = product(sum, square);
  }
  return u.real - 0.25 * square.real + product(u, sum).real;
}

// A point z = r e^(i theta) of the unit disc, 0 <= theta <= pi, as its distances to 0 and 1.
struct DiscPoint {
  double gap;  // 1 - r
  double theta;
  double one_minus_cosine;  // of theta
  double sine;

  [[nodiscard]] double ratio() const noexcept { return 1.0 - gap; }
  // |1 - z|^2
  [[nodiscard]] double squared_distance() const noexcept {
    return gap * gap + 2.0 * ratio() * one_minus_cosine;
  }
  // Im(-log(1 - z))
  [[nodiscard]] double angle() const noexcept {
    return std::atan2(ratio() * sine, gap + ratio() * one_minus_cosine);
  }
};

double dilogarithm(const DiscPoint& z) noexcept {
  const double r = z.ratio();
  const double excess = r * (r - 2.0 + 2.0 * z.one_minus_cosine);  // |1 - z|^2 - 1
  const double log_distance =
      0.5 * (excess > -0.5 ? std::log1p(excess) : std::log(z.squared_distance()));
  const double angle = z.angle();
  if (r * (1.0 - z.one_minus_cosine) <= 0.5) {
    return dilogarithm_series({-log_distance, angle});
  }
  const double log_r = std::log1p(-z.gap);
  return kPi * kPi / 6.0 - (log_r * log_distance + z.theta * angle) -
         dilogarithm_series({-log_r, -z.theta});
}

// a* at x = 1/2; j* where cos 2 pi x = 1 - h, the root of docs/math.md, 2.7 without cancellation.
ShapePeaks peaks_of_gap(double gap) noexcept {
  const double r = 1.0 - gap;
  const double e = gap * gap;
  const double h =
      2.0 * e / (6.0 * r + e + std::sqrt((e + 2.0 * r) * (e + 2.0 * r) + 32.0 * r * r));
  const double sine = std::sqrt(h * (2.0 - h));
  const double d = e + 2.0 * r * h;
  return {.acceleration = 2.0 / (1.0 + r), .jerk = 2.0 * kPi * (1.0 + r) * e * sine / (d * d)};
}

// By the logarithm of 1 - r: j* / a*^2 is nearly a power of the gap.
struct Family {
  static constexpr double kJerkBest = -0.13136873356426446;        // log(1 - kGentlestRatio)
  static constexpr double kAccelerationBest = -20.72326583694641;  // log(kSmallestGap)
  static ShapePeaks peaks(double log_gap) noexcept { return peaks_of_gap(std::exp(log_gap)); }
};

double optimal_gap(double change_mm_s, const RampLimits& limits) {
  return std::exp(balanced_parameter<Family>(change_mm_s, limits));
}

}  // namespace

SineSeries::SineSeries(double ratio) noexcept
    : gap_(std::clamp(1.0 - ratio, kSmallestGap, 1.0)),
      dilogarithm_of_r_(
          dilogarithm({.gap = gap_, .theta = 0.0, .one_minus_cosine = 0.0, .sine = 0.0})) {}

SineSeries SineSeries::fastest(double change_mm_s, const RampLimits& limits) {
  return SineSeries{1.0 - optimal_gap(change_mm_s, limits)};
}

double SineSeries::duration_s(double change_mm_s, const RampLimits& limits) {
  return profiles::duration_s(change_mm_s, peaks_of_gap(optimal_gap(change_mm_s, limits)), limits);
}

double SineSeries::reachable_change(const Approach& approach, const RampLimits& limits) {
  return balanced_reachable_change<Family>(approach, limits);
}

ShapeValue SineSeries::at(double x) const noexcept {
  const bool second_half = x > 0.5;
  const double y = second_half ? 1.0 - x : x;
  const double half_sine = std::sin(kPi * y);
  const DiscPoint z{.gap = gap_,
                    .theta = 2.0 * kPi * y,
                    .one_minus_cosine = 2.0 * half_sine * half_sine,
                    .sine = 2.0 * half_sine * std::cos(kPi * y)};
  const double r = z.ratio();
  const double d = z.squared_distance();
  const double weight = r > 0.0 ? gap_ / (2.0 * kPi * r) : 0.0;
  ShapeValue value{
      .integral = 0.5 * y * y - weight / (2.0 * kPi) * (dilogarithm_of_r_ - dilogarithm(z)),
      .phi = y - weight * z.angle(),
      .slope = (1.0 + r) * z.one_minus_cosine / d,
      .curvature = 2.0 * kPi * (1.0 + r) * gap_ * gap_ * z.sine / (d * d)};
  if (!(r > 0.0)) {  // the limits of the quotients above
    value.integral = 0.5 * y * y - z.one_minus_cosine / (4.0 * kPi * kPi);
    value.phi = y - z.sine / (2.0 * kPi);
  }
  value.integral = std::max(value.integral, 0.0);
  value.phi = std::max(value.phi, 0.0);
  return second_half ? mirrored(x, value) : value;
}

double SineSeries::peak_acceleration() const noexcept {
  return peaks_of_gap(gap_).acceleration;
}

double SineSeries::peak_jerk() const noexcept {
  return peaks_of_gap(gap_).jerk;
}

}  // namespace kerf::profiles
