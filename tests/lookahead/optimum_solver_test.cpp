// The parts of the search for the time optimum, each against what it must be.
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "lookahead/optimum/band_system.hpp"
#include "lookahead/optimum/barrier.hpp"
#include "lookahead/optimum/feed_spline.hpp"
#include "lookahead/optimum/merit.hpp"

namespace kerf::lookahead::test {
namespace {

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

TEST(BandSystem, SolvesWhatADenseSolverSolves) {
  std::mt19937_64 random(1);
  for (std::size_t n : {1U, 2U, 3U, 4U, 30U}) {
    BandSystem system;
    system.clear(n);
    const auto size = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd gradient(size);
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      system.diagonal[i] = dense(k, k) = uniform(random, 5.0, 9.0);
      system.gradient[i] = gradient[k] = uniform(random, -1.0, 1.0);
      if (i + 1 < n) {
        system.first[i] = dense(k, k + 1) = dense(k + 1, k) = uniform(random, -1.0, 1.0);
      }
      if (i + 2 < n) {
        system.second[i] = dense(k, k + 2) = dense(k + 2, k) = uniform(random, -1.0, 1.0);
      }
    }
    const Eigen::VectorXd expected = dense.ldlt().solve(-gradient);
    std::vector<double> x(n);
    ASSERT_TRUE(system.solve({.begin = 0, .end = n}, x));
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(x[i], expected[static_cast<Eigen::Index>(i)], 1e-13);
    }
  }
}

TEST(BandSystem, RefusesWhatIsNotPositiveDefinite) {
  BandSystem system;
  system.clear(2);
  system.diagonal = {1.0, 1.0};
  system.first = {2.0, 0.0};
  std::vector<double> x(2);
  EXPECT_FALSE(system.solve({.begin = 0, .end = 2}, x));
}

// With the coefficients t_left t_right of a knot's neighbours (Marsden's identity) the spline is
// s^2.
TEST(FeedSpline, HoldsEveryQuadratic) {
  std::mt19937_64 random(2);
  std::vector<double> lengths;
  std::vector<double> knots{0.0};
  for (int i = 0; i < 12; ++i) {
    lengths.push_back(std::exp(uniform(random, -8.0, 2.0)));
    knots.push_back(knots.back() + lengths.back());
  }
  const std::vector<CellBasis> basis = feed_basis(lengths);
  const std::size_t n = lengths.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> squares;
    std::vector<double> lines;
    for (std::size_t c = i; c < i + 3; ++c) {
      const double left = knots[c > 0 ? c - 1 : 0];
      const double right = knots[std::min(c, n)];
      squares.push_back(left * right);
      lines.push_back(0.5 * (left + right));
    }
    const double ends[] = {knots[i], knots[i + 1]};
    const Basis* const at[] = {&basis[i].begin, &basis[i].end};
    for (int e = 0; e < 2; ++e) {
      const double s = ends[e];
      EXPECT_NEAR(at[e]->at(squares.data()).value, s * s, 1e-11);
      EXPECT_NEAR(at[e]->at(squares.data()).slope, 2.0 * s, 1e-9);
      EXPECT_NEAR(at[e]->at(squares.data()).bend, 2.0, 1e-5);
      EXPECT_NEAR(at[e]->at(lines.data()).value, s, 1e-12);
      EXPECT_NEAR(at[e]->at(lines.data()).slope, 1.0, 1e-9);
    }
    const double middle = 0.5 * (knots[i] + knots[i + 1]);
    EXPECT_NEAR(basis[i].middle.at(squares.data()).value, middle * middle, 1e-11);
  }
}

TEST(Barrier, GoesOnSmoothlyWhereItIsRelaxed) {
  const Barrier barrier(0.01);
  const auto value = [&barrier](double slack) {
    Barrier::Sum sum;
    barrier.add(slack, sum);
    return sum.value();
  };
  EXPECT_DOUBLE_EQ(value(0.5), -std::log(0.5));
  EXPECT_NEAR(value(0.01 - 1e-12), value(0.01 + 1e-12), 1e-9);
  for (const double slack : {0.3, 0.011, 0.009, 0.0, -2.0}) {
    const double h = 1e-6;
    const double slope = (value(slack + h) - value(slack - h)) / (2.0 * h);
    EXPECT_NEAR(barrier.slopes(slack).fall, -slope, 1e-5 * std::abs(slope));
    const double bend = (value(slack + h) - 2.0 * value(slack) + value(slack - h)) / (h * h);
    EXPECT_NEAR(barrier.slopes(slack).bend, bend, 1e-2 * bend);
  }
}

Stretch random_stretch(std::mt19937_64& random, const StretchBegin& begin) {
  Stretch stretch{.begin = begin, .cells = {}};
  for (int i = 0; i < 9; ++i) {
    Cell cell{.length_mm = uniform(random, 0.05, 0.2),
              .along = {.acceleration_mm_s2 = 900.0, .jerk_mm_s3 = 2e4}};
    for (CellEnd* end : {&cell.begin, &cell.end}) {
      end->feedrate_mm_s = 50.0;
      for (std::size_t k = 0; k < 3; ++k) {
        end->first[k] = uniform(random, -0.7, 0.7);
        end->second_per_mm[k] = uniform(random, -0.3, 0.3);
        end->third_per_mm2[k] = uniform(random, -0.2, 0.2);
      }
    }
    stretch.cells.push_back(cell);
  }
  return stretch;
}

TEST(Merit, ItsGradientIsThatOfItsValue) {
  PlanLimits limits;
  limits.axes.fill({.velocity_mm_s = 60.0, .acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e4});
  std::mt19937_64 random(3);
  const StretchBegin in_motion{.v_mm_s = 12.0, .a_mm_s2 = 30.0};
  for (const StretchBegin& begin : {StretchBegin{}, in_motion}) {
    const Stretch stretch = random_stretch(random, begin);
    const Merit merit(stretch, limits);
    const Walls walls{.weight_s = 0.01, .relaxed = 0.2};
    std::vector<double> c(merit.size());
    for (double& value : c) {
      value = uniform(random, 80.0, 400.0);
    }
    merit.bind(c);
    BandSystem system;
    merit.derive(c, walls, system);
    const auto [first, end] = merit.free_rows();
    for (std::size_t i = first; i < end; ++i) {
      const double h = 1e-5 * c[i];
      std::vector<double> up = c;
      std::vector<double> down = c;
      up[i] += h;
      down[i] -= h;
      merit.bind(up);
      merit.bind(down);
      const double slope = (merit.value(up, walls) - merit.value(down, walls)) / (2.0 * h);
      EXPECT_NEAR(system.gradient[i], slope, 1e-6 * (1.0 + std::abs(slope))) << i;
    }
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
