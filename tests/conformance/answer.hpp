// LinuxCNC's answer to a program (a .golden file), what Kerf makes of the same program, and where
// the two differ.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "parser/moves/move.hpp"

namespace kerf::conformance {

// One move as a line of a golden file says it.
struct Step {
  std::string kind;          // rapid, feed, probe, arc, spline, tap, dwell, event
  parser::Point end_mm{};    // in machine coordinates; not used by spline and dwell
  double feed_mm_min = 0.0;  // of feed, probe and arc
  parser::Point centre_mm{};
  std::string way;                     // of an arc: "cw xy turns 1"
  std::array<double, 3> turned_deg{};  // A, B, C; of programs in axes/
  double time_s = 0.0;                 // of a dwell
};

struct Answer {
  double tolerance_mm = 0.0;
  std::vector<Step> steps;
  std::string refusal;  // empty: the program was read to its end
};

// Reads a golden file. Throws std::runtime_error where it is not one.
Answer read_answer(const std::filesystem::path& golden);

// What Kerf makes of a program, with the tools of tools.tbl and the files of called/ beside it.
// Events are part of it where the program is in events/; the machine has A, B and C where it is in
// axes/.
Answer kerf_answer(const std::filesystem::path& program);

// The first difference in words, or nothing. Moves of no length count as none.
std::string first_difference(const Answer& wanted, const Answer& found);

std::string text_of(const Step& step);

std::string read_file(const std::filesystem::path& path);

}  // namespace kerf::conformance
