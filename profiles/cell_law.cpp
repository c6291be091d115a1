#include "profiles/cell_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

namespace kerf::profiles {

namespace {

static_assert(std::is_trivially_copyable_v<CellLaw>);

// Below it the series' next terms are lost in rounding.
constexpr double kSeries = 1e-2;

// The solutions of f'' = k f with f(0) = 0, f'(0) = 1 and of f'' = k f + 1 with f(0) = f'(0) = 0.
struct Waves {
  double odd = 0.0;    // sinh(w t) / w
  double even = 0.0;   // (cosh(w t) - 1) / w^2
  double slope = 1.0;  // of odd: cosh(w t)
};

Waves waves(double bend_per_s2, double t_s) noexcept {
  const double x = bend_per_s2 * t_s * t_s;
  if (std::abs(x) < kSeries) {
    const double odd = 1.0 + x / 6.0 * (1.0 + x / 20.0 * (1.0 + x / 42.0 * (1.0 + x / 72.0)));
    const double even = 1.0 + x / 12.0 * (1.0 + x / 30.0 * (1.0 + x / 56.0 * (1.0 + x / 90.0)));
    return {.odd = t_s * odd, .even = 0.5 * t_s * t_s * even, .slope = 1.0 + 0.5 * x * even};
  }
  const double w = std::sqrt(std::abs(bend_per_s2));
  const bool grows = bend_per_s2 > 0.0;
  // 2 sinh^2(w t / 2) = cosh(w t) - 1 without cancellation.
  const double half = grows ? std::sinh(0.5 * w * t_s) : std::sin(0.5 * w * t_s);
  const double even = 2.0 * half * half / (w * w);
  return {.odd = (grows ? std::sinh(w * t_s) : std::sin(w * t_s)) / w,
          .even = even,
          .slope = 1.0 + bend_per_s2 * even};
}

// atanh(y) / y over y^2 = q, and atan for a negative q.
double atanh_ratio(double q) noexcept {
  if (std::abs(q) < 1e-4) {
    return 1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q / 9.0)));
  }
  const double y = std::sqrt(std::abs(q));
  return (q > 0.0 ? std::atanh(y) : std::atan(y)) / y;
}

}  // namespace

// With w^2 = k, w s = (v0 + v1) tanh(w T / 2): the duration without a search.
CellLaw CellLaw::between(const Begin& begin, double length_mm) noexcept {
  assert(length_mm > 0.0 && begin.v_mm_s > 0.0);
  CellLaw law;
  law.begin_ = begin;
  law.length_mm_ = length_mm;
  const double squared = begin.v_mm_s * begin.v_mm_s +
                         length_mm * (2.0 * begin.a_mm_s2 + begin.bend_per_s2 * length_mm);
  law.v_end_mm_s_ = std::sqrt(std::max(squared, 0.0));
  const double mean = length_mm / (begin.v_mm_s + law.v_end_mm_s_);
  law.duration_s_ = 2.0 * mean * atanh_ratio(begin.bend_per_s2 * mean * mean);
  return law;
}

CellLaw CellLaw::launch(double v_end_mm_s, double length_mm) noexcept {
  assert(v_end_mm_s > 0.0 && length_mm > 0.0);
  CellLaw law;
  law.kind_ = Kind::launch;
  law.v_end_mm_s_ = v_end_mm_s;
  law.length_mm_ = length_mm;
  law.duration_s_ = 3.0 * length_mm / v_end_mm_s;
  return law;
}

CellLaw CellLaw::landing(double v_begin_mm_s, double length_mm) noexcept {
  CellLaw law = launch(v_begin_mm_s, length_mm);
  law.kind_ = Kind::landing;
  law.begin_.v_mm_s = v_begin_mm_s;
  law.v_end_mm_s_ = 0.0;
  return law;
}

