#include "tests/kernel/smoothing_program.hpp"

#include <cstdio>
#include <variant>

namespace kerf::test {

namespace {

// Of a coordinate: read back, it is the same double.
std::string word(char letter, double value) {
  char text[40];
  std::snprintf(text, sizeof text, " %c%.20f", letter, value);
  return text;
}

std::string mode_words(const parser::Move& move) {
  switch (move.mode) {
    case parser::PathMode::exact_path:
      return "G61";
    case parser::PathMode::exact_stop:
      return "G61.1";
    case parser::PathMode::blend:
      break;
  }
  return "G64" + word('P', move.blend_tolerance_mm) + word('Q', move.merge_tolerance_mm);
}

}  // namespace

RandomMoves smoothing_moves(std::uint64_t seed) {
  return random_moves(seed, seed % 64 == 0 ? Size::full : Size::small);
}

RandomProgram smoothing_program(std::uint64_t seed) {
  RandomProgram program;
  const auto add_line = [&program](const std::string& text, double feedrate_mm_s) {
    program.text += text + "\n";
    program.feedrate_mm_s.push_back(feedrate_mm_s);
  };
  add_line("G21 G90 G17", 0.0);
  std::string mode;
  for (const parser::Move& move : smoothing_moves(seed).moves) {
    if (mode != mode_words(move)) {
      mode = mode_words(move);
      add_line(mode, 0.0);
    }
    parser::Point end{};
    std::string text;
    if (const auto* line = std::get_if<parser::LineMove>(&move.shape)) {
      end = line->end_mm;
      text = "G1";
    } else if (const auto* arc = std::get_if<parser::ArcMove>(&move.shape)) {
      end = arc->end_mm;
      text = (arc->clockwise ? "G2" : "G3") + word('I', arc->centre_mm[0] - move.start_mm[0]) +
             word('J', arc->centre_mm[1] - move.start_mm[1]);
    }
    text += word('X', end[0]) + word('Y', end[1]) + word('Z', end[2]);
    add_line(text + word('F', 60.0 * move.feedrate_mm_s), move.feedrate_mm_s);
    program.end_mm = end;
  }
  add_line("M2", 0.0);
  return program;
}

}  // namespace kerf::test
