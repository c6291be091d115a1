// The parts of the search for the time optimum, each against what it must be.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "lookahead/optimum/solver/band_system.hpp"
#include "lookahead/optimum/solver/barrier.hpp"
#include "lookahead/optimum/solver/barrier_objective.hpp"
#include "lookahead/optimum/solver/feed_spline.hpp"
#include "lookahead/optimum/solver/optimal_feed.hpp"

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

struct BarrierValue {
  double value = 0.0;
  double rise = 0.0;
  double bend = 0.0;
};

// In either lane, which must not know of the other.
BarrierValue barrier_below(const Barrier& barrier, double form, int lane) {
  SimdPair forms(0.3, 0.3);
  forms[lane] = form;
  Barrier::Sum sum;
  const Barrier::Slopes slopes = barrier.below(forms, sum);
  return {.value = sum.value()[lane], .rise = slopes.rise[lane], .bend = slopes.bend[lane]};
}

BarrierValue barrier_within(const Barrier& barrier, double form, int lane) {
  SimdPair forms(0.3, 0.3);
  forms[lane] = form;
  Barrier::Sum sum;
  const Barrier::Slopes slopes = barrier.within(forms, sum);
  return {.value = sum.value()[lane], .rise = slopes.rise[lane], .bend = slopes.bend[lane]};
}

TEST(FeedSpline, StaysAsItIsWhereACellIsHalved) {
  std::mt19937_64 random(3);
  std::vector<double> lengths;
  std::vector<double> coefficients{uniform(random, 0.5, 2.0), uniform(random, 0.5, 2.0)};
  for (int i = 0; i < 7; ++i) {
    lengths.push_back(std::exp(uniform(random, -3.0, 2.0)));
    coefficients.push_back(uniform(random, 0.5, 2.0));
  }
  const std::vector<CellBasis> whole = feed_basis(lengths);
  std::vector<double> half_lengths;
  std::vector<double> half_coefficients{coefficients.front()};
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    half_lengths.insert(half_lengths.end(), 2, 0.5 * lengths[i]);
    for (const double c : coefficients_of_halves(whole[i].begin.at(&coefficients[i]), lengths[i])) {
      half_coefficients.push_back(c);
    }
  }
  half_coefficients.push_back(coefficients.back());
  const std::vector<CellBasis> halves = feed_basis(half_lengths);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const SquaredFeed before = whole[i].middle.at(&coefficients[i]);
    const SquaredFeed after = halves[2 * i].end.at(&half_coefficients[2 * i]);
    EXPECT_NEAR(after.value, before.value, 1e-12 * before.value) << i;
    EXPECT_NEAR(after.slope, before.slope, 1e-10 * (1.0 + std::abs(before.slope))) << i;
    EXPECT_NEAR(after.bend, before.bend, 1e-8 * (1.0 + std::abs(before.bend))) << i;
  }
}

TEST(Barrier, GoesOnSmoothlyWhereItIsRelaxed) {
  const Barrier barrier(0.01);
  for (const int lane : {0, 1}) {
    const auto at = [&](double slack) { return barrier_below(barrier, 1.0 - slack, lane); };
    EXPECT_DOUBLE_EQ(at(0.5).value, -std::log(0.5));
    EXPECT_NEAR(at(0.01 - 1e-12).value, at(0.01 + 1e-12).value, 1e-9);
    for (const double slack : {0.3, 0.011, 0.009, 0.0, -2.0}) {
      const double h = 1e-6;
      const double fall = (at(slack - h).value - at(slack + h).value) / (2.0 * h);
      EXPECT_NEAR(at(slack).rise, fall, 1e-5 * std::abs(fall));
      const double bend =
          (at(slack + h).value - 2.0 * at(slack).value + at(slack - h).value) / (h * h);
      EXPECT_NEAR(at(slack).bend, bend, 1e-2 * bend);
    }
  }
}

TEST(Barrier, OnBothSidesIsOneAboveAndOneBelow) {
  const Barrier barrier(0.01);
  for (const int lane : {0, 1}) {
    for (const double form : {-3.0, -0.995, -0.5, 0.0, 0.7, 0.992, 1.2}) {
      const BarrierValue above = barrier_below(barrier, form, lane);
      const BarrierValue under = barrier_below(barrier, -form, lane);
      const BarrierValue both = barrier_within(barrier, form, lane);
      EXPECT_NEAR(both.value, above.value + under.value, 1e-12 * (1.0 + std::abs(both.value)));
      EXPECT_NEAR(both.rise, above.rise - under.rise, 1e-12 * (above.rise + under.rise));
      EXPECT_NEAR(both.bend, above.bend + under.bend, 1e-12 * both.bend);
    }
  }
}

