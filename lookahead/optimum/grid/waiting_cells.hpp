// Blocks as cells that wait for a plan of the time optimum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/grid/cell_stops.hpp"
#include "lookahead/optimum/grid/independent_line.hpp"
#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"
#include "lookahead/path/junction.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

struct WaitingCell {
  Cell cell{};
  bool whole_line = false;  // a line that needs no cells (independent_line.hpp)
};

// Blocks at the front, and their cells.
struct FrontBlocks {
  std::size_t blocks = 0;
  std::size_t cells = 0;
};

// A block becomes cells once the junctions at both its ends are known: when the next one comes, or
// when none does. From a rest on, lines that can be planned each by itself wait as they are; the
// first block that cannot makes cells of them and of all that follows up to the next rest.
class WaitingCells {
 public:
  // lines_ahead: what LinesAhead looks at.
  explicit WaitingCells(const PlanLimits& limits, std::size_t lines_ahead = 500)
      : limits_(limits), ahead_(lines_ahead) {}

  // The window's last block.
  void push(const Window<Block>& blocks);
  // The same, as cells though it may be an independent line, even after a rest: the motion may be
  // on it already. passed_mm_s: at which it has just passed the junction before; 0: it has not.
  void push_as_cells(const Window<Block>& blocks, double passed_mm_s = 0.0) {
    const std::uint64_t number = pushed_++;
    push_cells(number, blocks, passed_mm_s);
    open_->whole_line = false;
  }
  // The last block that was pushed ends at rest.
  void close_as_cells(const Window<Block>& blocks) { close_as_cells({}, blocks); }
  void close(const Window<Block>& blocks);
  // The window's first block has left.
  void block_done() { ++done_; }
  // The last block that was pushed is planned elsewhere, or the next one is.
  void drop_open() { open_.reset(); }
  void skip_next() { ++pushed_; }

  // The cells before that place are dropped.
  struct Place {
    std::uint64_t block = 0;  // counted from the first that was pushed
    double s_mm = 0.0;
  };
  void begin_at(const Place& place, const Window<Block>& blocks);
  // Divides the first cells: no longer than finest_mm, and than a small part of the way up to them
  // where that is more, until the motion may have come to its feedrate from any other. Over rise_mm
  // the jerk is to be all but constant, while that of a cell goes with the feedrate: there are
  // more.
  struct BeginCells {
    double finest_mm = 0.0;
    double rise_mm = 0.0;
  };
  void refine_begin(const BeginCells& order, const Window<Block>& blocks);
  void plan_at(std::size_t i, double planned_squared) {
    cells_[i].cell.planned_squared = planned_squared;
  }

  [[nodiscard]] bool has_open_block() const { return open_.has_value(); }
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] const WaitingCell& front() const { return cells_.front(); }
  [[nodiscard]] const Cell& operator[](std::size_t i) const { return cells_[i].cell; }
  // Up to the end of the block that holds the last of the first cells. Precondition: count > 0.
  [[nodiscard]] FrontBlocks blocks_of_first(std::size_t count) const;
  void drop(std::size_t count);
  // All cells of the window's first blocks.
  void drop_blocks(std::size_t count);
  void rest_after(std::size_t i) { cells_[i].cell.rest_after = true; }
  void go_on_after(std::size_t i) { cells_[i].cell.rest_after = false; }

  // For waiting cells and for those of a plan.
  [[nodiscard]] const Block& block_of(const Cell& cell, const Window<Block>& blocks) const {
    return numbered(cell.block, blocks);
  }
  [[nodiscard]] PathAt path_of(const Window<Block>& blocks) const;

 private:
  // A block that is not on the grid yet, and the junction at its beginning.
  struct OpenBlock {
    std::uint64_t number = 0;
    bool whole_line = false;       // may be one: no cells yet between it and the last rest
    bool begins_as_cruise = true;  // from rest, or passed_as_cruise
    Junction line_begin{.feedrate_mm_s = 0.0};
    CellJunction begin{};
    EndFeeds own{};                     // end_feeds_of
    double v_before_mm_s = kUnbounded;  // end_feeds_of, at the end of the block before
    SubTickZone begin_zone{};
  };

  [[nodiscard]] const Block& numbered(std::uint64_t number, const Window<Block>& blocks) const {
    return blocks[number - done_];
  }
  // The end of the open block.
  struct BlockJunction {
    CellJunction junction{};
    double v_beyond_mm_s = kUnbounded;
    SubTickZone zone{};
  };
  struct LineEnd {
    Junction junction{.feedrate_mm_s = 0.0};
    bool is_cruise = true;  // a rest, or passed_as_cruise
  };
  // Whether the open block, ending so, is a whole line; then it waits as one.
  bool close_as_line(const LineEnd& end, const Window<Block>& blocks);
  // The lines since the last rest and the blocks after them, up to the last one pushed.
  void make_cells_of_lines(const Window<Block>& blocks);
  void push_cells(std::uint64_t number, const Window<Block>& blocks, double passed_mm_s = 0.0);
  void close_as_cells(const BlockJunction& end, const Window<Block>& blocks);

  PlanLimits limits_;
  std::uint64_t pushed_ = 0;
  std::uint64_t done_ = 0;  // blocks that have left the window
  std::uint64_t lines_ =
      0;              // the first block since the last rest, while whole lines are all there is
  LinesAhead ahead_;  // the last of those
  std::optional<OpenBlock> open_;
  std::deque<WaitingCell> cells_;
};

}  // namespace kerf::lookahead
