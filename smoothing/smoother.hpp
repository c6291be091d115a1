// Programmed moves to the path that is run: what stands between the parser and the look-ahead.
#pragma once

#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "parser/moves/move.hpp"
#include "smoothing/blender.hpp"
#include "smoothing/compressor.hpp"
#include "smoothing/path_deviations.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// Moves go in; in the same order come out the segments of the path, and the moves that are a dwell
// or an event. In G61 and G61.1 a segment is a move; in G64 runs of short lines are merged within Q
// and corners blended within P.
class Smoother {
 public:
  using Output = std::variant<parser::Move, PathSegment>;

  explicit Smoother(const BlendSettings& settings)
      : compressor_(settings.travel), blender_(settings) {}

  // Error: the curve is not valid; nothing of the move is taken.
  tl::expected<void, PathError> push(const parser::Move& move);
  // Everything that is held back comes out; the path ends where the program's does so far.
  void flush();
  // False: more moves have to come, or a flush.
  bool next(Output& output);

  // Of all that came out.
  [[nodiscard]] PathDeviations deviations() const noexcept;

 private:
  void blend_made();
  void queue_segments();

  Compressor compressor_;
  Blender blender_;
  std::vector<PathSegment> made_;     // of one move
  std::vector<PathSegment> blended_;  // of one push
  std::vector<parser::EventMove> changes_;
  std::vector<Output> outputs_;
  std::size_t taken_ = 0;
};

}  // namespace kerf::smoothing
