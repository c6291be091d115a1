// One cell of the time optimum: closed forms against their differential equation and against each
// other.
#include "profiles/cell_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "profiles/time_law.hpp"
#include "tests/profiles/laws.hpp"

namespace kerf::profiles::test {
namespace {

// A cell whose v^2 stays positive: v^2 at its middle and end are drawn, too.
struct CellSpecimen {
  CellLaw::Begin begin{};
  double length_mm = 0.0;
};

CellSpecimen random_cell(Draw& draw) {
  const double h = draw.log_uniform({1e-6, 10.0});
  const double b0 = std::pow(draw.log_uniform({1e-3, 500.0}), 2.0);
  const double b1 = b0 * draw.log_uniform({0.2, 5.0});
  // k from the deviation of the middle from the chord, which may be half of the lower end.
  const double sag = draw.uniform({-0.5, 0.5}) * std::min(b0, b1);
  const double k = draw.once_in(5) ? 0.0 : -4.0 * sag / (h * h);
  return {.begin = {.v_mm_s = std::sqrt(b0),
                    .a_mm_s2 = 0.5 * ((b1 - b0) / h - k * h),
                    .bend_per_s2 = k},
          .length_mm = h};
}

TEST(CellLaw, SquaredFeedrateIsTheQuadraticInArcLength) {
  Draw draw(1);
  for (int i = 0; i < 5000; ++i) {
    const auto [begin, h] = random_cell(draw);
    const CellLaw law = CellLaw::between(begin, h);
    for (const double share : {0.0, 0.1, 0.37, 0.5, 0.93, 1.0}) {
      const PathMotion m = law.at(share * law.duration_s());
      const double b =
          begin.v_mm_s * begin.v_mm_s + m.s_mm * (2.0 * begin.a_mm_s2 + begin.bend_per_s2 * m.s_mm);
      const double a = begin.a_mm_s2 + begin.bend_per_s2 * m.s_mm;
      ASSERT_NEAR(m.v_mm_s * m.v_mm_s, b, 1e-9 * std::max(b, begin.v_mm_s * begin.v_mm_s)) << i;
      ASSERT_NEAR(m.a_mm_s2, a, 1e-9 * (std::abs(begin.a_mm_s2) + std::abs(begin.bend_per_s2 * h)));
      ASSERT_NEAR(m.j_mm_s3, begin.bend_per_s2 * m.v_mm_s, 1e-12 * std::abs(m.j_mm_s3));
    }
  }
}

TEST(CellLaw, LastsUntilItsLengthIsDone) {
  Draw draw(2);
  for (int i = 0; i < 5000; ++i) {
    const auto [begin, h] = random_cell(draw);
    const CellLaw law = CellLaw::between(begin, h);
    const double t = law.duration_s();
    ASSERT_NEAR(law.at(t).s_mm, h, 1e-10 * h) << i;
    ASSERT_NEAR(law.at(t).v_mm_s, law.v_end_mm_s(), 1e-8 * law.v_end_mm_s()) << i;
    ASSERT_LT(law.at(0.999 * t).s_mm, h);
  }
}

TEST(CellLaw, FeedrateAndAccelerationAreTheDerivativesOfTheWay) {
  Draw draw(3);
  for (int i = 0; i < 2000; ++i) {
    const auto [begin, h] = random_cell(draw);
    for (const CellLaw& law : {CellLaw::between(begin, h), CellLaw::launch(begin.v_mm_s, h),
                               CellLaw::landing(begin.v_mm_s, h)}) {
      const double dt = 1e-4 * law.duration_s();
      const double t = draw.uniform({0.1, 0.9}) * law.duration_s();
      const PathMotion before = law.at(t - dt);
      const PathMotion at = law.at(t);
      const PathMotion after = law.at(t + dt);
      const double v_size = std::max(law.v_begin_mm_s(), law.v_end_mm_s());
      const double a_size = v_size / law.duration_s();
      ASSERT_NEAR((after.s_mm - before.s_mm) / (2.0 * dt), at.v_mm_s, 1e-6 * v_size);
      ASSERT_NEAR((after.v_mm_s - before.v_mm_s) / (2.0 * dt), at.a_mm_s2, 1e-5 * a_size);
      ASSERT_NEAR((after.a_mm_s2 - before.a_mm_s2) / (2.0 * dt), at.j_mm_s3,
                  1e-4 * a_size / law.duration_s());
    }
  }
}

TEST(CellLaw, WithoutBendIsConstantAcceleration) {
  const CellLaw law = CellLaw::between({.v_mm_s = 10.0, .a_mm_s2 = 50.0}, 3.0);
  const double t = (std::sqrt(100.0 + 2.0 * 50.0 * 3.0) - 10.0) / 50.0;
  EXPECT_NEAR(law.duration_s(), t, 1e-15);
  EXPECT_NEAR(law.at(0.1).s_mm, 10.0 * 0.1 + 0.5 * 50.0 * 0.01, 1e-15);
}

TEST(CellLaw, LaunchAndLandingHaveTheJerkThatTheirLengthAsksFor) {
  const CellLaw up = CellLaw::launch(8.0, 2.0);
  const CellLaw down = CellLaw::landing(8.0, 2.0);
  EXPECT_DOUBLE_EQ(up.duration_s(), 0.75);  // s = v t / 3
  for (const double t : {0.0, 0.2, 0.5, 0.75}) {
    const double jerk = 2.0 * 8.0 / (0.75 * 0.75);
    EXPECT_NEAR(up.at(t).s_mm, jerk * t * t * t / 6.0, 1e-14);
    EXPECT_NEAR(down.at(0.75 - t).s_mm, 2.0 - up.at(t).s_mm, 1e-14);
    EXPECT_NEAR(down.at(0.75 - t).v_mm_s, up.at(t).v_mm_s, 1e-14);
    EXPECT_NEAR(down.at(0.75 - t).a_mm_s2, -up.at(t).a_mm_s2, 1e-12);
  }
}

// One of each kind.
std::vector<CellLaw> random_laws(Draw& draw) {
  const auto [begin, h] = random_cell(draw);
  const double duration_s = draw.log_uniform({1e-5, 1.0});
  const double v = begin.v_mm_s;
  const double a = draw.uniform({-0.4, 2.0}) * v / duration_s;  // v stays above 0
  const double jerk = draw.uniform({-0.4, 2.0}) * v / (duration_s * duration_s);
  return {CellLaw::between(begin, h), CellLaw::launch(v, h), CellLaw::landing(v, h),
          CellLaw::ramp({.v_mm_s = v, .a_mm_s2 = a, .j_mm_s3 = jerk}, duration_s)};
}

TEST(CellLaw, KnowsWhenItIsAtAPlace) {
  Draw draw(4);
  for (int i = 0; i < 2000; ++i) {
    for (const CellLaw& law : random_laws(draw)) {
      const double way_mm = draw.uniform({0.0, 1.0}) * law.length_mm();
      const double t = law.time_at_s(way_mm);
      ASSERT_GE(t, 0.0);
      ASSERT_LE(t, law.duration_s());
      ASSERT_NEAR(law.at(t).s_mm, way_mm, 1e-12 * law.length_mm()) << i;
    }
  }
}

TEST(CellLaw, MovesInAPartAsInTheWhole) {
  Draw draw(5);
  for (int i = 0; i < 2000; ++i) {
    for (const CellLaw& law : random_laws(draw)) {
      const double begin_s = draw.once_in(4) ? 0.0 : draw.uniform({0.0, 0.5}) * law.duration_s();
      const double end_s =
          draw.once_in(4) ? law.duration_s() : draw.uniform({0.6, 1.0}) * law.duration_s();
      const CellLaw part = law.part({.begin_s = begin_s, .end_s = end_s});
      ASSERT_NEAR(part.duration_s(), end_s - begin_s, 1e-8 * law.duration_s()) << i;
      const double v_size = std::max(law.v_begin_mm_s(), law.v_end_mm_s());
      for (const double share : {0.0, 0.3, 0.8, 1.0}) {
        const double t = share * (end_s - begin_s);
        const PathMotion there = law.at(begin_s + t);
        const PathMotion found = part.at(t);
        ASSERT_NEAR(found.s_mm, there.s_mm - law.at(begin_s).s_mm, 1e-8 * law.length_mm()) << i;
        ASSERT_NEAR(found.v_mm_s, there.v_mm_s, 1e-7 * v_size) << i;
        ASSERT_NEAR(found.a_mm_s2, there.a_mm_s2, 1e-6 * v_size / law.duration_s()) << i;
      }
      if (end_s == law.duration_s()) {
        ASSERT_NEAR(part.v_end_mm_s(), law.v_end_mm_s(), 1e-7 * v_size) << i;
      }
    }
  }
}

TEST(TimeLaw, IsWhateverItWasMadeFrom) {
  const CellLaw cell = CellLaw::launch(8.0, 2.0);
  const Transition cruise = Transition::cruise(5.0, 10.0);
  EXPECT_EQ(TimeLaw(cell).duration_s(), cell.duration_s());
  EXPECT_EQ(TimeLaw(cell).ramp().v_end_mm_s, 8.0);
  EXPECT_EQ(TimeLaw(cell).at(0.3).s_mm, cell.at(0.3).s_mm);
  EXPECT_EQ(TimeLaw(cruise).length_mm(), 10.0);
  EXPECT_EQ(TimeLaw(cruise).at(0.3).s_mm, cruise.at(0.3).s_mm);
}

}  // namespace
}  // namespace kerf::profiles::test
