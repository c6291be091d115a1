// The normalised shapes themselves: ends, symmetry, derivatives, integral, peaks.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "profiles/transition.hpp"

namespace kerf::profiles::test {
namespace {

struct Specimen {
  std::string name;
  Shape shape;
  std::vector<double> joints{};  // where phi'' jumps between the ends
  double peak_tolerance = 1e-5;  // of sampling, relative
};

void PrintTo(const Specimen& specimen, std::ostream* out) {
  *out << specimen.name;
}

ShapeValue at(const Shape& shape, double x) {
  return std::visit([x](const auto& law) { return law.at(x); }, shape);
}

class ShapeLaws : public ::testing::TestWithParam<Specimen> {
 protected:
  [[nodiscard]] ShapeValue value(double x) const { return at(GetParam().shape, x); }
  [[nodiscard]] double peak_jerk() const {
    return std::visit([](const auto& law) { return law.peak_jerk(); }, GetParam().shape);
  }
  [[nodiscard]] double peak_acceleration() const {
    return std::visit([](const auto& law) { return law.peak_acceleration(); }, GetParam().shape);
  }
  // The scale of phi'': 0 jerk (the trapezoid's "infinite" peak is at its ends only) counts as 1.
  [[nodiscard]] double jerk_scale() const { return std::isinf(peak_jerk()) ? 1.0 : peak_jerk(); }
  [[nodiscard]] bool near_joint(double x, double distance) const {
    return std::any_of(GetParam().joints.begin(), GetParam().joints.end(),
                       [&](double joint) { return std::abs(x - joint) <= distance; });
  }
};

INSTANTIATE_TEST_SUITE_P(
    All, ShapeLaws,
    ::testing::Values(Specimen{"trapezoid", Trapezoid{}}, Specimen{"triangle", SCurve{0.5}, {0.5}},
                      Specimen{"s_curve", SCurve{0.2}, {0.2, 0.8}},
                      Specimen{"steep_s_curve", SCurve{1e-3}, {1e-3, 0.999}},
                      Specimen{"s_curve_without_jerk", SCurve{0.0}}, Specimen{"sine", Sine{}},
                      Specimen{"quintic", Quintic{}}, Specimen{"series_0", SineSeries{0.0}},
                      Specimen{"series_tiny", SineSeries{1e-7}},
                      Specimen{"series_gentlest", SineSeries{}},
                      Specimen{"series_half", SineSeries{0.5}},
                      Specimen{"series_0_9", SineSeries{0.9}},
                      Specimen{"series_0_99", SineSeries{0.99}, {}, 1e-3},
                      Specimen{"sigmoid_0_1", Sigmoid{0.1}, {1.0 / 3.0, 2.0 / 3.0}},
                      Specimen{"sigmoid_2", Sigmoid{2.0}, {1.0 / 3.0, 2.0 / 3.0}},
                      Specimen{"sigmoid_3_3", Sigmoid{3.3}, {1.0 / 3.0, 2.0 / 3.0}},
                      Specimen{"sigmoid_4_5", Sigmoid{4.5}, {1.0 / 3.0, 2.0 / 3.0}},
                      Specimen{"sigmoid_5_11", Sigmoid{5.11}, {1.0 / 3.0, 2.0 / 3.0}}),
    [](const auto& instance) { return instance.param.name; });

TEST_P(ShapeLaws, RunFromZeroToOneAndCoverOneHalf) {
  EXPECT_EQ(value(0.0).phi, 0.0);
  EXPECT_EQ(value(0.0).integral, 0.0);
  EXPECT_EQ(value(1.0).phi, 1.0);
  EXPECT_EQ(value(1.0).integral, 0.5);
  if (std::isfinite(peak_jerk())) {
    EXPECT_EQ(value(0.0).slope, 0.0);
    EXPECT_EQ(value(1.0).slope, 0.0);
  }
}

TEST_P(ShapeLaws, AreTheirOwnMirrorImage) {
  for (int i = 0; i <= 1000; ++i) {
    const double x = (i + 0.21) / 1001.0;
    ASSERT_NEAR(value(x).phi + value(1.0 - x).phi, 1.0, 1e-14);
    ASSERT_NEAR(value(x).slope, value(1.0 - x).slope, 1e-12 * jerk_scale());
    ASSERT_NEAR(value(x).curvature, -value(1.0 - x).curvature, 1e-10 * jerk_scale());
  }
}

TEST_P(ShapeLaws, NeverTurnBack) {
  double last = 0.0;
  for (int i = 0; i <= 20000; ++i) {
    const ShapeValue here = value(i / 20000.0);
    ASSERT_GE(here.phi, last - 1e-15);
    ASSERT_GE(here.slope, 0.0);
    last = here.phi;
  }
}

TEST_P(ShapeLaws, DifferentiateIntoEachOther) {
  const double h = 1e-5;
  for (int i = 0; i < 3000; ++i) {
    const double x = 2.0 * h + (1.0 - 4.0 * h) * (i + 0.5) / 3000.0;
    const ShapeValue before = value(x - h);
    const ShapeValue here = value(x);
    const ShapeValue after = value(x + h);
    ASSERT_NEAR((after.integral - before.integral) / (2.0 * h), here.phi,
                5e-11 * (1.0 + jerk_scale()))
        << "x " << x;
    ASSERT_NEAR((after.phi - before.phi) / (2.0 * h), here.slope, 1e-5 * jerk_scale()) << "x " << x;
    if (!near_joint(x, 2.0 * h)) {
      ASSERT_NEAR((after.slope - before.slope) / (2.0 * h), here.curvature, 1e-4 * jerk_scale())
          << "x " << x;
    }
  }
}

TEST_P(ShapeLaws, HaveThePeaksTheyClaim) {
  double slope = 0.0;
  double curvature = 0.0;
  for (int i = 0; i <= 60000; ++i) {
    const ShapeValue here = value(i / 60000.0);
    slope = std::max(slope, here.slope);
    curvature = std::max(curvature, std::abs(here.curvature));
  }
  EXPECT_LE(slope, peak_acceleration() * (1.0 + 1e-13));
  EXPECT_GE(slope, peak_acceleration() * (1.0 - 1e-6));
  if (std::isfinite(peak_jerk())) {
    EXPECT_LE(curvature, peak_jerk() * (1.0 + 1e-12));
    EXPECT_GE(curvature, peak_jerk() * (1.0 - GetParam().peak_tolerance));
  }
}

// phi by its series t/T - (1 - r) / (2 pi r) * sum of r^k sin(2 pi k x) / k, and the same
// integrated term by term: independent of the dilogarithm.
TEST(SineSeriesShape, AgreesWithItsSeries) {
  using std::numbers::pi;
  for (const double r : {1e-9, 1e-3, 0.123, 0.4, 0.49, 0.51, 0.6, 0.9, 0.99}) {
    const SineSeries shape{r};
    for (int i = 1; i < 100; ++i) {
      const double x = i / 100.0;
      double sines = 0.0;
      double cosines = 0.0;
      double power = 1.0;  // r^(k - 1)
      for (int k = 1; k < 6000 && power > 1e-20; ++k) {
        sines += power * std::sin(2.0 * pi * k * x) / k;
        cosines += power * (1.0 - std::cos(2.0 * pi * k * x)) / k / k;
        power *= r;
      }
      const double weight = (1.0 - r) / (2.0 * pi);
      ASSERT_NEAR(shape.at(x).phi, x - weight * sines, 1e-14) << "r " << r << " x " << x;
      ASSERT_NEAR(shape.at(x).integral, 0.5 * x * x - weight / (2.0 * pi) * cosines, 1e-15)
          << "r " << r << " x " << x;
    }
  }
}

// As r tends to 1 the series tends to the trapezoid, at a distance of the order of 1 - r.
TEST(SineSeriesShape, TendsToTheTrapezoid) {
  for (const double gap : {1e-4, 1e-6, 1e-9}) {
    const SineSeries shape{1.0 - gap};
    for (int i = 0; i <= 100; ++i) {
      const double x = i / 100.0;
      ASSERT_NEAR(shape.at(x).phi, x, gap);
      ASSERT_NEAR(shape.at(x).integral, 0.5 * x * x, gap);
    }
  }
}

TEST(SigmoidShape, IsClampedToWhereTheFeedrateDoesNotDip) {
  EXPECT_EQ(Sigmoid{9.0}.shape(), Sigmoid::kLargestShape);
  EXPECT_EQ(Sigmoid{-1.0}.shape(), Sigmoid::kSmallestShape);
}

}  // namespace
}  // namespace kerf::profiles::test
