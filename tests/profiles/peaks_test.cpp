// Peak constants against published and derived values, and the free parameters against brute force.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"
#include "tests/profiles/laws.hpp"

namespace kerf::profiles::test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(ShapePeaks, OfTheClosedFormsAreTheTabulated) {
  EXPECT_EQ(Trapezoid{}.peak_acceleration(), 1.0);
  EXPECT_TRUE(std::isinf(Trapezoid{}.peak_jerk()));
  EXPECT_DOUBLE_EQ(Sine{}.peak_acceleration(), kPi / 2.0);
  EXPECT_DOUBLE_EQ(Sine{}.peak_jerk(), kPi * kPi / 2.0);
  EXPECT_DOUBLE_EQ(Quintic{}.peak_acceleration(), 15.0 / 8.0);
  EXPECT_DOUBLE_EQ(Quintic{}.peak_jerk(), 10.0 / std::sqrt(3.0));
  // The triangular S-curve: dv = J (T/2)^2 and A = J T/2.
  EXPECT_DOUBLE_EQ(SCurve{0.5}.peak_jerk(), 4.0);
  EXPECT_DOUBLE_EQ(SCurve{0.5}.peak_acceleration(), 2.0);
}

// The run of [Quintic, table 3]: 0 to 800 mm/min in 0.2 s.
TEST(ShapePeaks, OfTheQuinticAreThoseOfItsPaper) {
  const Transition run({.v_begin_mm_s = 0.0, .v_end_mm_s = 800.0 / 60.0}, 0.2, Quintic{});
  EXPECT_NEAR(run.at(0.1).a_mm_s2, 125.0, 1e-9);
  const double peak_at = 0.2 * (0.5 - std::sqrt(3.0) / 6.0);  // 0.211 T
  EXPECT_NEAR(run.at(peak_at).j_mm_s3, 1924.5, 0.05);
  EXPECT_NEAR(run.at(0.2 - peak_at).j_mm_s3, -1924.5, 0.05);
}

TEST(ShapePeaks, OfTheSineSeriesAreThoseOfItsRatio) {
  struct Row {
    double ratio, acceleration, jerk;
  };
  for (const Row& row : {Row{0.0, 2.0, 6.2832}, Row{0.1, 1.8182, 5.9366}, Row{0.2, 1.6667, 6.0359},
                         Row{0.3, 1.5385, 6.4753}, Row{0.5, 1.3333, 8.4800}}) {
    EXPECT_NEAR(SineSeries{row.ratio}.peak_acceleration(), row.acceleration, 5e-5);
    EXPECT_NEAR(SineSeries{row.ratio}.peak_jerk(), row.jerk, 5e-5);
  }
}

TEST(ShapePeaks, OfTheSigmoidAreTheTruePeaksNotThePapersBound) {
  EXPECT_NEAR(Sigmoid{3.3}.peak_acceleration(), 1.7764, 5e-5);
  EXPECT_NEAR(Sigmoid{3.3}.peak_jerk(), 4.4628, 5e-5);
  EXPECT_NEAR(Sigmoid{2.0}.peak_acceleration(), 1.313, 5e-4);
}

// phi' and phi'' of the sigmoid with cubic ends straight from its definition with the logistic
// function f, as the paper writes it.
struct SigmoidDefinition {
  explicit SigmoidDefinition(double shape) : s(shape), c(2.0 * f(shape) - 1.0) {
    const double p = (f(-s / 3.0) - f(-s)) / c;
    const double q = middle_slope(1.0 / 3.0);
    b2 = 27.0 * p - 3.0 * q;
    b1 = 9.0 * q - 54.0 * p;
  }
  static double f(double x) { return 1.0 / (1.0 + std::exp(-x)); }
  [[nodiscard]] double middle_slope(double x) const {
    const double g = f(2.0 * s * x - s);
    return 2.0 * s * g * (1.0 - g) / c;
  }
  [[nodiscard]] double slope(double x) const {
    return x < 1.0 / 3.0 ? x * (3.0 * b1 * x + 2.0 * b2) : middle_slope(x);
  }
  [[nodiscard]] double curvature(double x) const {
    const double g = f(2.0 * s * x - s);
    return x < 1.0 / 3.0 ? 6.0 * b1 * x + 2.0 * b2
                         : 4.0 * s * s * g * (1.0 - g) * (1.0 - 2.0 * g) / c;
  }
  [[nodiscard]] ShapePeaks peaks() const {
    ShapePeaks most{.acceleration = 0.0, .jerk = 0.0};
    constexpr int kSamples = 1200;  // over the first half; a multiple of 3 meets the joint
    for (int i = 0; i <= kSamples; ++i) {
      const double x = 0.5 * i / kSamples;
      most.acceleration = std::max(most.acceleration, slope(x));
      most.jerk = std::max(most.jerk, std::abs(curvature(x)));
    }
    return most;
  }
  double s, c, b1 = 0.0, b2 = 0.0;
};

