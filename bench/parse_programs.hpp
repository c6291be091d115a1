// Programs to parse, made the same way every time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kerf::bench {

// The text of a benchmark and how many lines the parser goes through to its end: a line in a loop
// counts as often as it is run.
struct ParseProgram {
  std::string text;
  std::uint64_t lines = 0;
};

// A three-axis finishing pass as a CAM system posts it: rows of 1000 steps of about 0.17 mm over a
// wavy surface, modal words, line numbers, comments, changes of feed. Whole rows, at least `bytes`.
ParseProgram finishing_pass(std::size_t bytes);
// The same, all of it inside one O-word loop that runs once: the text has to be kept.
ParseProgram finishing_pass_in_loop(std::size_t bytes);
// One row of it in a loop, run as often as it takes to make `lines`.
ParseProgram short_loop(std::uint64_t lines);
// A loop that reckons its points: a parameter set and two coordinates as expressions, per turn.
ParseProgram expression_loop(std::uint64_t lines);
// Arcs by centre and by radius.
ParseProgram circles(int count);
// Cubic NURBS of six control points.
ParseProgram curves(int count);

// Reads a program in pieces of 64 KiB, as from a file, and fetches all its moves. Returns how many
// there were; -1 where the program has errors.
std::int64_t read_moves(std::string_view text);

}  // namespace kerf::bench
