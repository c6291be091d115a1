// Turns programmed moves into the path that is run.
#pragma once

#include <deque>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "parser/moves/move.hpp"
#include "smoothing/blender.hpp"
#include "smoothing/compressor.hpp"
#include "smoothing/curvature_jumps.hpp"
#include "smoothing/output_changes.hpp"
#include "smoothing/path_deviations.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// Moves go in. Path segments come out in the same order, and with them the moves that are a dwell
// or an event. In G61.1 each move is a segment, in G61 but for short lines that go on straight. In
// G64 runs of short lines are merged within Q and corners are blended within P.
class Smoother {
 public:
  using Output = std::variant<parser::Move, PathSegment>;

  explicit Smoother(const BlendSettings& settings)
      : settings_(settings), compressor_(settings.travel), blender_(settings) {}

  // Error: the curve is not valid, and the move is left out.
  tl::expected<void, PathError> push(const parser::Move& move);
  // Releases all that is held back: the path ends where the program does so far. An output that
  // comes with motion waits for that.
  void flush();
  // What is pushed from now on is neither merged nor blended with another block of the program.
  void keep_blocks_apart(bool on) noexcept {
    keeps_blocks_apart_ = on;
    blender_.keep_blocks_apart(on);
  }
  // In G61 each line pushed from now on is a segment.
  void keep_exact_lines_apart(bool on) noexcept { keeps_exact_lines_apart_ = on; }
  // False: push more moves, or flush.
  bool next(Output& output);

  // Of all segments that have come out.
  [[nodiscard]] PathDeviations deviations() const noexcept;

 private:
  [[nodiscard]] bool merges(const parser::Move& move) const;
  void queue_made();
  // Of the changes since the last move those that do not wait for motion.
  void queue_changes_before(const parser::Move& rest);
  void queue_changes_at_end();
  // The changes since the last move, with this one.
  void come_with(const parser::Move& move);
  // Of a NURBS in G64: takes jumps of the curvature out of what was made of it.
  void smooth_jumps(const parser::Move& move);
  void fit_lines(const SampledCurve& lines, const parser::Move& move,
                 const curves::Position& begin_mm);
  // Corners are blended as their segments are taken: a long run of lines comes at once, and the
  // look-ahead wants a part of it at a time.
  void blend_next();

  BlendSettings settings_;
  Compressor compressor_;
  Blender blender_;
  bool keeps_blocks_apart_ = false;
  bool keeps_exact_lines_apart_ = false;
  std::vector<PathSegment> made_;  // of one move
  struct EndOfPath {};             // for now
  std::deque<std::variant<PathSegment, parser::Move, EndOfPath>> queue_;
  std::vector<PathSegment> blended_;        // of one step
  std::vector<PathSegment> cut_;            // the same, in parts
  std::vector<parser::EventMove> changes_;  // since the last move
  parser::Move last_change_;                // of these
  OutputChanges output_changes_;
  std::vector<Output> outputs_;
  std::size_t taken_ = 0;
};

}  // namespace kerf::smoothing
