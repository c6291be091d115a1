#include "tests/kernel/smoothing_program.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
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

class SmoothingWriter {
 public:
  explicit SmoothingWriter(const std::string& codes) { add_line(codes, 0.0); }

  void add_line(const std::string& text, double feedrate_mm_s) {
    program_.text += text + "\n";
    program_.feedrate_mm_s.push_back(feedrate_mm_s);
  }

  // per_mm_s: what F is for each mm/s.
  void add_move(const parser::Move& move, double per_mm_s) {
    if (mode_ != mode_words(move)) {
      mode_ = mode_words(move);
      add_line(mode_, 0.0);
    }
    std::string text;
    if (const auto* line = std::get_if<parser::LineMove>(&move.shape)) {
      program_.end_mm = line->end_mm;
      text = "G1";
    } else if (const auto* arc = std::get_if<parser::ArcMove>(&move.shape)) {
      program_.end_mm = arc->end_mm;
      text = (arc->clockwise ? "G2" : "G3") + word('I', arc->centre_mm[0] - move.start_mm[0]) +
             word('J', arc->centre_mm[1] - move.start_mm[1]);
    }
    const auto& end = program_.end_mm;
    text += word('X', end[0]) + word('Y', end[1]) + word('Z', end[2]);
    add_line(text + word('F', per_mm_s * move.feedrate_mm_s), move.feedrate_mm_s);
  }

  RandomProgram end() {
    add_line("M2", 0.0);
    return std::move(program_);
  }

 private:
  RandomProgram program_;
  std::string mode_;
};

}  // namespace

RandomMoves smoothing_moves(std::uint64_t seed) {
  return random_moves(seed, seed % 64 == 0 ? Size::full : Size::small);
}

RandomProgram smoothing_program(std::uint64_t seed) {
  SmoothingWriter writer("G21 G90 G17");
  for (const parser::Move& move : smoothing_moves(seed).moves) {
    writer.add_move(move, 60.0);
  }
  return writer.end();
}

RandomProgram milling_program(std::uint64_t seed) {
  constexpr std::array<const char*, 8> kBetween{"G4 P0.03", "M0", "M64 P1", "M65 P1",
                                                "M8",       "M9", "M3",     "M5"};
  constexpr double kSpeed_rev_min = 1200.0;
  constexpr double kSlowest_mm_s = 10.0;
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const bool per_revolution = random() % 4 == 0;
  SmoothingWriter writer(per_revolution ? "G21 G90 G17 G95 M3 S1200" : "G21 G90 G17 M3 S1200");
  for (const parser::Move& move : smoothing_moves(seed).moves) {
    if (random() % 12 == 0) {
      // Without its spindle a feed a revolution is none.
      writer.add_line(kBetween.at(random() % (per_revolution ? 7 : kBetween.size())), 0.0);
    }
    if (random() % 16 == 0 && std::holds_alternative<parser::LineMove>(move.shape)) {
      writer.add_line("G0" + word('X', move.start_mm[0] + uniform(-20.0, 20.0)) +
                          word('Z', move.start_mm[2] + uniform(0.0, 10.0)),
                      0.0);
    }
    parser::Move faster = move;
    faster.feedrate_mm_s = std::max(kSlowest_mm_s, move.feedrate_mm_s);
    writer.add_move(faster, per_revolution ? 60.0 / kSpeed_rev_min : 60.0);
  }
  return writer.end();
}

}  // namespace kerf::test
