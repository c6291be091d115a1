#include "lookahead/optimum/grid/waiting_cells.hpp"

#include <algorithm>
#include <vector>

#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/optimum/grid/independent_line.hpp"

namespace kerf::lookahead {

namespace {

// Nothing jumps at a smooth junction, and beside a rest the cells are refined afterwards.
std::optional<JunctionLimits> limits_at(const CellJunction& junction) {
  if (junction.is_stop() || junction.smooth) {
    return std::nullopt;
  }
  return junction.limits;
}

// Of the way from a motion to a cell, how long the cell may be.
constexpr double kOfWay = 0.05;
constexpr double kCellsOfRise = 300.0;

// A little more than an S-curve takes between rest and the feedrate at the cell's begin.
double ramp_mm(const Cell& cell, const PlanLimits& limits) {
  const double v = std::min(cell.begin.feedrate_mm_s, limits.path.velocity_mm_s);
  const double a = tangential_acceleration_mm_s2(cell, cell.begin, limits);
  const double j = tangential_jerk_mm_s3(cell, cell.begin, limits);
  return v * v / a + v * a / j;
}

// Of a cell so far behind the begin.
double longest_mm(const WaitingCells::BeginCells& order, double way_mm) {
  const bool rises = way_mm < order.rise_mm && order.rise_mm > order.finest_mm;
  return rises ? std::min(order.finest_mm, order.rise_mm / kCellsOfRise)
               : std::max(order.finest_mm, kOfWay * way_mm);
}

}  // namespace

PathAt WaitingCells::path_of(const Window<Block>& blocks) const {
  return [this, &blocks](const Cell& cell, double s_mm) {
    return BlockPath(block_of(cell, blocks), limits_).at(s_mm);
  };
}

void WaitingCells::push(const Window<Block>& blocks) {
  const std::uint64_t number = pushed_++;
  if (!open_) {
    open_ = OpenBlock{.number = number, .whole_line = true};
    lines_ = number;
    ahead_.clear();
    return;
  }
  if (!open_->whole_line) {
    push_cells(number, blocks);
    return;
  }
  const JunctionQuery query{.before = &numbered(open_->number, blocks), .after = &blocks.back()};
  LineEnd end{.junction = junction_of(query, limits_)};
  const bool rests = end.junction.feedrate_mm_s == 0.0;
  end.is_cruise = rests || passed_as_cruise(query, end.junction.feedrate_mm_s, limits_);
  ahead_.push(*query.before, open_->line_begin.feedrate_mm_s);
  if (!(rests || ahead_.are_long_enough()) || !close_as_line(end, blocks)) {
    make_cells_of_lines(blocks);
    return;
  }
  open_ = OpenBlock{.number = number,
                    .whole_line = true,
                    .begins_as_cruise = end.is_cruise,
                    .line_begin = end.junction};
  if (rests) {
    lines_ = number;
    ahead_.clear();
  }
}

// Where only its cells stop at its begin, the last block stands after a rest once the lines before
// it are cells, and may be a line by itself.
void WaitingCells::close(const Window<Block>& blocks) {
  while (open_ && open_->whole_line) {
    if (close_as_line({}, blocks)) {
      open_.reset();
    } else {
      make_cells_of_lines(blocks);
    }
  }
  if (open_) {
    close_as_cells({}, blocks);
    open_.reset();
  }
}

bool WaitingCells::close_as_line(const LineEnd& end, const Window<Block>& blocks) {
  const Block& block = numbered(open_->number, blocks);
  if (!is_independent_line(block, {.begin = open_->line_begin,
                                   .end = end.junction,
                                   .are_cruises = open_->begins_as_cruise && end.is_cruise})) {
    return false;
  }
  cells_.push_back({.cell = {.block = open_->number,
                             .length_mm = block.length_mm,
                             .ends_block = true,
                             .rest_after = end.junction.feedrate_mm_s == 0.0},
                    .whole_line = true});
  return true;
}

void WaitingCells::make_cells_of_lines(const Window<Block>& blocks) {
  cells_.erase(cells_.end() - static_cast<std::ptrdiff_t>(open_->number - lines_), cells_.end());
  open_.reset();
  for (std::uint64_t number = lines_; number < pushed_; ++number) {
    push_cells(number, blocks);
  }
}

void WaitingCells::push_cells(std::uint64_t number, const Window<Block>& blocks,
                              double passed_mm_s) {
  OpenBlock next{.number = number};  // after a stop
  const Block& after = numbered(number, blocks);
  next.own = end_feeds_of(BlockPath(after, limits_), limits_);
  if (open_) {
    const Block& before = numbered(open_->number, blocks);
    const JunctionQuery query{.before = &before, .after = &after};
    next.begin = cell_junction_of(query, limits_);
    if (next.begin.is_stop() && passed_mm_s > 0.0) {
      next.begin = passed_junction_of(query, passed_mm_s, limits_);
    }
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
    } else if (number + 1 == pushed_) {
      next.whole_line = true;
      lines_ = number;
      ahead_.clear();
    }
    close_as_cells(end, blocks);
  }
  open_ = next;
}

