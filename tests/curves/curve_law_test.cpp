// What holds for every curve, whatever its kind.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "curves/curve.hpp"
#include "curves/curve_builders.hpp"
#include "tests/curves/reference_nurbs.hpp"
#include "tests/curves/shipped_curves.hpp"

namespace kerf::curves {
namespace {

struct Case {
  std::string name;
  Curve curve;
};

Curve random_curve(const testing::RandomNurbsOptions& options, unsigned seed) {
  std::mt19937_64 random(seed);
  return NurbsCurve::make(testing::random_nurbs(random, options)).value().front();
}

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"line", Line::between({1.0, 2.0, 3.0}, {-4.0, 7.5, 3.25}).value()});
  all.push_back({"short_line", Line::between({100.0, 2.0, 3.0}, {100.0, 2.0, 3.0 + 1e-6}).value()});
  for (const int axis : {0, 1, 2}) {
    for (const bool clockwise : {false, true}) {
      ArcShape shape{.centre_mm = {1.0, -2.0, 0.5},
                     .normal_axis = axis,
                     .clockwise = clockwise,
                     .turns = 1 + axis};
      shape.start_mm = shape.centre_mm;
      shape.end_mm = shape.centre_mm;
      shape.start_mm[static_cast<std::size_t>((axis + 1) % 3)] += 7.0;
      shape.end_mm[static_cast<std::size_t>((axis + 2) % 3)] += 7.0;
      const std::string name = "about_" + std::to_string(axis) + (clockwise ? "_cw" : "_ccw");
      all.push_back({"arc_" + name, Arc::make(shape).value()});
      shape.end_mm[static_cast<std::size_t>(axis)] += 3.0;
      all.push_back({"helix_" + name, Arc::make(shape).value()});
    }
  }
  const auto spiral = make_arc({.start_mm = {10.0, 0.0, 0.0}, .end_mm = {10.1, 0.0, 2.0}}).value();
  all.push_back({"spiral", std::get<NurbsCurve>(spiral)});
  for (const auto& [name, data] : testing::shipped_curves()) {
    all.push_back({name, NurbsCurve::make(data).value().front()});
  }
  for (int degree = 2; degree <= kMaxDegree; ++degree) {
    const std::string suffix = "_degree_" + std::to_string(degree);
    const auto seed = static_cast<unsigned>(degree);
    all.push_back(
        {"polynomial" + suffix, random_curve({.degree = degree, .points = degree + 5}, seed)});
    all.push_back({"rational" + suffix,
                   random_curve({.degree = degree, .points = degree + 5, .weight_decades = 1.0},
                                seed + 100)});
  }
  return all;
}

class CurveLaws : public ::testing::TestWithParam<Case> {
 protected:
  const Curve& curve() const { return GetParam().curve; }
  Eigen::Vector3d point(double s_mm) const { return vec(position_at(curve(), s_mm)); }

  std::vector<Piece> pieces() const {
    std::vector<Piece> all;
    for_each_piece(curve(), [&](const Piece& piece) { all.push_back(piece); });
    return all;
  }
};

TEST_P(CurveLaws, PiecesCoverTheCurveWithoutAGap) {
  const std::vector<Piece> all = pieces();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(s_begin_mm(all.front()), 0.0);
  EXPECT_EQ(s_end_mm(all.back()), length_mm(curve()));
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double s_mm = s_begin_mm(all[i]);
    EXPECT_EQ(s_end_mm(all[i - 1]), s_mm);
    const PathDerivatives before = derivatives_at(all[i - 1], s_mm);
    const PathDerivatives after = derivatives_at(all[i], s_mm);
    EXPECT_LT((vec(before.position_mm) - vec(after.position_mm)).norm(), 1e-13);
    EXPECT_LT((vec(before.first) - vec(after.first)).norm(), 1e-10);
  }
}

TEST_P(CurveLaws, PiecesAndCurveAgree) {
  for (const Piece& piece : pieces()) {
    const double s_mm = 0.3 * s_begin_mm(piece) + 0.7 * s_end_mm(piece);
    EXPECT_EQ(position_at(piece, s_mm), position_at(curve(), s_mm));
    const PathDerivatives a = derivatives_at(piece, s_mm);
    const PathDerivatives b = derivatives_at(curve(), s_mm);
    EXPECT_EQ(a.third_per_mm2, b.third_per_mm2);
    EXPECT_LT((vec(a.position_mm) - point(s_mm)).norm(), 1e-13);
  }
}

TEST_P(CurveLaws, OutsideIsClampedToTheEnds) {
  const double length = length_mm(curve());
  EXPECT_EQ(position_at(curve(), -1.0), position_at(curve(), 0.0));
  EXPECT_EQ(position_at(curve(), length + 1.0), position_at(curve(), length));
  EXPECT_EQ(derivatives_at(curve(), -1.0).first, derivatives_at(curve(), 0.0).first);
  EXPECT_EQ(derivatives_at(curve(), length + 1.0).first, derivatives_at(curve(), length).first);
  EXPECT_EQ(derivatives_at(curve(), length).position_mm, position_at(curve(), length));
}

