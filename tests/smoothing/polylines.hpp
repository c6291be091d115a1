// Programs of lines and arcs in G64, as moves, for tests of smoothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "curves/position.hpp"
#include "parser/moves/move.hpp"

namespace kerf::test {

struct Tolerances {
  double corner_mm = 0.01;  // P
  double merge_mm = 0.01;   // Q
};

// Straight feeds from the first point through all others, one line of the program each, from
// line 1.
std::vector<parser::Move> lines_through(const std::vector<curves::Position>& points,
                                        const Tolerances& tolerances, double feedrate_mm_s = 100.0);

// A quarter or more of a circle in the plane of X and Y from start about a centre.
struct ArcTo {
  curves::Position start_mm{};
  curves::Position centre_mm{};
  double angle_rad = 0.0;  // > 0 counterclockwise
};
parser::Move arc_move(const ArcTo& arc, const Tolerances& tolerances, double feedrate_mm_s = 100.0);

// Rounded as a program writes it.
curves::Position rounded(const curves::Position& point, int decimals);

// Of many kinds: smooth curves in steps of any length, with any number of decimals, corners,
// reversals, zigzags, straight runs, arcs between, changes of feedrate and of mode.
struct RandomMoves {
  std::string what;  // the kinds, for the message of a failure
  Tolerances tolerances{};
  std::vector<parser::Move> moves;
};
// Most pieces of a small one have some ten lines, of a full one up to 900.
enum class Size : std::uint8_t { small, full };
RandomMoves random_moves(std::uint64_t seed, Size size = Size::full);

}  // namespace kerf::test
