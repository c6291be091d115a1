#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/smoothing/polylines.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::test {
namespace {

using curves::Position;
using curves::vec;
using smoothing::PathSegment;

double turn_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The joints at which the path leaves less than four fifths of the angle between the two lines that
// the program has there: a tenth of it may be lost on either side. With corners left alone.
std::string sharper_joints(const std::vector<Position>& points, double merge_mm) {
  std::string found;
  const Smoothed smoothed = smooth(lines_through(points, {.corner_mm = 0.0, .merge_mm = merge_mm}));
  for (std::size_t i = 1; i < smoothed.segments.size(); ++i) {
    const PathSegment& before = smoothed.segments[i - 1];
    const PathSegment& after = smoothed.segments[i];
    const std::size_t vertex = after.source.line - 1;
    const double joint =
        turn_rad(vec(curves::derivatives_at(before.curve, curves::length_mm(before.curve)).first),
                 vec(curves::derivatives_at(after.curve, 0.0).first));
    const double corner = turn_rad(vec(points[vertex]) - vec(points[vertex - 1]),
                                   vec(points[vertex + 1]) - vec(points[vertex]));
    if (std::numbers::pi - joint < 0.8 * (std::numbers::pi - corner) - 1e-6) {
      found += "line " + std::to_string(vertex + 1) + " turns by " + std::to_string(joint) +
               " instead of " + std::to_string(corner) + "; ";
    }
  }
  return found;
}

constexpr double kMerge_mm = 0.01;

// Lines of 2 to 100 times the tolerance of merging that turn by up to 150 degrees.
std::vector<Position> random_points(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double most_rad = share(random) * 150.0 / 180.0 * std::numbers::pi;
  const double reach = std::pow(50.0, share(random));
  std::vector<Position> points{{0, 0, 0}};
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d aside =
        direction.cross(Eigen::Vector3d(share(random), share(random), 1.0)).normalized();
    const Eigen::Vector3d axis = direction.cross(aside).normalized();
    direction = Eigen::AngleAxisd((2.0 * share(random) - 1.0) * most_rad, axis) * direction;
    const double length_mm = 2.0 * kMerge_mm * std::pow(reach, share(random));
    points.push_back(curves::to_position(vec(points.back()) + length_mm * direction));
  }
  return points;
}

// Three lines are merged after a corner of 36 degrees. The spline nearest to them begins across
// them, by 121 degrees, and would make a cusp of it.
TEST(MergedLines, JoinALineNoMoreSharplyThanTheyDoInTheProgram) {
  EXPECT_EQ(sharper_joints({{0, 0, 0},
                            {0.0582, -0.1127, -0.0341},
                            {0.1330, -0.1497, -0.0448},
                            {0.1230, -0.0583, -0.0207},
                            {0.3464, -0.0596, -0.0832},
                            {0.3494, 0.1387, -0.0443}},
                           0.02),
            "");
}

TEST(MergedLines, JoinEachOtherNoMoreSharplyThanTheyDoInTheProgram) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    EXPECT_EQ(sharper_joints(random_points(seed), kMerge_mm), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace kerf::test