CellSequence random_sequence(std::mt19937_64& random, const StartState& begin, int cells) {
  CellSequence sequence{.begin = begin, .cells = {}};
  for (int i = 0; i < cells; ++i) {
    Cell cell{.length_mm = uniform(random, 0.05, 0.2),
              .along = {.acceleration_mm_s2 = 900.0, .jerk_mm_s3 = 2e4}};
    for (PathSample* end : {&cell.begin, &cell.end}) {
      end->feedrate_mm_s = 50.0;
      for (std::size_t k = 0; k < 3; ++k) {
        end->first[k] = uniform(random, -0.7, 0.7);
        end->second_per_mm[k] = uniform(random, -0.3, 0.3);
        end->third_per_mm2[k] = uniform(random, -0.2, 0.2);
      }
    }
    sequence.cells.push_back(cell);
  }
  return sequence;
}

TEST(BarrierObjective, ItsGradientIsThatOfItsValue) {
  PlanLimits limits;
  limits.axes.fill({.velocity_mm_s = 60.0, .acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e4});
  std::mt19937_64 random(3);
  const StartState in_motion{.v_mm_s = 12.0, .a_mm_s2 = 30.0};
  for (const StartState& begin : {StartState{}, in_motion}) {
    for (const int cells : {8, 9}) {
      const CellSequence sequence = random_sequence(random, begin, cells);
      const BarrierObjective objective(sequence, limits);
      const BarrierWeights weights{.weight_s = 0.01, .relaxed = 0.2};
      const auto value = [&](std::vector<double> at) {
        objective.bind(at);
        return objective.value(at, weights).objective_s;
      };
      std::vector<double> c(objective.size());
      for (double& coefficient : c) {
        coefficient = uniform(random, 80.0, 400.0);
      }
      objective.bind(c);
      BandSystem system;
      const BarrierObjective::Value derived = objective.derive(c, weights, system);
      EXPECT_EQ(derived.objective_s, objective.value(c, weights).objective_s);
      EXPECT_EQ(derived.time_s, objective.value(c, weights).time_s);
      const std::vector<double> gradient = system.gradient;
      const auto [first, end] = objective.free_rows();
      for (std::size_t i = first; i < end; ++i) {
        const double h = 1e-5 * c[i];
        std::vector<double> up = c;
        std::vector<double> down = c;
        up[i] += h;
        down[i] -= h;
        const double slope = (value(up) - value(down)) / (2.0 * h);
        EXPECT_NEAR(gradient[i], slope, 1e-6 * (1.0 + std::abs(slope))) << i << " of " << cells;
      }
    }
  }
}

// What does not depend on the range is the same: the slopes by the coefficients that are free in
// it.
TEST(BarrierObjective, OfARangeHasTheSlopesOfTheWhole) {
  PlanLimits limits;
  limits.axes.fill({.velocity_mm_s = 60.0, .acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e4});
  std::mt19937_64 random(4);
  for (const StartState& begin : {StartState{}, StartState{.v_mm_s = 12.0, .a_mm_s2 = 30.0}}) {
    const CellSequence sequence = random_sequence(random, begin, 16);
    const std::size_t count = sequence.spline_cells();
    const BarrierObjective whole(sequence, limits);
    const BarrierWeights weights{.weight_s = 0.01, .relaxed = 0.2};
    std::vector<double> c(whole.size());
    for (double& coefficient : c) {
      coefficient = uniform(random, 80.0, 400.0);
    }
    whole.bind(c);
    BandSystem of_whole;
    ASSERT_LT(whole.derive(c, weights, of_whole).objective_s, kUnbounded);
    for (const SplineRange& range :
         {SplineRange{0, 7}, SplineRange{3, 10}, SplineRange{6, count}, SplineRange{0, count}}) {
      const BarrierObjective part(sequence, limits, range);
      ASSERT_EQ(part.size(), range.size() + 2);
      const auto from = c.begin() + static_cast<std::ptrdiff_t>(range.begin);
      std::vector<double> own(from, from + static_cast<std::ptrdiff_t>(part.size()));
      const std::vector<double> given = own;
      part.bind(own);
      EXPECT_EQ(own, given);
      BandSystem of_part;
      ASSERT_LT(part.derive(own, weights, of_part).objective_s, kUnbounded);
      const auto [first, end] = part.free_rows();
      EXPECT_GE(end, first + 3);
      for (std::size_t i = first; i < end; ++i) {
        const double slope = of_whole.gradient[range.begin + i];
        EXPECT_NEAR(of_part.gradient[i], slope, 1e-12 * (1.0 + std::abs(slope))) << i;
      }
      std::vector<double> change(part.size(), 1.0);
      part.bind_change(change);
      if (range.begin > 0) {
        EXPECT_EQ(std::max(std::abs(change[0]), std::abs(change[1])), 0.0);
      }
      if (range.end < count) {
        EXPECT_EQ(std::max(std::abs(change[end]), std::abs(change[end + 1])), 0.0);
      }
    }
  }
}

