#include "curves/nurbs_curve.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "curves/arc.hpp"
#include "curves/arc_length.hpp"
#include "tests/curves/distance.hpp"
#include "tests/curves/reference_nurbs.hpp"
#include "tests/curves/shipped_curves.hpp"

namespace kerf::curves {
namespace {

using testing::shipped_curve;
using testing::uniform_knots;

NurbsData polynomial(int degree, const std::vector<Position>& points) {
  NurbsData data{.degree = degree, .points = {}, .knots = uniform_knots(degree, points.size())};
  for (const Position& p : points)
    data.points.push_back({p, 1.0});
  return data;
}

NurbsCurve smooth(const NurbsData& data) {
  auto made = NurbsCurve::make(data);
  EXPECT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->size(), 1U);
  return made->front();
}

TEST(NurbsCurve, DrawsTheFullCircleExactly) {
  const NurbsCurve curve = smooth(shipped_curve("circle"));
  const Arc arc = Arc::make({.start_mm = {1.0, 0.0, 0.0}, .end_mm = {1.0, 0.0, 0.0}}).value();
  EXPECT_NEAR(curve.length_mm(), 2.0 * std::numbers::pi, 1e-14);
  for (int i = 0; i <= 500; ++i) {
    const double s_mm = curve.length_mm() * i / 500.0;
    const PathDerivatives a = curve.derivatives_at(s_mm);
    const PathDerivatives b = arc.derivatives_at(s_mm);
    EXPECT_LT(distance_mm(a.position_mm, b.position_mm), 1e-12);
    EXPECT_LT(distance_mm(a.first, b.first), 1e-12);
    EXPECT_LT(distance_mm(a.second_per_mm, b.second_per_mm), 1e-11);
    EXPECT_LT(distance_mm(a.third_per_mm2, b.third_per_mm2), 1e-10);
  }
  const Extents box = curve.extents();
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_NEAR(box.min_mm[k], -1.0, 1e-9);
    EXPECT_NEAR(box.max_mm[k], 1.0, 1e-9);
  }
}

TEST(NurbsCurve, IsAStraightLineWhereDegreeOneSaysSo) {
  const NurbsCurve curve = smooth(polynomial(1, {{0.0, 0.0, 0.0}, {300.0, 400.0, 1200.0}}));
  EXPECT_NEAR(curve.length_mm(), 1300.0, 1e-12);
  EXPECT_EQ(curve.pieces().size(), 1U);
  EXPECT_LT(distance_mm(curve.at(650.0), {150.0, 200.0, 600.0}), 1e-12);
  EXPECT_LT(vec(curve.derivatives_at(1.0).second_per_mm).norm(), 1e-15);
}

TEST(NurbsCurve, EndsExactlyWhereTheProgramSays) {
  for (const auto& [name, data] : testing::shipped_curves()) {
    const auto made = NurbsCurve::make(data);
    ASSERT_TRUE(made) << name;
    const NurbsCurve& last = made->back();
    EXPECT_EQ(last.at(last.length_mm()), data.points.back().position_mm) << name;
    EXPECT_EQ(last.at(1e6), data.points.back().position_mm) << name;
    EXPECT_EQ(last.derivatives_at(1e6).position_mm, data.points.back().position_mm) << name;
    EXPECT_LT(distance_mm(made->front().at(0.0), data.points.front().position_mm), 2e-14) << name;
    EXPECT_EQ(made->front().at(-5.0), made->front().at(0.0)) << name;
  }
}

TEST(NurbsCurve, IsCutWhereItsTangentTurnsAtAKnot) {
  // Two parabolas that meet at a right angle in a knot of multiplicity 2.
  NurbsData data = polynomial(
      2, {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {3.0, 1.0, 0.0}, {3.0, 4.0, 0.0}, {5.0, 5.0, 0.0}});
  data.knots = {0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0};
  const auto made = NurbsCurve::make(data);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->size(), 2U);
  const NurbsCurve& before = made->front();
  const NurbsCurve& after = made->back();
  EXPECT_EQ(before.at(before.length_mm()), (Position{3.0, 1.0, 0.0}));
  EXPECT_LT(distance_mm(after.at(0.0), {3.0, 1.0, 0.0}), 1e-15);
  EXPECT_LT(distance_mm(before.derivatives_at(before.length_mm()).first, {1.0, 0.0, 0.0}), 1e-14);
  EXPECT_LT(distance_mm(after.derivatives_at(0.0).first, {0.0, 1.0, 0.0}), 1e-14);
  const auto total = testing::reference_length_mm(data, 0.0L, 2.0L);
  EXPECT_NEAR(before.length_mm() + after.length_mm(), static_cast<double>(total), 1e-11);
}

