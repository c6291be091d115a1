#include "smoothing/compressor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/smoothing/polylines.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::test {
namespace {

using curves::Position;
using curves::vec;
using smoothing::PathSegment;

std::vector<Position> circle(double radius_mm, int lines, int decimals) {
  std::vector<Position> points;
  for (int i = 0; i <= lines; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / lines;
    points.push_back(
        rounded({radius_mm * std::cos(angle), radius_mm * std::sin(angle), 0.0}, decimals));
  }
  return points;
}

double length_of(const Smoothed& smoothed) {
  double sum = 0.0;
  for (const PathSegment& segment : smoothed.segments) {
    sum += curves::length_mm(segment.curve);
  }
  return sum;
}

TEST(Compressor, MakesOneLineOfAThousandOnALine) {
  std::vector<Position> points;
  for (int i = 0; i <= 1000; ++i) {
    points.push_back({0.2 * i, 0.1 * i, 0.0});
  }
  const Smoothed smoothed = smooth(lines_through(points, {}));
  ASSERT_EQ(smoothed.segments.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<curves::Line>(smoothed.segments[0].curve));
  EXPECT_EQ(curves::position_at(smoothed.segments[0].curve, 1e9), points.back());
  EXPECT_EQ(smoothed.segments[0].marks.size(), 1000U);
}

// It stands across the line that the run becomes, so along it it has no way to speak of: 9e-16 mm,
// of which the plan could make nothing. At the run's end the same.
TEST(Compressor, MakesNoPartOfALineAcrossItsRunThatHasAnotherFeedrate) {
  for (const bool at_begin : {true, false}) {
    std::vector<Position> points{{0, 0, 0}, {6.24e-8, 0, 0}, {6.24e-8, 0.7, 0}, {6.24e-8, 1.4, 0}};
    if (!at_begin) {
      points = {{0, 0, 0}, {0, 0.7, 0}, {0, 1.4, 0}, {6.24e-8, 1.4, 0}};
    }
    std::vector<parser::Move> moves = lines_through(points, {});
    moves[at_begin ? 0 : 2].feedrate_mm_s *= 0.5;
    const Smoothed smoothed = smooth(moves);
    ASSERT_EQ(smoothed.segments.size(), 1U);
    EXPECT_EQ(smoothed.segments[0].feedrate_mm_s, moves[1].feedrate_mm_s);
    EXPECT_EQ(curves::position_at(smoothed.segments[0].curve, 1e9), points.back());
    EXPECT_EQ(smoothed.segments[0].marks.size(), 3U);
  }
}

// There and back, but for the last bit: no line of 3e-26 mm is left of them.
TEST(Compressor, MakesNothingOfLinesThatLeadBackWithinRounding) {
  const double begin_mm = 2e-10;
  const double end_mm = std::nextafter(begin_mm, 1.0);
  const Smoothed smoothed =
      smooth(lines_through({{begin_mm, 0, 0}, {-5e-10, 0, 0}, {end_mm, 0, 0}}, {}));
  EXPECT_TRUE(smoothed.segments.empty());
}

// Each in a corner of two long lines, whose blend is that of the corner alone.
TEST(Compressor, BlendsACornerAcrossLinesFarShorterThanTheTolerance) {
  const Smoothed corner = smooth(lines_through({{0, 0, 8}, {0, 0, 0}, {4, 0, 0}}, {}));
  const std::vector<std::vector<Position>> ways{{{-8e-5, 0, 0}},
                                                {{0, 3e-9, 0}, {0, 3e-9, 4e-320}},
                                                {{1e-7, 0, 0}, {0, 0, 0}},
                                                {{-5e-5, 0, 0}, {5e-5, 0, 0}, {-5e-5, 0, 0}}};
  for (const std::vector<Position>& way : ways) {
    std::vector<Position> points{{0, 0, 8}, {0, 0, 0}};
    points.insert(points.end(), way.begin(), way.end());
    points.push_back({4, 0, 0});
    const std::vector<parser::Move> moves = lines_through(points, {});
    const Smoothed smoothed = smooth(moves);
    ASSERT_EQ(smoothed.segments.size(), corner.segments.size());
    EXPECT_EQ(faults_of_junctions(moves, smoothed), "");
    EXPECT_NEAR(length_of(smoothed), length_of(corner), 2e-4);
    EXPECT_LE(apart_mm(points_of(moves), points_of(smoothed)),
              smoothed.deviation.distance_mm + 1e-9);
    EXPECT_LE(smoothed.deviation.distance_mm, 0.01);
  }
}

TEST(Compressor, EndsARunWhereItsLastLineDoesHoweverShort) {
  for (const double length_mm : {1e-12, 1e-8, 9e-5}) {
    const std::vector<parser::Move> moves =
        lines_through({{0, 0, 0}, {3, 0, 0}, {3, length_mm, 0}}, {});
    const Smoothed smoothed = smooth(moves);
    ASSERT_EQ(smoothed.segments.size(), 1U);
    EXPECT_EQ(curves::position_at(smoothed.segments[0].curve, 1e9), (Position{3, length_mm, 0}));
    EXPECT_GE(smoothed.deviation.distance_mm,
              length_mm * std::cos(length_mm / 3.0) * (1.0 - 1e-12));
  }
}

// The chords of 0.002 mm are 5e-8 mm off the circle, and those over two of them four times as far.
TEST(Compressor, TellsOfLinesThatItLeavesOutHowFarTheyAreAside) {
  const Smoothed smoothed = smooth(lines_through(circle(10.0, 31416, 9), {}));
  EXPECT_LE(smoothed.deviation.distance_mm, 1e-4);
}

TEST(Compressor, KeepsALineFarShorterThanTheToleranceThatIsAlone) {
  const Smoothed smoothed = smooth(lines_through({{0, 0, 0}, {2e-5, 0, 0}, {2e-5, 1e-5, 0}}, {}));
  ASSERT_EQ(smoothed.segments.size(), 1U);
  EXPECT_EQ(curves::position_at(smoothed.segments[0].curve, 1e9), (Position{2e-5, 1e-5, 0}));
  EXPECT_TRUE(smooth(lines_through({{0, 0, 0}, {2e-5, 0, 0}, {0, 0, 0}}, {})).segments.empty());
}

// Its own feedrate may be so low that it takes long.
TEST(Compressor, KeepsALineFarShorterThanTheToleranceThatHasAFeedrateOfItsOwn) {
  std::vector<parser::Move> moves =
      lines_through({{0, 0, 8}, {0, 0, 0}, {8e-5, 0, 0}, {4, 0, 0}}, {});
  moves[1].feedrate_mm_s = 1e-5;
  const Smoothed smoothed = smooth(moves);
  EXPECT_TRUE(std::ranges::any_of(
      smoothed.segments, [](const PathSegment& segment) { return segment.feedrate_mm_s == 1e-5; }));
}

// Lines of 1e-12 to 1e-2 mm between others, of which some are left out.
TEST(Compressor, StaysWithinTheToldDeviationWithShortLinesAnywhere) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<Position> points{{0, 0, 0}};
    for (int i = 0; i < 60; ++i) {
      const bool is_short = share(random) < 0.5;
      const double step = is_short ? std::pow(10.0, -12.0 + 10.0 * share(random))
                                   : std::pow(10.0, -2.0 + 3.0 * share(random));
      Position next = points.back();
      for (double& coordinate : next) {
        coordinate += step * (2.0 * share(random) - 1.0);
      }
      points.push_back(next);
    }
    const std::vector<parser::Move> moves = lines_through(points, {});
    const Smoothed smoothed = smooth(moves);
    EXPECT_EQ(faults_of_junctions(moves, smoothed), "");
    EXPECT_LE(smoothed.deviation.distance_mm, 0.01);
    EXPECT_LE(apart_mm(points_of(moves), points_of(smoothed)),
              smoothed.deviation.distance_mm + 1e-6);
  }
}

