// What the law suites run over: every law by name, and random transitions over many decades.
#pragma once

#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "profiles/profile.hpp"

namespace kerf::profiles::test {

struct Law {
  std::string name;
  ProfileKind kind;
  Profile profile;
  bool bounds_jerk = true;
};

inline void PrintTo(const Law& law, std::ostream* out) {
  *out << law.name;
}

inline std::vector<Law> all_laws() {
  using enum ProfileKind;
  return {{"trapezoid", trapezoid, Profile{trapezoid}, false},
          {"s_curve", s_curve, Profile{s_curve}},
          {"sine", sine, Profile{sine}},
          {"quintic", quintic, Profile{quintic}},
          {"sine_series", sine_series, Profile{sine_series}},
          {"sigmoid", sigmoid, Profile{sigmoid}},
          {"sigmoid_2", sigmoid, Profile{sigmoid, 2.0}},
          {"sigmoid_3_3", sigmoid, Profile{sigmoid, 3.3}},
          {"sigmoid_5", sigmoid, Profile{sigmoid, 5.0}}};
}

// Draws in the ranges of real machines and well beyond; the seed is fixed and printed with a
// failure.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : seed_(seed), engine_(seed) {}

  struct Range {
    double low;
    double high;
  };
  double log_uniform(const Range& range) {
    std::uniform_real_distribution<double> exponent(std::log(range.low), std::log(range.high));
    return std::exp(exponent(engine_));
  }
  double uniform(const Range& range) {
    return std::uniform_real_distribution<double>(range.low, range.high)(engine_);
  }
  bool once_in(int n) { return std::uniform_int_distribution<int>(1, n)(engine_) == 1; }

  RampLimits limits() {
    return {.acceleration_mm_s2 = log_uniform({1.0, 1e5}), .jerk_mm_s3 = log_uniform({1.0, 1e8})};
  }
  double feedrate() { return once_in(4) ? 0.0 : log_uniform({1e-4, 2000.0}); }
  double length() { return log_uniform({1e-9, 1e4}); }
  Ramp ramp() {
    const double v_begin = feedrate();
    return {.v_begin_mm_s = v_begin, .v_end_mm_s = feedrate()};
  }

  [[nodiscard]] std::uint64_t seed() const { return seed_; }

 private:
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

}  // namespace kerf::profiles::test
