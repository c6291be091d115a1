// No rest that the path does not ask for: every fiftieth or so of the runs of `kerf-bench stops`.
#include "tests/kernel/smooth_runs.hpp"

#include <array>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

// Odd, so that it meets every degree.
#ifdef KERF_SLOW_BUILD
constexpr std::size_t kEvery = 343;
#else
constexpr std::size_t kEvery = 49;
#endif
constexpr std::size_t kPartsOfKind = 4;  // that may run side by side

using KindAndPart = std::tuple<SmoothKind, std::size_t>;

class SmoothRuns : public testing::TestWithParam<KindAndPart> {};

TEST_P(SmoothRuns, ComeToRestAtTheirEndAlone) {
  const auto [kind, part] = GetParam();
  for (std::size_t i = part * kEvery; i < count_of(kind); i += kPartsOfKind * kEvery) {
    const SmoothRun run = smooth_run(kind, i);
    const SmoothPlan plan = plan_of(run);
    EXPECT_EQ(plan.complaint, "") << run.name;
    EXPECT_GT(plan.time_s, 0.0) << run.name;
    EXPECT_EQ(plan.degradations.count, 0U) << run.name;
  }
}

// Degree 2 in G64 with the limits of a router: a search over a whole window does not end well, from
// rest nor in motion; over half as many cells it does.
TEST(SmoothSpline, IsPlannedOverFewerCellsWhereTheWholeWindowIsNot) {
  const SmoothRun run = smooth_run(SmoothKind::spline, 840);
  ASSERT_EQ(run.name, "degree 2, knots 0, machine 2, G64, seed 5");
  EXPECT_EQ(plan_of(run).degradations.count, 0U);
}

// Its curvature jumps at each knot. What is smoothed within P costs it little.
TEST(SmoothSpline, OfDegreeTwoInG64TakesAtMost1_3TimesAsLongAsOfDegreeThreeThroughTheSamePoints) {
  for (const std::size_t machine : {0U, 1U, 2U}) {
    const std::size_t index = 72 + 144 * machine + 24 * machine + 8 * (machine % 2);
    const SmoothRun rough = smooth_run(SmoothKind::spline, index);
    const SmoothRun smooth = smooth_run(SmoothKind::spline, index + 1);
    ASSERT_EQ(rough.name.find("degree 2, "), 0U);
    ASSERT_EQ(rough.name.substr(8), smooth.name.substr(8));
    ASSERT_NE(rough.name.find("G64"), std::string::npos);
    const SmoothPlan of_rough = plan_of(rough);
    const SmoothPlan of_smooth = plan_of(smooth);
    EXPECT_EQ(of_rough.complaint + of_smooth.complaint, "");
    EXPECT_LE(of_rough.time_s, 1.3 * of_smooth.time_s) << rough.name;
  }
}

std::string test_name(const testing::TestParamInfo<KindAndPart>& kind_and_part) {
  constexpr std::array kNames{"Splines", "LongSplines", "ShippedCurves", "ShortLines", "Random"};
  const auto [kind, part] = kind_and_part.param;
  return kNames.at(static_cast<std::size_t>(kind)) + std::to_string(part + 1);
}

INSTANTIATE_TEST_SUITE_P(, SmoothRuns,
                         testing::Combine(testing::ValuesIn(kSmoothKinds),
                                          testing::Range(std::size_t{0}, kPartsOfKind)),
                         test_name);

}  // namespace
}  // namespace kerf::test
