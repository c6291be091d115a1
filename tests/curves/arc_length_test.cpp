// The arc-length map against an independent quadrature of an independent evaluator.
#include "curves/arc_length.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "curves/arc_length_rule.hpp"
#include "tests/curves/reference_nurbs.hpp"
#include "tests/curves/shipped_curves.hpp"

namespace kerf::curves {
namespace {

using testing::NamedCurve;
using testing::RandomNurbsOptions;

// For every part: the point at s lies on the curve, s along it from the begin, and joints fit. The
// parameter is looked for again in long double, because one unit in the last place of a double u
// can be 1e-6 mm where weights differ by 1e6.
void expect_true_map(const NurbsData& data, const std::string& name) {
  const auto made = NurbsCurve::make(data);
  ASSERT_TRUE(made) << name << ": " << made.error().message;
  for (const NurbsCurve& curve : *made) {
    // A hundred times better than promised.
    const double tolerance_mm = 0.01 * kTotalTolerance_mm * std::max(1.0, curve.length_mm() / 1e3);
    long double reference_mm = 0.0L;
    long double u_before = static_cast<long double>(curve.pieces().front().u_begin);
    constexpr int kSamples = 60;
    for (int i = 0; i <= kSamples; ++i) {
      const double s_mm = curve.length_mm() * i / kSamples;
      const Position p = curve.at(s_mm);
      const double u_told = curve.pieces()[curve.piece_index(s_mm)].u_at(s_mm);
      const long double u =
          i == 0 ? u_before
                 : testing::reference_parameter(data, p, static_cast<long double>(u_told));
      ASSERT_NEAR(u_told, static_cast<double>(u), 1e-9 * std::max(1.0, std::abs(u_told)));
      reference_mm += testing::reference_length_mm(data, u_before, u);
      u_before = u;
      ASSERT_NEAR(static_cast<double>(reference_mm), s_mm, tolerance_mm) << name << ", u " << u;
      const testing::WideVector on_curve = testing::reference_point_mm(data, u);
      const double off_mm = static_cast<double>((on_curve - vec(p).cast<long double>()).norm());
      ASSERT_LT(off_mm, 1e-12) << name << ", u " << u;
    }
    for (std::size_t i = 1; i < curve.pieces().size(); ++i) {
      const NurbsPiece& before = curve.pieces()[i - 1];
      const NurbsPiece& after = curve.pieces()[i];
      ASSERT_EQ(before.s_end_mm, after.s_begin_mm);
      const double gap_mm =
          (vec(before.at(before.s_end_mm)) - vec(after.at(after.s_begin_mm))).norm();
      ASSERT_LT(gap_mm, 1e-12) << name << ", s " << after.s_begin_mm;
    }
  }
}

class ArcLengthOfShipped : public ::testing::TestWithParam<NamedCurve> {};

TEST_P(ArcLengthOfShipped, AgreesWithQuadrature) {
  expect_true_map(GetParam().data, GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(Curves, ArcLengthOfShipped, ::testing::ValuesIn(testing::shipped_curves()),
                         [](const auto& instance) { return instance.param.name; });

class ArcLengthOfRandom : public ::testing::TestWithParam<int> {};

TEST_P(ArcLengthOfRandom, AgreesWithQuadrature) {
  const int degree = GetParam();
  for (unsigned round = 0; round < 8; ++round) {
    const unsigned seed = 1000U * static_cast<unsigned>(degree) + round;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const double size_mm =
        std::pow(10.0, std::uniform_real_distribution<double>(-5.0, 2.3)(random));
    const NurbsData data = testing::random_nurbs(
        random, {.degree = degree,
                 .points = degree + 1 + static_cast<int>(round),
                 .size_mm = size_mm,
                 .weight_decades = round % 3 == 0 ? 0.0 : (round % 3 == 1 ? 1.0 : 3.0),
                 .max_repeats = round % 2 == 0 ? 1 : degree});
    expect_true_map(data, "random");
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, ArcLengthOfRandom, ::testing::Range(1, kMaxDegree + 1));

TEST(ArcLength, KeepsItsToleranceOverSpeedsThatVaryAMillionfold) {
  // Bezier cubics that start at a speed of 3e-4 mm per u and end at 300.
  NurbsData data{.degree = 3, .points = {}, .knots = testing::uniform_knots(3, 4)};
  data.points = {{{0.0, 0.0, 0.0}, 1.0},
                 {{1e-4, 0.0, 0.0}, 1.0},
                 {{1e-2, 2e-3, 0.0}, 1.0},
                 {{100.0, 50.0, 9.0}, 1.0}};
  expect_true_map(data, "millionfold");
}

NurbsData bezier(const std::vector<Position>& points) {
  NurbsData data{.degree = static_cast<int>(points.size()) - 1, .points = {}, .knots = {}};
  for (const Position& point : points) {
    data.points.push_back({.position_mm = point});
  }
  data.knots = testing::uniform_knots(data.degree, points.size());
  return data;
}

// Arc lengths between the parameters that the map tells, added up over all parts. Where |C'(u)|
// nearly vanishes u cannot be found again from the point, but a rounding of it is no way either.
double largest_length_error_mm(const NurbsData& data) {
  double worst = 0.0;
  const auto made = NurbsCurve::make(data);
  for (const NurbsCurve& curve : *made) {
    long double reference_mm = 0.0L;
    long double u_before = static_cast<long double>(curve.pieces().front().u_begin);
    for (const NurbsPiece& piece : curve.pieces()) {
      for (const double share : {0.1, 0.5, 0.9, 1.0}) {
        const double s_mm = piece.s_begin_mm + share * (piece.s_end_mm - piece.s_begin_mm);
        const auto u = static_cast<long double>(piece.u_at(s_mm));
        reference_mm += testing::reference_length_mm(data, u_before, u);
        u_before = u;
        worst = std::max(worst, std::abs(static_cast<double>(reference_mm) - s_mm));
      }
    }
  }
  return worst;
}

TEST(ArcLength, KeepsItsToleranceOnSingularCurves) {
  std::vector<NurbsData> all;
  for (const double crossing : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0.0}) {
    all.push_back(bezier({{0, 0, 0}, {10.0 + crossing, 10, 0}, {-crossing, 10, 0}, {10, 0, 0}}));
  }
  for (const double rise : {1e-1, 1e-3, 1e-5, 0.0}) {
    all.push_back(bezier({{0, 0, 0}, {10, rise, 0}, {0, 2.0 * rise, 0}}));
  }
  all.push_back(bezier({{0, 0, 0}, {0, 0, 0}, {5, 9, 0}, {10, 0, 0}, {15, 5, 0}, {15, 5, 0}}));
  all.push_back(bezier({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {5, 9, 2}, {10, 0, 0}, {15, 5, 0}}));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double error_mm = largest_length_error_mm(all[i]);
    RecordProperty("error_mm_" + std::to_string(i), std::to_string(1e12 * error_mm) + "e-12");
    EXPECT_LE(error_mm, kTotalTolerance_mm) << i;
  }
}

TEST(ArcLength, HoldsForClosePairsOfKnots) {
  NurbsData data = testing::shipped_curve("mazatrol");
  data.knots[5] = data.knots[4] + 1e-9;
  data.knots[8] = data.knots[7] + 1e-12;
  expect_true_map(data, "close knots");
}

TEST(ArcLengthRule, IntegratesPolynomialsExactly) {
  const ArcLengthRule& rule = ArcLengthRule::get();
  for (int power = 0; power < ArcLengthRule::kNodes; ++power) {
    const auto antiderivative = [&](double x) { return std::pow(x, power + 1) / (power + 1); };
    const Eigen::Matrix<double, ArcLengthRule::kNodes, 1> samples = rule.nodes.array().pow(power);
    const double whole = antiderivative(1.0) - antiderivative(-1.0);
    EXPECT_NEAR(rule.weights.dot(samples), whole, 1e-15);
    for (int j = 0; j < ArcLengthRule::kKnots; ++j) {
      EXPECT_NEAR(rule.to_knots.row(j).dot(samples),
                  antiderivative(rule.knots[j]) - antiderivative(-1.0), 1e-15);
    }
    for (int j = 0; j < ArcLengthRule::kChecks; ++j) {
      EXPECT_NEAR(rule.to_checks.row(j).dot(samples),
                  antiderivative(rule.checks[j]) - antiderivative(-1.0), 1e-15);
    }
  }
}

}  // namespace
}  // namespace kerf::curves