TEST(NurbsCurve, StaysWholeAtARepeatedKnotWithoutACorner) {
  EXPECT_EQ(NurbsCurve::make(shipped_curve("circle"))->size(), 1U);
  // The tangents agree, their lengths do not: still one smooth path.
  NurbsData data = polynomial(
      2, {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {3.0, 1.0, 0.0}, {9.0, 1.0, 0.0}, {10.0, 0.0, 0.0}});
  data.knots = {0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0};
  EXPECT_EQ(NurbsCurve::make(data)->size(), 1U);
}

TEST(NurbsCurve, IsCutWhereRepeatedControlPointsMakeACorner) {
  // Three equal control points of a cubic: straight in, straight out.
  const NurbsData data = polynomial(3, {{0.0, 0.0, 0.0},
                                        {2.0, 0.0, 0.0},
                                        {6.0, 0.0, 0.0},
                                        {6.0, 0.0, 0.0},
                                        {6.0, 0.0, 0.0},
                                        {6.0, 3.0, 0.0},
                                        {6.0, 8.0, 0.0}});
  const auto made = NurbsCurve::make(data);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->size(), 2U);
  EXPECT_NEAR(made->front().length_mm(), 6.0, 1e-11);
  EXPECT_NEAR(made->back().length_mm(), 8.0, 1e-11);
  EXPECT_EQ(made->front().at(6.1), (Position{6.0, 0.0, 0.0}));
}

TEST(NurbsCurve, IsCutWhereAWeightPullsItIntoACorner) {
  // A hyperbola that hugs its control polygon to within 1e-14 mm at the middle point.
  NurbsData data = polynomial(2, {{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 4.0, 0.0}});
  data.points[1].weight = 1e14;
  const auto made = NurbsCurve::make(data);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->size(), 2U);
  EXPECT_NEAR(made->front().length_mm(), 3.0, 1e-11);
  EXPECT_NEAR(made->back().length_mm(), 4.0, 1e-11);
  EXPECT_LT(distance_mm(made->front().at(3.1), {3.0, 0.0, 0.0}), 1e-11);
  EXPECT_LT(distance_mm(made->back().at(0.0), {3.0, 0.0, 0.0}), 1e-11);
  // A smaller weight leaves a turn that can be driven, of a radius about 5 / weight^2.
  data.points[1].weight = 1e3;
  EXPECT_EQ(NurbsCurve::make(data)->size(), 1U);
}

TEST(NurbsCurve, SkipsSegmentsWithoutLength) {
  // Four equal control points: a whole span of a cubic stands still.
  const NurbsData data = polynomial(3, {{0.0, 0.0, 0.0},
                                        {2.0, 0.0, 0.0},
                                        {6.0, 0.0, 0.0},
                                        {6.0, 0.0, 0.0},
                                        {6.0, 0.0, 0.0},
                                        {6.0, 0.0, 0.0},
                                        {8.0, 0.0, 0.0},
                                        {9.0, 0.0, 0.0}});
  const auto made = NurbsCurve::make(data);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->size(), 1U);  // straight on: no corner
  EXPECT_NEAR(made->front().length_mm(), 9.0, 1e-11);
  EXPECT_LT(distance_mm(made->front().at(7.0), {7.0, 0.0, 0.0}), 1e-10);
}

TEST(NurbsCurve, LeavesAndReachesCoincidentEndPoints) {
  // |C'(u)| is zero at both ends; arc length and direction are not at a loss.
  for (const int same : {2, 3, 4}) {
    std::vector<Position> points(static_cast<std::size_t>(same), {1.0, 2.0, 3.0});
    points.push_back({5.0, 3.0, 3.0});
    points.push_back({7.0, 8.0, 9.0});
    points.insert(points.end(), static_cast<std::size_t>(same), {9.0, 1.0, 1.0});
    const NurbsData data = polynomial(5, points);
    const NurbsCurve curve = smooth(data);
    const auto length =
        testing::reference_length_mm(data, 0.0L, static_cast<long double>(data.knots.back()));
    EXPECT_NEAR(curve.length_mm(), static_cast<double>(length), 1e-11);
    EXPECT_LT(curve.pieces().size(), 300U);
    const Eigen::Vector3d way =
        (vec(points[static_cast<std::size_t>(same)]) - vec(points[0])).normalized();
    EXPECT_LT((vec(curve.derivatives_at(0.0).first) - way).norm(), 1e-3);
    for (int i = 0; i <= 100; ++i) {
      const PathDerivatives d = curve.derivatives_at(curve.length_mm() * i / 100.0);
      EXPECT_NEAR(vec(d.first).norm(), 1.0, 1e-14);
      EXPECT_TRUE(vec(d.second_per_mm).allFinite());
      EXPECT_TRUE(vec(d.third_per_mm2).allFinite());
    }
  }
}

