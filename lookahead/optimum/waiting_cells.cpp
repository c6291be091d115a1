#include "lookahead/optimum/waiting_cells.hpp"

#include <vector>

#include "lookahead/optimum/grid.hpp"

namespace kerf::lookahead {

namespace {

// Nothing jumps at a smooth joint, and beside a rest the cells are refined afterwards.
std::optional<Passage> passage_at(const Joint& joint) {
  if (joint.is_stop() || joint.smooth) {
    return std::nullopt;
  }
  return joint.passing;
}

}  // namespace

PathAt WaitingCells::path_of(const Window<Block>& blocks) const {
  return [this, &blocks](const Cell& cell, double s_mm) {
    return BlockPath(block_of(cell, blocks), limits_).at(s_mm);
  };
}

void WaitingCells::push(const Window<Block>& blocks) {
  const std::uint64_t number = pushed_++;
  Joint begin{};  // a stop
  const EndFeeds own = end_feeds_of(BlockPath(blocks.back(), limits_), limits_);
  double v_before = kUnbounded;
  if (open_) {
    v_before = open_->own.v_end_mm_s;
    begin =
        joint_of({.before = &numbered(open_->number, blocks), .after = &blocks.back()}, limits_);
    close(begin, own.v_begin_mm_s, blocks);
  }
  open_ = OpenBlock{.number = number, .begin = begin, .own = own, .v_before_mm_s = v_before};
}

void WaitingCells::close(const Window<Block>& blocks) {
  if (open_) {
    close({}, kUnbounded, blocks);
  }
}

void WaitingCells::close(const Joint& end, double v_beyond_mm_s, const Window<Block>& blocks) {
  const OpenBlock open = *open_;
  open_.reset();
  const Block& block = numbered(open.number, blocks);
  const bool from_rest = open.begin.is_stop();
  if (std::holds_alternative<curves::Line>(block.curve) && from_rest && end.is_stop()) {
    cells_.push_back(
        {.cell = {.block = open.number, .length_mm = block.length_mm, .rest_after = true},
         .alone = true});
    return;
  }
  std::vector<Cell> cells =
      grid_of(BlockPath(block, limits_),
              {.begin = passage_at(open.begin),
               .end = passage_at(end),
               .beyond = {.v_begin_mm_s = from_rest ? kUnbounded : open.v_before_mm_s,
                          .v_end_mm_s = end.is_stop() ? kUnbounded : v_beyond_mm_s}},
              limits_);
  for (Cell& cell : cells) {
    cell.block = open.number;
    cells_.push_back({.cell = cell});
  }
  cells_.back().cell.rest_after |= end.is_stop();
}

void WaitingCells::clear() {
  open_.reset();
  cells_.clear();
}

void WaitingCells::drop(std::size_t count) {
  cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace kerf::lookahead
