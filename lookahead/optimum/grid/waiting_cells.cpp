#include "lookahead/optimum/grid/waiting_cells.hpp"

#include <algorithm>
#include <vector>

#include "lookahead/optimum/grid/grid.hpp"

namespace kerf::lookahead {

namespace {

// Nothing jumps at a smooth junction, and beside a rest the cells are refined afterwards.
std::optional<JunctionLimits> limits_at(const CellJunction& junction) {
  if (junction.is_stop() || junction.smooth) {
    return std::nullopt;
  }
  return junction.limits;
}

}  // namespace

PathAt WaitingCells::path_of(const Window<Block>& blocks) const {
  return [this, &blocks](const Cell& cell, double s_mm) {
    return BlockPath(block_of(cell, blocks), limits_).at(s_mm);
  };
}

void WaitingCells::push(const Window<Block>& blocks) {
  const std::uint64_t number = pushed_++;
  OpenBlock next{.number = number};  // behind a stop
  const Block& after = blocks.back();
  next.own = end_feeds_of(BlockPath(after, limits_), limits_);
  if (open_) {
    const Block& before = numbered(open_->number, blocks);
    next.begin = cell_junction_of({.before = &before, .after = &after}, limits_);
    next.v_before_mm_s = open_->own.v_end_mm_s;
    BlockJunction end{.junction = next.begin, .v_beyond_mm_s = next.own.v_begin_mm_s};
    if (!next.begin.is_stop()) {
      const double v = std::min(next.v_before_mm_s, next.own.v_begin_mm_s);
      end.zone = sub_tick_zone(
          {.curve = after, .junction = before.end, .beside = before, .v_junction_mm_s = v},
          limits_);
      next.begin_zone = sub_tick_zone(
          {.curve = before, .junction = after.begin, .beside = after, .v_junction_mm_s = v},
          limits_);
    }
    close(end, blocks);
  }
  open_ = next;
}

void WaitingCells::close(const Window<Block>& blocks) {
  if (open_) {
    close({}, blocks);
  }
}

void WaitingCells::close(const BlockJunction& end, const Window<Block>& blocks) {
  const OpenBlock open = *open_;
  open_.reset();
  const Block& block = numbered(open.number, blocks);
  const bool from_rest = open.begin.is_stop();
  if (std::holds_alternative<curves::Line>(block.curve) && from_rest && end.junction.is_stop()) {
    cells_.push_back(
        {.cell = {.block = open.number, .length_mm = block.length_mm, .rest_after = true},
         .alone = true});
    return;
  }
  std::vector<Cell> cells =
      grid_of(BlockPath(block, limits_),
              {.begin = limits_at(open.begin),
               .end = limits_at(end.junction),
               .beyond = {.v_begin_mm_s = from_rest ? kUnbounded : open.v_before_mm_s,
                          .v_end_mm_s = end.junction.is_stop() ? kUnbounded : end.v_beyond_mm_s},
               .zones = {.begin = open.begin_zone, .end = end.zone}},
              limits_);
  for (Cell& cell : cells) {
    cell.block = open.number;
    cells_.push_back({.cell = cell});
  }
  cells_.back().cell.rest_after |= end.junction.is_stop();
}

void WaitingCells::clear() {
  open_.reset();
  cells_.clear();
}

void WaitingCells::drop(std::size_t count) {
  cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace kerf::lookahead