TEST(NurbsCurve, PassesAPointWhereTheParametrisationStandsStill) {
  // x = t^3 + t^5, y = t^5 / 2 + t^6 at t = 2 u - 0.7: straight on, but C'(u) = 0 at u = 0.35.
  NurbsData data{.degree = 6, .points = {}, .knots = uniform_knots(6, 7)};
  const auto symmetric = [](int wanted, const std::array<double, 6>& t) {
    double sum = 0.0;  // mean of the products of `wanted` of the six arguments
    int count = 0;
    for (unsigned set = 0; set < 64U; ++set) {
      if (__builtin_popcount(set) != wanted)
        continue;
      double product = 1.0;
      for (std::size_t i = 0; i < 6; ++i)
        product *= (set >> i & 1U) != 0U ? t[i] : 1.0;
      sum += product;
      ++count;
    }
    return sum / count;
  };
  for (std::size_t ones = 0; ones <= 6; ++ones) {
    std::array<double, 6> t{};
    for (std::size_t i = 0; i < 6; ++i)
      t[i] = i < ones ? 1.3 : -0.7;
    data.points.push_back(
        {{symmetric(3, t) + symmetric(5, t), 0.5 * symmetric(5, t) + symmetric(6, t), 0.0}, 1.0});
  }
  const NurbsCurve curve = smooth(data);
  const auto length = testing::reference_length_mm(data, 0.0L, 0.35L) +
                      testing::reference_length_mm(data, 0.35L, 1.0L);
  EXPECT_NEAR(curve.length_mm(), static_cast<double>(length), 1e-10);
  EXPECT_LT(curve.pieces().size(), 200U);
}

TEST(NurbsCurve, KeepsTimeAndPiecesBoundedOnAThousandPoints) {
  std::mt19937_64 random(7);
  const NurbsData data =
      testing::random_nurbs(random, {.degree = 3, .points = 1000, .weight_decades = 3.0});
  const NurbsCurve curve = smooth(data);
  EXPECT_LT(curve.pieces().size(), 150U * 1000U);
  const auto length =
      testing::reference_length_mm(data, 0.0L, static_cast<long double>(data.knots.back()));
  EXPECT_NEAR(curve.length_mm(), static_cast<double>(length), 1e-12 * curve.length_mm());
}

TEST(NurbsCurve, IsMovedWithItsControlPoints) {
  // Affine invariance: far from the zero the shape is the same to the digits left there.
  NurbsData data = shipped_curve("butterfly");
  const NurbsCurve here = smooth(data);
  for (ControlPoint& point : data.points)
    point.position_mm[0] += 4096.0;
  const NurbsCurve there = smooth(data);
  EXPECT_NEAR(here.length_mm(), there.length_mm(), 1e-10);
  for (int i = 0; i <= 200; ++i) {
    const double s_mm = here.length_mm() * i / 200.0;
    Position moved = here.at(s_mm);
    moved[0] += 4096.0;
    EXPECT_LT(distance_mm(moved, there.at(s_mm)), 2e-11);
  }
}

TEST(NurbsCurve, DoesNotDependOnTheScaleOfWeightsAndKnots) {
  NurbsData data = shipped_curve("butterfly");
  const NurbsCurve plain = smooth(data);
  for (ControlPoint& point : data.points)
    point.weight *= 1e-6;
  for (double& knot : data.knots)
    knot = 1e5 * knot - 3e4;
  const NurbsCurve scaled = smooth(data);
  EXPECT_NEAR(plain.length_mm(), scaled.length_mm(), 1e-10);
  for (int i = 0; i <= 200; ++i) {
    const double s_mm = plain.length_mm() * i / 200.0;
    EXPECT_LT(distance_mm(plain.at(s_mm), scaled.at(s_mm)), 1e-10);
  }
}

TEST(NurbsCurve, FindsThePieceOfAnArcLength) {
  const NurbsCurve curve = smooth(shipped_curve("mazatrol"));
  EXPECT_EQ(curve.piece_index(-1.0), 0U);
  EXPECT_EQ(curve.piece_index(1e9), curve.pieces().size() - 1);
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    const NurbsPiece& piece = curve.pieces()[i];
    EXPECT_EQ(curve.piece_index(0.5 * (piece.s_begin_mm + piece.s_end_mm)), i);
    EXPECT_EQ(curve.piece_index(piece.s_begin_mm), i);
    if (i == 0)
      continue;
    EXPECT_EQ(piece.s_begin_mm, curve.pieces()[i - 1].s_end_mm);
  }
}

}  // namespace
}  // namespace kerf::curves