void WaitingCells::close_as_cells(const BlockJunction& end, const Window<Block>& blocks) {
  const OpenBlock& open = *open_;
  const Block& block = numbered(open.number, blocks);
  const bool from_rest = open.begin.is_stop();
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

void WaitingCells::begin_at(const Place& place, const Window<Block>& blocks) {
  const auto first = std::ranges::find_if(cells_, [&place](const WaitingCell& waiting) {
    return waiting.cell.block > place.block ||
           (waiting.cell.block == place.block && waiting.cell.s_end_mm() > place.s_mm);
  });
  cells_.erase(cells_.begin(), first);
  if (!cells_.empty() && cells_.front().cell.block == place.block &&
      cells_.front().cell.s_begin_mm < place.s_mm) {
    Cell& cell = cells_.front().cell;
    const double way_mm = place.s_mm - cell.s_begin_mm;
    cell = parts_of(cell, {way_mm, cell.length_mm - way_mm}, path_of(blocks)).back();
  }
}

void WaitingCells::refine_begin(const BeginCells& order, const Window<Block>& blocks) {
  const PathAt path = path_of(blocks);
  std::deque<WaitingCell> refined;
  double way_mm = 0.0;
  for (const WaitingCell& waiting : cells_) {
    const Cell& cell = waiting.cell;
    if (waiting.whole_line || way_mm > ramp_mm(cell, limits_)) {
      refined.push_back(waiting);
      way_mm = kUnbounded;
      continue;
    }
    std::vector<double> lengths;
    double left_mm = cell.length_mm;
    while (left_mm > 0.0) {
      const double part_mm = way_mm > ramp_mm(cell, limits_) ? left_mm : longest_mm(order, way_mm);
      lengths.push_back(left_mm < 1.5 * part_mm ? left_mm : part_mm);
      left_mm -= lengths.back();
      way_mm += lengths.back();
    }
    for (const Cell& part : parts_of(cell, lengths, path)) {
      refined.push_back({.cell = part});
    }
  }
  cells_ = std::move(refined);
}

FrontBlocks WaitingCells::blocks_of_first(std::size_t count) const {
  FrontBlocks front;
  bool ends_block = false;
  while (front.cells < cells_.size() && (front.cells < count || !ends_block)) {
    ends_block = cells_[front.cells].cell.ends_block;
    front.blocks += ends_block ? 1 : 0;
    ++front.cells;
  }
  return front;
}

void WaitingCells::drop_blocks(std::size_t count) {
  const auto kept = std::ranges::find_if(
      cells_, [&](const WaitingCell& waiting) { return waiting.cell.block >= done_ + count; });
  cells_.erase(cells_.begin(), kept);
}

void WaitingCells::drop(std::size_t count) {
  cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace kerf::lookahead
