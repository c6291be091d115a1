#include <vector>

#include <gtest/gtest.h>

#include "curves/curve.hpp"

namespace kerf::curves {
namespace {

std::vector<Curve> some_of_each() {
  const Position start{1.0, 2.0, 3.0};
  std::vector<Curve> curves{*Line::between(start, {4.0, -2.0, 5.0})};
  curves.emplace_back(*Arc::make({.start_mm = start,
                                  .end_mm = {-1.0, 2.0, 4.0},
                                  .centre_mm = {0.0, 2.0, 0.0},
                                  .normal_axis = 2,
                                  .clockwise = true}));
  NurbsData data{.degree = 3,
                 .points = {{.position_mm = {0.0, 0.0, 0.0}},
                            {.position_mm = {1.0, 2.0, 0.0}, .weight = 2.0},
                            {.position_mm = {3.0, 2.0, 1.0}},
                            {.position_mm = {4.0, -1.0, 2.0}, .weight = 0.5},
                            {.position_mm = {6.0, 0.0, 0.0}}},
                 .knots = {0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 2.0}};
  curves.emplace_back(NurbsCurve::make(data)->front());
  return curves;
}

TEST(CurvePart, RunsThroughThePointsOfTheWholeWithItsDerivatives) {
  for (const Curve& whole : some_of_each()) {
    const double length = length_mm(whole);
    for (const Stretch& stretch :
         {Stretch{0.0, length}, Stretch{0.0, 0.3 * length}, Stretch{0.2 * length, 0.7 * length},
          Stretch{0.999 * length, length}}) {
      const auto cut = part(whole, stretch);
      ASSERT_TRUE(cut.has_value());
      EXPECT_NEAR(length_mm(*cut), stretch.end_mm - stretch.begin_mm, 1e-10);
      for (int i = 0; i <= 10; ++i) {
        const double s = length_mm(*cut) * i / 10.0;
        const PathDerivatives of_part = derivatives_at(*cut, s);
        const PathDerivatives of_whole = derivatives_at(whole, stretch.begin_mm + s);
        EXPECT_LE((vec(of_part.position_mm) - vec(of_whole.position_mm)).norm(), 1e-10);
        EXPECT_LE((vec(of_part.first) - vec(of_whole.first)).norm(), 1e-9);
        EXPECT_LE((vec(of_part.second_per_mm) - vec(of_whole.second_per_mm)).norm(), 1e-8);
        EXPECT_LE((vec(of_part.third_per_mm2) - vec(of_whole.third_per_mm2)).norm(), 1e-6);
      }
    }
  }
}

TEST(CurvePart, OfAPartIsAPartOfTheWhole) {
  for (const Curve& whole : some_of_each()) {
    const double length = length_mm(whole);
    const auto once = part(whole, {0.1 * length, 0.9 * length});
    const auto twice = part(*once, {0.1 * length, 0.3 * length});
    const auto direct = part(whole, {0.2 * length, 0.4 * length});
    for (const double s : {0.0, 0.07 * length, 0.2 * length}) {
      EXPECT_LE((vec(position_at(*twice, s)) - vec(position_at(*direct, s))).norm(), 1e-10);
    }
  }
}

// A part that is to be run must not be left out, however short it is and wherever it is cut.
TEST(CurvePart, HasNoGapToTheNextPartWhereverTheCurveIsCut) {
  const Curve whole = some_of_each()[2];
  const double length = length_mm(whole);
  std::vector<double> places;
  for (const NurbsPiece& piece : std::get<NurbsCurve>(whole).pieces()) {
    for (const double beside : {-1e-6, -1e-9, -1e-12, -1e-14, 0.0, 1e-14, 1e-12, 1e-9, 1e-6}) {
      places.push_back(piece.s_begin_mm + beside);
    }
  }
  std::erase_if(places, [&](double s) { return !(s > 0.0 && s < length); });
  Position at = position_at(whole, 0.0);
  double begin = 0.0;
  for (const double s : places) {
    if (s <= begin) {
      continue;
    }
    const auto cut = part(whole, {begin, s});
    ASSERT_TRUE(cut.has_value() || s - begin < 1e-14) << s;
    if (cut) {
      EXPECT_LE((vec(position_at(*cut, 0.0)) - vec(at)).norm(), 1e-12) << s;
      at = position_at(*cut, length_mm(*cut));
      EXPECT_NEAR(length_mm(*cut), s - begin, 1e-11) << s;
      begin = s;
    }
  }
}

TEST(NurbsCurve, TellsWhereAParameterIs) {
  const Curve whole = some_of_each()[2];
  const NurbsCurve& curve = std::get<NurbsCurve>(whole);
  for (const double u : {0.0, 0.4, 1.0, 1.7, 2.0}) {
    const double s = curve.s_at(u);
    EXPECT_NEAR(curve.pieces()[curve.piece_index(s)].u_at(s), u, 1e-9);
  }
}

}  // namespace
}  // namespace kerf::curves
