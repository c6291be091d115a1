// A segment of the path that goes to the look-ahead: one smooth curve and its data from the
// program.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "curves/auxiliary_axis_motion.hpp"
#include "curves/curve.hpp"
#include "parser/moves/move.hpp"

namespace kerf::smoothing {

// From s_mm on, counted on the segment's curve, the motion belongs to this line of the program
// (SourcePosition::program_line).
struct LineMark {
  double s_mm = 0.0;
  std::uint32_t line = 0;
  std::uint64_t run_block = 0;  // parser::Move::block of the line's move
};

// The mark of a place: the last one at or before it; `whole` before the first mark or without
// marks.
inline LineMark mark_at(const std::vector<LineMark>& marks, double s_mm, const LineMark& whole) {
  const auto after = std::ranges::upper_bound(marks, s_mm, {}, &LineMark::s_mm);
  return after == marks.begin() ? whole : *std::prev(after);
}

// Why a move cannot be run.
struct PathError {
  std::uint32_t line = 0;
  std::string message;
};

struct PathSegment {
  curves::Curve curve;
  diagnostics::SourcePosition source{};  // of its first line
  std::uint64_t run_block = 0;           // parser::Move::block of the move that it begins with
  bool rapid = false;
  double feedrate_mm_s = 0.0;  // not used by rapids
  parser::FollowedOverrides follows{};
  curves::AuxiliaryAxisMotion extra{};
  parser::PathMode mode = parser::PathMode::exact_path;
  double corner_tolerance_mm = 0.0;  // for blends of its corners
  // The largest distance from the programmed path. A blend at its end has that much less.
  double deviation_mm = 0.0;
  bool stop_after = false;
  // The normal axis of the arc that it was programmed as. A spiral is a NurbsCurve with one.
  std::optional<int> arc_normal{};
  // Empty: all of it belongs to the line of `source`. Else the first is at 0.
  std::vector<LineMark> marks{};
  // Changes that come with the first tick on it.
  std::vector<parser::EventMove> changes{};
  // Direction and curvature go on from the segment before, by construction.
  bool continues = false;
  // Of the curve in a corner: parser::Move::block of the move after it, which it leads into. 0: it
  // is none.
  std::uint64_t corner_block = 0;

  // parser::Move::block of the first move that begins on it.
  [[nodiscard]] std::uint64_t first_block() const noexcept {
    return corner_block != 0 ? corner_block : run_block;
  }
  [[nodiscard]] LineMark mark_at(double s_mm) const {
    return smoothing::mark_at(marks, s_mm, {.line = source.program_line(), .run_block = run_block});
  }
};

}  // namespace kerf::smoothing