// On a straight line along x every limit is one of the motion along the path: of the path's and x'
// own the tighter one counts, and the objective of a cruise can be written down.
TEST(BarrierObjective, OfACruiseIsItsTimeAndTheBarriersOfTheTightestLimits) {
  PlanLimits limits;
  limits.axes.fill({.velocity_mm_s = 60.0, .acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e4});
  CellSequence sequence{.begin = {.v_mm_s = 20.0}, .cells = {}};
  for (int i = 0; i < 4; ++i) {
    Cell cell{.length_mm = 2.0, .along = {.acceleration_mm_s2 = 900.0, .jerk_mm_s3 = 2e4}};
    for (PathSample* end : {&cell.begin, &cell.end}) {
      end->first = {1.0, 0.0, 0.0};
      end->feedrate_mm_s = 50.0;
    }
    sequence.cells.push_back(cell);
  }
  const BarrierObjective objective(sequence, limits);
  BandSystem system;
  const std::vector<double> cruise(objective.size(), 400.0);
  const BarrierObjective::Value free =
      objective.derive(cruise, {.weight_s = 0.0, .relaxed = 1e-3}, system);
  // Three cells of 2 mm at 20 mm/s, and a landing, which takes three times as long.
  EXPECT_NEAR(free.time_s, 0.3 + 0.3, 1e-12);
  EXPECT_DOUBLE_EQ(free.objective_s, free.time_s);
  const BarrierObjective::Value bounded =
      objective.derive(cruise, {.weight_s = 1.0, .relaxed = 1e-3}, system);
  const double cap = std::pow(kAim * 50.0, 2.0);
  const double landing = 0.25 * std::pow(1e4 * kAim * 12.0 * 12.0, 2.0 / 3.0);
  EXPECT_NEAR(bounded.objective_s - bounded.time_s,
              -3.0 * std::log1p(-400.0 / cap) - std::log1p(-400.0 / std::min(cap, landing)), 1e-9);
}

// The feedrate beyond the range is the boundary of what is searched in it.
TEST(OptimalFeed, IsRefinedOnARangeAlone) {
  PlanLimits limits;
  limits.axes.fill({.velocity_mm_s = 60.0, .acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e4});
  CellSequence sequence{.begin = {.v_mm_s = 20.0}, .cells = {}};
  for (int i = 0; i < 60; ++i) {
    Cell cell{.length_mm = 0.5, .along = {.acceleration_mm_s2 = 900.0, .jerk_mm_s3 = 2e4}};
    for (PathSample* end : {&cell.begin, &cell.end}) {
      end->first = {1.0, 0.0, 0.0};
      end->feedrate_mm_s = 50.0;
    }
    sequence.cells.push_back(cell);
  }
  OptimalFeed feed = find_optimal_feed(sequence, limits);
  const std::vector<double> before = feed.coefficients;
  constexpr std::size_t kSlower = 25;
  sequence.cells[kSlower].shares.feedrate *= 0.99;
  constexpr SplineRange kRange{10, 40};
  refine_optimal_feed(sequence, limits, kRange, feed);
  const double cap = std::pow(0.99 * kAim * 50.0, 2.0);
  EXPECT_GT(before[kSlower + 1], cap);
  EXPECT_LT(feed.coefficients[kSlower + 1], cap);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i < kRange.begin + 2 || i >= kRange.end) {
      EXPECT_EQ(feed.coefficients[i], before[i]) << i;
    }
  }
  // As over all cells, to what the last barrier leaves to gain.
  OptimalFeed over_all = find_optimal_feed(sequence, limits);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(feed.coefficients[i], over_all.coefficients[i], 2e-3 * before[i]) << i;
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
