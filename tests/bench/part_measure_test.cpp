// The judge of kerf-bench parts sees what it is for.
#include "bench/part_measure.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "bench/part_programs.hpp"

namespace kerf::bench {
namespace {

// Ticks at equal steps along a path, each of its element's line.
Ticks along(const std::vector<PathElement>& path, double step_mm) {
  Ticks ticks;
  for (const PathElement& element : path) {
    const double steps = std::round(element.length_mm() / step_mm);
    for (double i = 0.0; i < steps; ++i) {
      ticks.at_mm.push_back(element.at(i / steps));
      ticks.line.push_back(element.line);
    }
  }
  ticks.at_mm.push_back(path.back().to_mm);
  ticks.line.push_back(path.back().line);
  return ticks;
}

TEST(PartMeasure, FindsNothingWhereTheTicksAreOnThePath) {
  for (const PartProgram& program :
       {square(10.0), raster(1200), pocket(), small_loops(20), engraving()}) {
    const Deviation found = deviation(along(program.path, 0.02), program.path);
    EXPECT_LT(found.of_ticks_mm, 1e-9);
    EXPECT_LT(found.of_line_mm, 1e-9);
    EXPECT_LT(found.of_path_mm, 1e-3) << "chords of 0.02 mm across corners and small arcs";
  }
}

TEST(PartMeasure, FindsACornerThatIsCutByABow) {
  constexpr double kRadius_mm = 0.1;
  PartWriter cut({}, 6);
  cut.line_to({10.0 - kRadius_mm, 0.0, 0.0});
  cut.arc_to({.to_mm = {10.0, kRadius_mm}, .centre_mm = {10.0 - kRadius_mm, kRadius_mm}});
  cut.line_to({10.0, 10.0, 0.0});
  PartWriter programmed({}, 6);
  programmed.line_to({10.0, 0.0, 0.0});
  programmed.line_to({10.0, 10.0, 0.0});
  const Deviation found = deviation(along(cut.finish().path, 0.01), programmed.finish().path);
  EXPECT_NEAR(found.of_path_mm, kRadius_mm * (std::sqrt(2.0) - 1.0), 1e-6);
  EXPECT_NEAR(found.of_ticks_mm, kRadius_mm * (1.0 - std::sqrt(0.5)), 1e-5);
}

TEST(PartMeasure, FindsATickBesideThePath) {
  const PartProgram program = raster(300);
  Ticks ticks = along(program.path, 0.05);
  const std::size_t in_the_middle = ticks.at_mm.size() / 2;
  ticks.at_mm[in_the_middle][1] += 0.03;
  EXPECT_NEAR(deviation(ticks, program.path).of_ticks_mm, 0.03, 0.03 * 0.05);
}

TEST(PartMeasure, FindsAPlaceThatWasLeftOut) {
  const PartProgram program = small_loops(3);
  PartWriter without({}, 4);
  for (const PathElement& element : program.path) {
    without.line_to(element.to_mm);  // whole circles vanish, half ones become their chords
  }
  const Deviation found = deviation(along(without.finish().path, 0.01), program.path);
  EXPECT_GT(found.of_path_mm, 0.9) << "a half circle of 0.5 mm, a whole one of 1 mm across";
}

TEST(PartMeasure, FindsATickOfAnotherLine) {
  const PartProgram program = square(10.0);
  Ticks ticks = along(program.path, 0.05);
  ticks.line[100] = program.path[2].line;
  EXPECT_NEAR(deviation(ticks, program.path).of_line_mm, 10.0, 1e-9);
}

lookahead::PlanLimits limits() {
  lookahead::PlanLimits limits;
  limits.period_s = 0.001;
  limits.axes.fill({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 20'000.0});
  return limits;
}

TEST(PartMeasure, SeesTheLimitThatIsPassedMost) {
  Ticks ticks;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.001 * i;
    ticks.at_mm.push_back({0.0, 30'000.0 * t * t * t / 6.0, 0.0});  // a third derivative of 30000
  }
  const OverLimit found = largest_over_limit(ticks, limits());
  EXPECT_EQ(found.what, "y acceleration");  // 30000 * 0.098 at the last
  EXPECT_NEAR(found.ratio, 30'000.0 * 0.098 / 1000.0, 1e-6);
  ticks.at_mm.resize(20);
  EXPECT_EQ(largest_over_limit(ticks, limits()).what, "y jerk");
  EXPECT_NEAR(largest_over_limit(ticks, limits()).ratio, 1.5, 1e-6);
}

}  // namespace
}  // namespace kerf::bench