TEST(ShapePeaks, OfEverySigmoidAreWhatItsDefinitionShows) {
  for (double s = 0.2; s < 5.1; s += 0.05) {
    const ShapePeaks expected = SigmoidDefinition{s}.peaks();
    EXPECT_NEAR(Sigmoid{s}.peak_acceleration(), expected.acceleration, 1e-5) << "s = " << s;
    EXPECT_NEAR(Sigmoid{s}.peak_jerk(), expected.jerk, 0.05) << "s = " << s;
    EXPECT_GE(Sigmoid{s}.peak_jerk(), expected.jerk * (1.0 - 1e-12)) << "s = " << s;
  }
}

struct Member {
  double parameter;
  ShapePeaks peaks;
};

double shortest(const std::vector<Member>& members, double change, const RampLimits& limits) {
  double best = std::numeric_limits<double>::infinity();
  for (const Member& member : members) {
    best = std::min(best, std::max(member.peaks.acceleration * change / limits.acceleration_mm_s2,
                                   std::sqrt(member.peaks.jerk * change / limits.jerk_mm_s3)));
  }
  return best;
}

// Changes of feedrate from where jerk binds throughout to where acceleration does.
std::vector<double> severities() {
  std::vector<double> all;
  for (double kappa = 0.3; kappa < 300.0; kappa *= 1.17) {
    all.push_back(kappa);
  }
  return all;
}

TEST(OptimalShape, OfTheSigmoidBeatsEveryOther) {
  std::vector<Member> members;
  for (double s = Sigmoid::kSmallestShape; s <= Sigmoid::kLargestShape; s += 0.002) {
    members.push_back({s, SigmoidDefinition{s}.peaks()});
  }
  const Profile profile(ProfileKind::sigmoid);
  const RampLimits limits{.acceleration_mm_s2 = 100.0, .jerk_mm_s3 = 1000.0};
  for (const double kappa : severities()) {
    const double change = kappa * 10.0;  // A^2 / J = 10
    const double best = shortest(members, change, limits);
    EXPECT_LE(profile.duration_s(change, limits), best * (1.0 + 1e-5)) << "kappa " << kappa;
    EXPECT_GE(profile.duration_s(change, limits), best * (1.0 - 2e-3)) << "kappa " << kappa;
  }
}

TEST(OptimalRatio, OfTheSineSeriesBeatsEveryOther) {
  std::vector<Member> members;
  for (double r = 1e-4; r < 0.99995; r += 1e-4) {
    const double sum = 1.0 + r * r;
    const double cosine = (-sum + std::sqrt(sum * sum + 32.0 * r * r)) / (4.0 * r);
    const double d = 1.0 - 2.0 * r * cosine + r * r;
    const double jerk =
        2.0 * kPi * (1.0 + r) * (1.0 - r) * (1.0 - r) * std::sqrt(1.0 - cosine * cosine) / (d * d);
    members.push_back({r, {.acceleration = 2.0 / (1.0 + r), .jerk = jerk}});
  }
  const Profile profile(ProfileKind::sine_series);
  const RampLimits limits{.acceleration_mm_s2 = 100.0, .jerk_mm_s3 = 1000.0};
  for (const double kappa : severities()) {
    const double change = kappa * 10.0;
    const double best = shortest(members, change, limits);
    EXPECT_LE(profile.duration_s(change, limits), best * (1.0 + 1e-12)) << "kappa " << kappa;
    EXPECT_GE(profile.duration_s(change, limits), best * (1.0 - 1e-4)) << "kappa " << kappa;
  }
}

// The three cases of [SineSeries, figure 5].
TEST(OptimalRatio, FollowsTheLimitThatBinds) {
  const RampLimits limits{.acceleration_mm_s2 = 100.0, .jerk_mm_s3 = 1000.0};
  EXPECT_EQ(SineSeries::fastest(1e-3, limits).ratio(), SineSeries::kGentlestRatio);
  EXPECT_NEAR(SineSeries::fastest(1e13, limits).ratio(), 1.0 - SineSeries::kSmallestGap, 1e-15);
  const SineSeries crossing = SineSeries::fastest(100.0, limits);
  EXPECT_NEAR(crossing.peak_acceleration() * 100.0 / 100.0,
              std::sqrt(crossing.peak_jerk() * 100.0 / 1000.0), 1e-12);
  EXPECT_DOUBLE_EQ(SineSeries::kGentlestRatio, std::sqrt(17.0) - 4.0);
}

TEST(SCurve, TakesTheOptimalDurationOfBothCases) {
  const Profile profile(ProfileKind::s_curve);
  const RampLimits limits{.acceleration_mm_s2 = 100.0, .jerk_mm_s3 = 1000.0};
  EXPECT_DOUBLE_EQ(profile.duration_s(40.0, limits), 0.4 + 0.1);  // dv / A + A / J
  EXPECT_DOUBLE_EQ(profile.duration_s(2.5, limits), 0.1);         // 2 sqrt(dv / J)
  EXPECT_DOUBLE_EQ(profile.duration_s(10.0, limits), 0.2);        // where they meet
  EXPECT_DOUBLE_EQ(SCurve::fastest(40.0, limits).jerk_share(), 0.2);
  EXPECT_EQ(SCurve::fastest(2.5, limits).jerk_share(), 0.5);
}

}  // namespace
}  // namespace kerf::profiles::test
