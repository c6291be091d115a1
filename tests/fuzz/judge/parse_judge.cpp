#include <cmath>
#include <cstddef>
#include <string_view>

#include "parser/program_reader.hpp"
#include "tests/fuzz/judge/judge.hpp"
#include "tests/fuzz/judge/verdict.hpp"

namespace kerf::fuzz {
namespace {

using namespace kerf::parser;

bool is_sane(const Point& point) {
  constexpr double kLimit_mm = 1e7;
  return std::fabs(point[0]) <= kLimit_mm && std::fabs(point[1]) <= kLimit_mm &&
         std::fabs(point[2]) <= kLimit_mm;
}

void check(const NurbsMove& curve) {
  require(curve.degree >= 1 && curve.degree <= 9, "a curve has a degree");
  require(curve.knots.size() == curve.points.size() + static_cast<std::size_t>(curve.degree) + 1,
          "a curve has its knots");
  require(curve.point_lines.size() == curve.points.size(), "each point has a line");
  require(curve.knot_lines.size() == curve.knots.size(), "each knot has a line");
  for (const NurbsPoint& point : curve.points) {
    require(is_sane(point.position_mm) && point.weight > 0.0 && std::isfinite(point.weight),
            "a point of a curve is one");
  }
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    require(curve.knots[i] >= curve.knots[i - 1], "knots do not decrease");
  }
}

void check(const ArcMove& arc) {
  require(is_sane(arc.end_mm) && std::isfinite(arc.centre_mm[0] + arc.centre_mm[1]),
          "an arc is finite");
  require(arc.turns >= 1, "an arc turns");
}

void check(const Move& move) {
  require(move.source.line >= 1 && move.source.column >= 1, "a move has a place");
  require(is_sane(move.start_mm), "a move starts somewhere");
  for (std::size_t axis = 0; axis < kAuxiliaryAxes; ++axis) {
    require(std::fabs(move.auxiliary.end_rad_mm[axis]) <= 1e6, "a further axis is near");
  }
  require(std::isfinite(move.feedrate_mm_s) && move.feedrate_mm_s >= 0.0, "a feedrate is one");
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    require(is_sane(line->end_mm) && (line->end_mm != move.start_mm || move.auxiliary.moves()),
            "a line moves");
    require(move.rapid || move.feedrate_mm_s > 0.0, "a feed has a feedrate");
  } else if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    check(*arc);
  } else if (const auto* curve = std::get_if<NurbsMove>(&move.shape)) {
    check(*curve);
  } else if (const auto* dwell = std::get_if<DwellMove>(&move.shape)) {
    require(dwell->duration_s >= 0.0 && std::isfinite(dwell->duration_s), "a dwell lasts");
  }
}

void follow(const Move& move, EndPoint& end) {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    end.mm = line->end_mm;
  } else if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    end.mm = arc->end_mm;
  } else if (const auto* curve = std::get_if<NurbsMove>(&move.shape)) {
    end.mm = curve->points.back().position_mm;
  }
  end.extra_rad_mm = move.auxiliary.end_rad_mm;
}

// A program may move for ever; this many moves are looked at.
constexpr int kMoves = 3000;

// Takes the moves that are there. False where there were too many.
bool fetch(ProgramReader& reader, int& moves, EndPoint& end) {
  Move move;
  while (moves < kMoves && reader.next(move)) {
    check(move);
    follow(move, end);
    ++moves;
  }
  return moves < kMoves;
}

}  // namespace

std::optional<EndPoint> judge_reading(const FuzzInput& input) {
  const std::string_view text = input.text;
  ProgramReader reader(input.reader);
  int moves = 0;
  EndPoint end;
  for (std::size_t at = 0; at < text.size(); at += input.piece) {
    reader.feed(text.substr(at, input.piece));
    if (!fetch(reader, moves, end)) {
      return std::nullopt;
    }
  }
  reader.finish();
  if (!fetch(reader, moves, end)) {
    return std::nullopt;
  }
  require(reader.at_end(), "a reader without text is at its end");
  for (const diagnostics::Diagnostic& diagnostic : reader.diagnostics()) {
    require(diagnostic.source.line >= 1 && diagnostic.source.column >= 1,
            "a diagnostic has a place");
    require(!diagnostic.message.empty(), "a diagnostic says something");
  }
  return reader.has_errors() ? std::nullopt : std::optional(end);
}

}  // namespace kerf::fuzz
