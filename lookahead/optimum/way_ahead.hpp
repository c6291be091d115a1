// What lies ahead of a motion, as cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lookahead/optimum/braking.hpp"
#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

// From the motion on, up to a rest or as far as braking may take. Cells end where the plan so far
// changes its jerk (BrakingFrom::ends).
class WayAhead {
 public:
  WayAhead(const BrakingFrom& from, const PlanLimits& limits);

  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  // The cell that holds a place on the first block; nothing: it lies at the block's end or behind
  // it.
  struct Sought {
    double s_mm = 0.0;
    std::size_t from = 0;  // no cell before this one is looked at
  };
  [[nodiscard]] std::optional<std::size_t> cell_at(const Sought& sought) const;
  [[nodiscard]] PathAt path() const { return waiting_.path_of(blocks_); }
  // Of BrakingFrom::blocks.
  [[nodiscard]] std::size_t block_of(const Cell& cell) const {
    return static_cast<std::size_t>(cell.block - first_);
  }
  // Where on the block its cells count from: of a long curve only a stretch is looked at.
  [[nodiscard]] double begin_mm(std::size_t block) const {
    return block == 0 ? first_begin_mm_ : 0.0;
  }

 private:
  void take_blocks(const BrakingFrom& from);
  void take_cells(const BrakingFrom& from);
  void cut_at_ends(const BrakingFrom& from, const PathAt& path);

  PlanLimits limits_;
  WaitingCells waiting_;
  Window<Block> blocks_;
  std::uint64_t first_ = 0;  // of blocks_: the one that the motion is on
  double first_begin_mm_ = 0.0;
  bool last_is_cut_ = false;
  std::vector<Cell> cells_;
};

}  // namespace kerf::lookahead