// Noise of the last decimal turns lines of 0.05 mm by up to 0.03 rad; the circle's own curvature is
// 0.1 / mm. What is left of the noise may bend the curve by a tenth of that.
TEST(Compressor, AveragesTheNoiseOfTheLastDecimal) {
  const Smoothed smoothed = smooth(lines_through(circle(10.0, 1257, 3), {}));
  double least = HUGE_VAL;
  double most = 0.0;
  for (const PathSegment& segment : smoothed.segments) {
    const double length = curves::length_mm(segment.curve);
    for (int i = 0; i <= 200; ++i) {
      const double curvature =
          vec(curves::derivatives_at(segment.curve, length * i / 200.0).second_per_mm).norm();
      least = std::min(least, curvature);
      most = std::max(most, curvature);
    }
  }
  EXPECT_GT(least, 0.09);
  EXPECT_LT(most, 0.11);
  EXPECT_NEAR(length_of(smoothed), 20.0 * std::numbers::pi, 0.01);
}

// A slope as coordinates of a coarse step write it: corners of 90 degrees, none of them meant.
TEST(Compressor, MakesASlopeOfStairsFarFinerThanTheTolerance) {
  for (const double step_mm : {0.001, 0.002, 0.005}) {
    SCOPED_TRACE(step_mm);
    std::vector<Position> points;
    for (int i = 0; i <= 600; ++i) {
      points.push_back({(i + 1) / 2 * step_mm, i / 2 * step_mm, 0.0});
    }
    const auto moves = lines_through(points, {.corner_mm = 0.01, .merge_mm = 0.01});
    const Smoothed smoothed = smooth(moves);
    EXPECT_LT(length_of(smoothed), 1.03 * std::hypot(points.back()[0], points.back()[1]));
    EXPECT_LE(apart_mm(points_of(moves), points_of(smoothed)), 0.01);
  }
}

