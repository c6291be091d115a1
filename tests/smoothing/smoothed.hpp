// What became of a program, and how far that is from it: measured by points of both paths.
#pragma once

#include <string>
#include <vector>

#include "curves/position.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/smoother.hpp"

namespace kerf::test {

struct Smoothed {
  std::vector<smoothing::PathSegment> segments;
  smoothing::PathDeviation deviation{};
};

// With limits of acceleration and jerk of 1000 mm/s2 and 50000 mm/s3.
Smoothed smooth(const std::vector<parser::Move>& moves);

// Points along both paths so close together that between two of them is nothing to see.
std::vector<curves::Position> points_of(const std::vector<parser::Move>& moves);
std::vector<curves::Position> points_of(const Smoothed& smoothed);

// The largest distance of a point from the path through the others, either way round, in mm. Both
// paths are walked from begin to end together, so that a path's other leg near by is not taken for
// its own.
double apart_mm(const std::vector<curves::Position>& path,
                const std::vector<curves::Position>& other);

// What is wrong with how the segments join: gaps, and kinks where they are said to go on. Empty:
// all is well.
std::string faults_of_junctions(const std::vector<parser::Move>& moves, const Smoothed& smoothed);

}  // namespace kerf::test