TEST_P(CurveLaws, TangentsAreUnitAndCurvatureAcross) {
  for (int i = 0; i <= 1000; ++i) {
    const PathDerivatives d = derivatives_at(curve(), length_mm(curve()) * i / 1000.0);
    const double curvature = vec(d.second_per_mm).norm();
    EXPECT_NEAR(vec(d.first).norm(), 1.0, 1e-13);
    EXPECT_NEAR(vec(d.first).dot(vec(d.second_per_mm)), 0.0, 1e-12 * (1.0 + curvature));
    // Once more differentiated: t . t'' = -|t'|^2.
    EXPECT_NEAR(vec(d.first).dot(vec(d.third_per_mm2)), -curvature * curvature,
                1e-11 * (1.0 + vec(d.third_per_mm2).norm()));
  }
}

TEST_P(CurveLaws, DerivativesAreThoseOfFiniteDifferences) {
  // Five-point differences within a piece: its length is the scale on which the curve changes.
  for (const Piece& piece : pieces()) {
    const double length = s_end_mm(piece) - s_begin_mm(piece);
    if (length < 1e-6)
      continue;
    const double h = 0.002 * length;
    for (const double share : {0.2, 0.5, 0.8}) {
      const double s_mm = s_begin_mm(piece) + share * length;
      const auto difference = [&](auto&& part) {
        const auto at = [&](double steps) -> Eigen::Vector3d { return part(s_mm + steps * h); };
        return Eigen::Vector3d((at(-2.0) - 8.0 * at(-1.0) + 8.0 * at(1.0) - at(2.0)) / (12.0 * h));
      };
      const PathDerivatives d = derivatives_at(piece, s_mm);
      const auto position = [&](double s) { return Eigen::Vector3d(vec(position_at(piece, s))); };
      const auto first = [&](double s) {
        return Eigen::Vector3d(vec(derivatives_at(piece, s).first));
      };
      const auto second = [&](double s) {
        return Eigen::Vector3d(vec(derivatives_at(piece, s).second_per_mm));
      };
      const double rounding = 1e-13 * (1.0 + point(s_mm).norm() / 100.0) / h;
      EXPECT_LT((difference(position) - vec(d.first)).norm(), 1e-7 + rounding);
      EXPECT_LT((difference(first) - vec(d.second_per_mm)).norm(),
                1e-6 * (vec(d.second_per_mm).norm() + 1.0 / length));
      EXPECT_LT((difference(second) - vec(d.third_per_mm2)).norm(),
                1e-6 * (vec(d.third_per_mm2).norm() + 1.0 / (length * length)));
    }
  }
}

TEST_P(CurveLaws, ArcLengthIsTheLengthOfThePath) {
  // Chords are shorter by kappa^2 h^3 / 24; Richardson's extrapolation takes that away.
  const double length = length_mm(curve());
  const auto chords_mm = [&](int count) {
    double sum_mm = 0.0;
    for (int i = 0; i < count; ++i) {
      sum_mm += (point(length * (i + 1) / count) - point(length * i / count)).norm();
    }
    return sum_mm;
  };
  const double coarse_mm = chords_mm(20000);
  const double fine_mm = chords_mm(40000);
  EXPECT_LE(fine_mm, length * (1.0 + 1e-9));
  EXPECT_NEAR((4.0 * fine_mm - coarse_mm) / 3.0, length, 1e-5 * length);
}

TEST_P(CurveLaws, ExtentsHoldThePathAndAreTouchedByIt) {
  const Extents box = extents(curve());
  const double length = length_mm(curve());
  constexpr int kSamples = 20000;
  for (Eigen::Index k = 0; k < 3; ++k) {
    for (const double side : {1.0, -1.0}) {
      const auto height = [&](double s_mm) { return side * point(s_mm)[k]; };
      double best_s_mm = 0.0;
      for (int i = 0; i <= kSamples; ++i) {
        const double s_mm = length * i / kSamples;
        if (height(s_mm) > height(best_s_mm))
          best_s_mm = s_mm;
      }
      double low_mm = std::max(0.0, best_s_mm - length / kSamples);
      double high_mm = std::min(length, best_s_mm + length / kSamples);
      for (int i = 0; i < 100; ++i) {  // ternary search for the summit
        const double third_mm = (high_mm - low_mm) / 3.0;
        if (height(low_mm + third_mm) < height(high_mm - third_mm)) {
          low_mm += third_mm;
        } else {
          high_mm -= third_mm;
        }
      }
      const double summit_mm = std::max(height(best_s_mm), height(low_mm));
      const auto axis = static_cast<std::size_t>(k);
      const double face_mm = side > 0.0 ? box.max_mm[axis] : -box.min_mm[axis];
      EXPECT_NEAR(face_mm, summit_mm, 1e-9) << "axis " << k << ", side " << side;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CurveLaws, ::testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace kerf::curves