TEST(Compressor, TellsAPlaceOfItsOwnPathWhereItIsFarthestFromTheProgrammedOne) {
  for (const int decimals : {2, 3}) {
    const Smoothed smoothed = smooth(lines_through(circle(3.0, 150, decimals), {.merge_mm = 0.02}));
    ASSERT_GT(smoothed.deviation.distance_mm, 1e-3);
    const std::vector<Position> path = points_of(smoothed);
    double nearest = HUGE_VAL;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Eigen::Vector3d chord = vec(path[i]) - vec(path[i - 1]);
      const Eigen::Vector3d seen = vec(smoothed.deviation.at_mm) - vec(path[i - 1]);
      const double share = std::clamp(seen.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (seen - share * chord).norm());
    }
    EXPECT_LT(nearest, 0.2 * smoothed.deviation.distance_mm) << decimals;
  }
}

TEST(Compressor, MakesAnArcOfACircularRun) {
  for (const int decimals : {3, 6}) {
    const Smoothed smoothed = smooth(lines_through(circle(10.0, 300, decimals), {}));
    ASSERT_EQ(smoothed.segments.size(), 1U) << decimals;
    const auto* arc = std::get_if<curves::Arc>(&smoothed.segments[0].curve);
    ASSERT_NE(arc, nullptr);
    EXPECT_NEAR(arc->radius_mm(), 10.0, 1e-3);
    EXPECT_NEAR(arc->length_mm(), 20.0 * std::numbers::pi, 1e-2);
    EXPECT_LE(smoothed.deviation.distance_mm, 0.01);
  }
}

TEST(Compressor, LeavesAPlaceOutOfReachToBeRefused) {
  const auto moves = lines_through({{0, 0, 0}, {1, 0, 0}, {2e9, 0, 0}}, {});
  smoothing::Smoother smoother({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 50000.0});
  EXPECT_TRUE(smoother.push(moves[0]).has_value());
  EXPECT_FALSE(smoother.push(moves[1]).has_value());
}

TEST(Compressor, KeepsARealCornerOfFineStepsForABlend) {
  std::vector<Position> points;
  for (int i = 0; i <= 100; ++i) {
    points.push_back({0.01 * i, 0.0, 0.0});
  }
  for (int i = 1; i <= 100; ++i) {
    points.push_back({1.0, 0.01 * i, 0.0});
  }
  const Smoothed smoothed = smooth(lines_through(points, {}));
  ASSERT_EQ(smoothed.segments.size(), 3U);  // line, blend, line
  EXPECT_TRUE(std::holds_alternative<curves::Line>(smoothed.segments[0].curve));
  EXPECT_TRUE(std::holds_alternative<curves::Line>(smoothed.segments[2].curve));
  EXPECT_LE(smoothed.deviation.distance_mm, 0.01);
}

TEST(Compressor, KeepsCoarseLinesWhoseChordsRiseByMoreThanTheTolerance) {
  const auto points = circle(10.0, 20, 4);  // chord height 0.12 mm
  const Smoothed smoothed = smooth(lines_through(points, {.corner_mm = 0.0, .merge_mm = 0.01}));
  EXPECT_EQ(smoothed.segments.size(), 20U);
  EXPECT_EQ(smoothed.deviation.distance_mm, 0.0);
}

