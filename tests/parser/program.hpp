// A whole program read at once or in pieces, and moves as text for comparing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "parser/program_reader.hpp"

namespace kerf::parser {

struct Program {
  std::vector<Move> moves;
  std::vector<diagnostics::Diagnostic> diagnostics;
  bool at_end = false;
  bool has_errors = false;
};

// "file:line:column: error: message", without the identifier.
inline std::string message_line(const diagnostics::Diagnostic& diagnostic, std::string_view file) {
  std::string text = to_string(diagnostic, file);
  text.erase(text.rfind(" [E"));
  return text;
}

inline Program read_program(std::string_view text, const ReaderOptions& options = {},
                            std::size_t piece = std::numeric_limits<std::size_t>::max()) {
  ProgramReader reader(options);
  Program program;
  Move move;
  const auto fetch = [&] {
    while (reader.next(move)) {
      program.moves.push_back(move);
    }
  };
  for (std::size_t at = 0; at < text.size(); at += std::min(piece, text.size() - at)) {
    reader.feed(text.substr(at, piece));
    fetch();
  }
  reader.finish();
  fetch();
  program.diagnostics = reader.diagnostics();
  program.at_end = reader.at_end();
  program.has_errors = reader.has_errors();
  return program;
}

// Reads a program that must be free of errors, with an end added.
inline std::vector<Move> moves_of(std::string_view text) {
  const Program program = read_program(std::string(text) + "\nM2\n");
  std::vector<Move> moves = program.moves;
  if (program.has_errors || moves.empty()) {
    throw std::runtime_error(program.diagnostics.empty()
                                 ? "no moves"
                                 : message_line(program.diagnostics.front(), "program"));
  }
  moves.pop_back();
  return moves;
}

// The first message, as `line:column: error: ...`.
inline std::string first_message(std::string_view text) {
  const Program program = read_program(std::string(text) + "\nM2\n");
  return program.diagnostics.empty() ? "no message"
                                     : message_line(program.diagnostics.front(), "").substr(1);
}

inline std::string text_of(const Point& point) {
  std::ostringstream out;
  out.precision(12);
  for (const double coordinate : point) {
    const double rounded = std::round(coordinate * 1e9) / 1e9;
    out << (out.tellp() > 0 ? " " : "") << (rounded == 0.0 ? 0.0 : rounded);
  }
  return out.str();
}

// One line of text for a move: what a .expect file holds.
inline std::string text_of(const Move& move) {
  std::ostringstream out;
  out.precision(12);
  out << move.source.line << ": ";
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    out << (move.rapid ? "rapid to " : "line to ") << text_of(line->end_mm);
  } else if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    out << (arc->clockwise ? "clockwise in " : "counterclockwise in ")
        << (arc->plane == Plane::xy   ? "xy"
            : arc->plane == Plane::zx ? "zx"
                                      : "yz")
        << " about " << text_of(arc->centre_mm) << " to " << text_of(arc->end_mm) << " turns "
        << arc->turns;
  } else if (const auto* nurbs = std::get_if<NurbsMove>(&move.shape)) {
    out << "nurbs of degree " << nurbs->degree << " points";
    for (const NurbsPoint& point : nurbs->points) {
      out << " (" << text_of(point.position_mm) << " w " << point.weight << ")";
    }
    out << " knots";
    for (const double knot : nurbs->knots) {
      out << ' ' << knot;
    }
  } else if (const auto* dwell = std::get_if<DwellMove>(&move.shape)) {
    out << "dwell " << dwell->duration_s;
  } else {
    static constexpr std::array kNames = {"program stop",
                                          "optional stop",
                                          "program end",
                                          "spindle cw",
                                          "spindle ccw",
                                          "spindle off",
                                          "tool",
                                          "mist on",
                                          "flood on",
                                          "coolant off",
                                          "pallet",
                                          "tool number",
                                          "orient",
                                          "digital",
                                          "analog",
                                          "digital at motion",
                                          "analog at motion",
                                          "speed override",
                                          "adaptive feed",
                                          "feed stop",
                                          "probe",
                                          "question"};
    static_assert(kNames.size() == static_cast<std::size_t>(EventKind::ask_machine) + 1);
    const auto& event = std::get<EventMove>(move.shape);
    out << kNames[static_cast<int>(event.kind)] << ' ';
    if (event.kind >= EventKind::digital_output && event.kind <= EventKind::analog_at_motion) {
      out << event.index << " = ";
    }
    out << event.value;
    return out.str();
  }
  if (!move.rapid && !std::holds_alternative<DwellMove>(move.shape)) {
    out << " feed " << move.feedrate_mm_s;
  }
  if (move.mode == PathMode::exact_stop) {
    out << " exact stop";
  } else if (move.mode == PathMode::blend) {
    out << " blend " << move.blend_tolerance_mm << " merge " << move.merge_tolerance_mm;
  }
  return out.str();
}

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace kerf::parser
