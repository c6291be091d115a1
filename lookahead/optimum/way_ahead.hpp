// What lies ahead of a motion, as cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "interp/motion.hpp"
#include "lookahead/optimum/braking.hpp"
#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

// From the motion on, up to a rest, or as far as braking may take: over many short blocks as far as
// a gentle S-curve takes, and over kMaxBlocks at the most. Cells end where the plan so far changes
// its jerk (BrakingFrom::ends).
class WayAhead {
 public:
  // A way to rest over more does not fit into what stands ready for a late planner.
  static constexpr std::size_t kMaxBlocks = interp::StopAhead::kPhases;

  WayAhead(const BrakingFrom& from, const PlanLimits& limits);

  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  // A place in a cell; s counts as the cell's does.
  struct Place {
    std::size_t cell = 0;
    double s_mm = 0.0;
  };
  // So far from the motion; nothing: that is at the end of what is known, or after it. There is a
  // cell.
  struct Sought {
    double way_mm = 0.0;
    std::size_t from = 0;  // no cell before this one is looked at
  };
  [[nodiscard]] std::optional<Place> place_at(const Sought& sought) const;
  // From the motion to the end of a cell.
  [[nodiscard]] double way_to_end_mm(std::size_t cell) const { return ways_mm_[cell]; }
  // False: so far it goes on over blocks that were not looked at.
  [[nodiscard]] bool knows(double distance_mm) const;
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
  bool has_more_blocks_ = false;
  std::vector<Cell> cells_;
  std::vector<double> ways_mm_;  // to the end of each
};

}  // namespace kerf::lookahead
