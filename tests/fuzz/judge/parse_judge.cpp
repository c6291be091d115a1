// Any bytes, cut into any pieces: the parser must not crash, must end, must say where an error is,
// and must hand on only moves that a curve builder can work with.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "parser/program_reader.hpp"

namespace {

using namespace kerf::parser;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

bool is_sane(const Point& point) {
  constexpr double kLimit_mm = 1e7;
  return std::fabs(point[0]) <= kLimit_mm && std::fabs(point[1]) <= kLimit_mm &&
         std::fabs(point[2]) <= kLimit_mm;
}

void check(const NurbsMove& curve) {
  require(curve.degree >= 1 && curve.degree <= 9);
  require(curve.knots.size() == curve.points.size() + static_cast<std::size_t>(curve.degree) + 1);
  require(curve.point_lines.size() == curve.points.size());
  require(curve.knot_lines.size() == curve.knots.size());
  for (const NurbsPoint& point : curve.points) {
    require(is_sane(point.position_mm) && point.weight > 0.0 && std::isfinite(point.weight));
  }
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    require(curve.knots[i] >= curve.knots[i - 1]);
  }
}

void check(const ArcMove& arc) {
  require(is_sane(arc.end_mm) && std::isfinite(arc.centre_mm[0] + arc.centre_mm[1]));
  require(arc.turns >= 1);
}

void check(const Move& move) {
  require(move.source.line >= 1 && move.source.column >= 1);
  require(is_sane(move.start_mm));
  for (std::size_t axis = 0; axis < kExtraAxes; ++axis) {
    require(std::fabs(move.extra.end_rad_mm[axis]) <= 1e6);
  }
  require(std::isfinite(move.feedrate_mm_s) && move.feedrate_mm_s >= 0.0);
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    require(is_sane(line->end_mm) && (line->end_mm != move.start_mm || move.extra.moves()));
    require(move.rapid || move.feedrate_mm_s > 0.0);
  } else if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    check(*arc);
  } else if (const auto* curve = std::get_if<NurbsMove>(&move.shape)) {
    check(*curve);
  } else if (const auto* dwell = std::get_if<DwellMove>(&move.shape)) {
    require(dwell->duration_s >= 0.0 && std::isfinite(dwell->duration_s));
  }
}

ReaderOptions options_of(std::uint8_t bits) {
  ReaderOptions options;
  options.block_delete = (bits & 1) != 0 ? BlockDelete::all() : BlockDelete();
  options.dialect = (bits & 2) != 0 ? Dialect::fanuc : Dialect::rs274;
  options.machine = default_machine_data();
  options.machine.extra_axes = (bits & 4) != 0 ? kExtraLetters : 0;
  options.max_idle_steps = 2000;
  options.subprograms = [](std::string_view name) -> std::optional<SubprogramText> {
    if (name != "ring") {
      return std::nullopt;
    }
    return SubprogramText{"ring.ngc", "o<ring> sub\nG91 G1 X#1 F100\nG90\no<ring> endsub [#1+1]\n"};
  };
  return options;
}

// A program may move for ever; this many moves are looked at.
constexpr int kMoves = 3000;

// False where there were too many moves.
bool fetch(ProgramReader& reader, int& moves) {
  Move move;
  while (moves < kMoves && reader.next(move)) {
    check(move);
    ++moves;
  }
  return moves < kMoves;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) {
    return 0;
  }
  const std::size_t piece = 1 + data[0];
  const std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);
  ProgramReader reader(options_of(data[1]));
  int moves = 0;
  for (std::size_t at = 0; at < text.size(); at += piece) {
    reader.feed(text.substr(at, piece));
    if (!fetch(reader, moves)) {
      return 0;
    }
  }
  reader.finish();
  if (!fetch(reader, moves)) {
    return 0;
  }
  require(reader.at_end());
  for (const Diagnostic& diagnostic : reader.diagnostics()) {
    require(diagnostic.source.line >= 1 && diagnostic.source.column >= 1);
    require(!diagnostic.message.empty());
  }
  return 0;
}