CellLaw CellLaw::ramp(const RampStart& begin, double duration_s) noexcept {
  CellLaw law;
  law.kind_ = Kind::ramp;
  law.begin_ = {.v_mm_s = begin.v_mm_s, .a_mm_s2 = begin.a_mm_s2, .bend_per_s2 = begin.j_mm_s3};
  law.duration_s_ = duration_s;
  const PathMotion end = law.ramp_at(duration_s);
  law.length_mm_ = end.s_mm;
  law.v_end_mm_s_ = end.v_mm_s;
  return law;
}

// Newton's steps where they stay within what is left of the range, else its half.
double CellLaw::time_at_s(double s_mm) const noexcept {
  constexpr int kMaxSteps = 100;
  constexpr double kRounding = 1e-15;
  double low_s = 0.0;
  double high_s = duration_s_;
  double t_s = std::clamp(s_mm / length_mm_, 0.0, 1.0) * duration_s_;
  for (int i = 0; i < kMaxSteps && high_s - low_s > kRounding * duration_s_; ++i) {
    const PathMotion motion = at(t_s);
    const double miss_mm = motion.s_mm - s_mm;
    if (miss_mm == 0.0) {
      break;
    }
    (miss_mm > 0.0 ? high_s : low_s) = t_s;
    const double next_s = t_s - miss_mm / motion.v_mm_s;
    const bool is_inside = next_s > low_s && next_s < high_s;
    const double before_s = std::exchange(t_s, is_inside ? next_s : 0.5 * (low_s + high_s));
    if (std::abs(t_s - before_s) <= kRounding * duration_s_) {
      break;
    }
  }
  return t_s;
}

CellLaw CellLaw::part(const Times& times) const noexcept {
  const PathMotion begin = at(times.begin_s);
  const bool to_end = times.end_s >= duration_s_;
  const double way_mm = (to_end ? length_mm_ : at(times.end_s).s_mm) - begin.s_mm;
  if (kind_ == Kind::between) {
    return between(
        {.v_mm_s = begin.v_mm_s, .a_mm_s2 = begin.a_mm_s2, .bend_per_s2 = begin_.bend_per_s2},
        way_mm);
  }
  if (kind_ == Kind::landing && to_end) {
    return landing(begin.v_mm_s, way_mm);
  }
  return ramp({.v_mm_s = begin.v_mm_s, .a_mm_s2 = begin.a_mm_s2, .j_mm_s3 = begin.j_mm_s3},
              times.end_s - times.begin_s);
}

PathMotion CellLaw::ramp_at(double t_s) const noexcept {
  const auto& [v, a, jerk] = begin_;
  return {.s_mm = t_s * (v + t_s * (0.5 * a + t_s * jerk / 6.0)),
          .v_mm_s = std::max(v + t_s * (a + 0.5 * t_s * jerk), 0.0),
          .a_mm_s2 = a + t_s * jerk,
          .j_mm_s3 = jerk};
}

PathMotion CellLaw::at(double t_s) const noexcept {
  const double t = std::clamp(t_s, 0.0, duration_s_);
  if (kind_ == Kind::between) {
    const auto& [v, a, k] = begin_;
    const Waves w = waves(k, t);
    const double s = v * w.odd + a * w.even;
    const double v_now = v * w.slope + a * w.odd;
    return {.s_mm = std::min(s, length_mm_),
            .v_mm_s = std::max(v_now, 0.0),
            .a_mm_s2 = a + k * s,
            .j_mm_s3 = k * v_now};
  }
  if (kind_ == Kind::ramp) {
    return ramp_at(t);
  }
  const bool launches = kind_ == Kind::launch;
  const double jerk = 2.0 * (launches ? v_end_mm_s_ : begin_.v_mm_s) / (duration_s_ * duration_s_);
  const double from_rest = launches ? t : duration_s_ - t;
  const double s = jerk * from_rest * from_rest * from_rest / 6.0;
  return {.s_mm = launches ? s : std::max(length_mm_ - s, 0.0),
          .v_mm_s = 0.5 * jerk * from_rest * from_rest,
          .a_mm_s2 = launches ? jerk * from_rest : -jerk * from_rest,
          .j_mm_s3 = jerk};
}

}  // namespace kerf::profiles
