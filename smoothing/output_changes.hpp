// Where on the path outputs change that change with motion (M62, M63, M67).
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// A change comes where the move after it begins, which may be within a run of merged lines or in a
// blended corner. The path is made as if there were none; then its segments are cut at those
// places.
class OutputChanges {
 public:
  // With the first place of this move, by its parser::Move::block. Moves ascend.
  void come_with(std::uint64_t block, std::vector<parser::EventMove> changes);
  // Appends the segment, in parts where a change comes within. Segments in the order of the path.
  void cut(PathSegment segment, std::vector<PathSegment>& out);

 private:
  struct Waiting {
    std::uint64_t block = 0;
    std::vector<parser::EventMove> changes;
  };

  std::deque<Waiting> waiting_;
};

}  // namespace kerf::smoothing