TEST(Compressor, ChangesTheFeedrateWhereTheProgramDoes) {
  auto moves = lines_through(circle(10.0, 600, 4), {});
  for (std::size_t i = 300; i < moves.size(); ++i) {
    moves[i].feedrate_mm_s = 20.0;
  }
  const Smoothed smoothed = smooth(moves);
  double at = 0.0;
  double changed_at = 0.0;
  for (const PathSegment& segment : smoothed.segments) {
    if (segment.feedrate_mm_s == 20.0 && changed_at == 0.0) {
      changed_at = at;
      EXPECT_EQ(segment.source.line, 301U);
      EXPECT_TRUE(segment.continues);
    }
    at += curves::length_mm(segment.curve);
  }
  EXPECT_NEAR(changed_at, 10.0 * std::numbers::pi, 1e-3);
}

TEST(Compressor, KnowsWhereEachLineOfTheProgramIs) {
  const auto points = circle(10.0, 600, 6);
  const Smoothed smoothed = smooth(lines_through(points, {}));
  for (const PathSegment& segment : smoothed.segments) {
    for (const smoothing::LineMark& mark : segment.marks) {
      if (mark.s_mm > 0.0) {
        const Position at = curves::position_at(segment.curve, mark.s_mm);
        EXPECT_LE((vec(at) - vec(points[mark.line - 1])).norm(), 0.01) << mark.line;
      }
    }
  }
}

// Lines of 0.02 mm into one of 1 mm or out of it, which turns by half a degree: a blend that is
// longer than many of them. Each has its place on it.
TEST(Compressor, KnowsWhereEachLineOfTheProgramIsAlongABlend) {
  std::vector<Position> points;
  for (int i = 0; i <= 40; ++i) {
    points.push_back({0.02 * i, 0.0, 0.0});
  }
  points.push_back({1.8, -0.01, 0.0});
  for (int i = 1; i <= 40; ++i) {
    points.push_back({1.8 + 0.02 * i, -0.01, 0.0});
  }
  const Smoothed smoothed = smooth(lines_through(points, {}));
  ASSERT_GT(smoothed.segments.size(), 3U) << "corners, and blends in them";
  std::vector<bool> found(points.size(), false);
  for (const PathSegment& segment : smoothed.segments) {
    const double length = curves::length_mm(segment.curve);
    for (std::size_t i = 0; i < segment.marks.size() && segment.marks[i].s_mm < length; ++i) {
      const smoothing::LineMark& mark = segment.marks[i];
      if (found[mark.line]) {
        continue;
      }
      found[mark.line] = true;
      const Position at = curves::position_at(segment.curve, mark.s_mm);
      EXPECT_LE((vec(at) - vec(points[mark.line - 1])).norm(), 0.01) << mark.line;
      EXPECT_TRUE(i == 0 || mark.s_mm > segment.marks[i - 1].s_mm) << mark.line << " has no motion";
    }
    found[segment.source.line] = true;
  }
  for (std::size_t line = 1; line < points.size(); ++line) {
    EXPECT_TRUE(found[line]) << line;
  }
}

TEST(Compressor, LetsAnEventWithTheMotionComeWhereItStands) {
  auto moves = lines_through(circle(10.0, 600, 4), {});
  parser::Move event;
  event.shape = parser::EventMove{.kind = parser::EventKind::digital_at_motion, .value = 1.0};
  moves.insert(moves.begin() + 200, event);
  smoothing::Smoother smoother({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 50000.0});
  double length = 0.0;
  double event_at = -1.0;
  const auto take = [&] {
    smoothing::Smoother::Output output;
    while (smoother.next(output)) {
      const PathSegment& segment = std::get<PathSegment>(output);
      if (!segment.changes.empty()) {
        event_at = length;
      }
      length += curves::length_mm(segment.curve);
    }
  };
  for (const parser::Move& move : moves) {
    ASSERT_TRUE(smoother.push(move).has_value());
    take();
  }
  smoother.flush();
  take();
  EXPECT_NEAR(event_at, 20.0 * std::numbers::pi / 3.0, 0.01);
}

}  // namespace
}  // namespace kerf::test
