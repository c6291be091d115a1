#include "tests/kernel/smoothing_program.hpp"

#include <cstdio>
#include <variant>

#include "tests/smoothing/polylines.hpp"

namespace kerf::test {

namespace {

// Of a coordinate: read back, it is the same double.
std::string word(char letter, double value) {
  char text[40];
  std::snprintf(text, sizeof text, " %c%.20f", letter, value);
  return text;
}

}  // namespace

RandomProgram smoothing_program(std::uint64_t seed) {
  const RandomMoves moves = random_moves(seed);
  RandomProgram program;
  program.text = "G21 G90 G17 G64" + word('P', moves.tolerances.corner_mm) +
                 word('Q', moves.tolerances.merge_mm) + "\n";
  program.feedrate_mm_s.push_back(0.0);
  for (const parser::Move& move : moves.moves) {
    parser::Point end{};
    if (const auto* line = std::get_if<parser::LineMove>(&move.shape)) {
      end = line->end_mm;
      program.text += "G1";
    } else if (const auto* arc = std::get_if<parser::ArcMove>(&move.shape)) {
      end = arc->end_mm;
      program.text += arc->clockwise ? "G2" : "G3";
      program.text += word('I', arc->centre_mm[0] - move.start_mm[0]) +
                      word('J', arc->centre_mm[1] - move.start_mm[1]);
    }
    program.text += word('X', end[0]) + word('Y', end[1]) + word('Z', end[2]) +
                    word('F', 60.0 * move.feedrate_mm_s) + "\n";
    program.feedrate_mm_s.push_back(move.feedrate_mm_s);
    program.end_mm = end;
  }
  program.text += "M2\n";
  program.feedrate_mm_s.push_back(0.0);
  return program;
}

}  // namespace kerf::test
