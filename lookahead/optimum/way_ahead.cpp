#include "lookahead/optimum/way_ahead.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/path/remainder.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kShortest_mm = 1e-9;
// How far blocks are looked at, over what steady braking takes from the highest feedrate to come:
// where the motion accelerates, half of the weakest jerk ends that.
constexpr double kFarthest = 4.0;
constexpr double kMinFar_mm = 1.0;
// A curve so many times as long as what is looked at of it.
constexpr double kWorthCutting = 1.5;

constexpr std::size_t kManyBlocks = 256;

struct Reach {
  double farthest_mm = 0.0;
  double gentle_mm = 0.0;  // of an S-curve at half of the weakest limits
};

Reach reach_of(const BrakingFrom& from, const PlanLimits& limits) {
  profiles::RampLimits weakest = from.blocks.front()->along.ramp;
  for (const MotionLimits& axis : limits.axes) {
    weakest.acceleration_mm_s2 = std::min(weakest.acceleration_mm_s2, axis.acceleration_mm_s2);
    weakest.jerk_mm_s3 = std::min(weakest.jerk_mm_s3, axis.jerk_mm_s3);
  }
  const double a = std::max(from.state.a_mm_s2, 0.0);
  const double v = from.state.v_mm_s + a * a / weakest.jerk_mm_s3;
  const double steady_mm = v * v / weakest.acceleration_mm_s2;
  return {
      .farthest_mm = kMinFar_mm + kFarthest * steady_mm,
      .gentle_mm = kMinFar_mm + steady_mm + v * weakest.acceleration_mm_s2 / weakest.jerk_mm_s3};
}

// A block of which only a stretch is looked at: a curve may be long. begin_mm: of the stretch, on
// the block.
struct NearBlock {
  Block block;
  double begin_mm = 0.0;
  bool ends_block = true;  // the stretch does
};

NearBlock near_block(const Block& block, const curves::Stretch& near) {
  const curves::Stretch stretch{.begin_mm = std::max(near.begin_mm, 0.0),
                                .end_mm = std::min(near.end_mm, block.length_mm)};
  if (std::holds_alternative<curves::NurbsCurve>(block.curve) &&
      kWorthCutting * (stretch.end_mm - stretch.begin_mm) < block.length_mm) {
    if (auto cut = stretch_of(block, stretch)) {
      return {.block = std::move(*cut),
              .begin_mm = stretch.begin_mm,
              .ends_block = stretch.end_mm == block.length_mm};
    }
  }
  return {.block = block};
}

}  // namespace

WayAhead::WayAhead(const BrakingFrom& from, const PlanLimits& limits)
    : limits_(limits), waiting_(limits) {
  take_blocks(from);
  take_cells(from);
}

std::optional<WayAhead::Place> WayAhead::place_at(const Sought& sought) const {
  std::size_t i = sought.from;
  while (i + 1 < cells_.size() && ways_mm_[i] < sought.way_mm) {
    ++i;
  }
  if (i + 1 >= cells_.size() && sought.way_mm > ways_mm_.back() - kAtBlockEnd_mm) {
    return std::nullopt;
  }
  return Place{.cell = i, .s_mm = cells_[i].s_end_mm() - (ways_mm_[i] - sought.way_mm)};
}

bool WayAhead::knows(double distance_mm) const {
  return !has_more_blocks_ || (!cells_.empty() && distance_mm < ways_mm_.back());
}

void WayAhead::take_blocks(const BrakingFrom& from) {
  const double back_mm = junction_zone_mm(from.state, limits_);
  const auto [far_mm, gentle_mm] = reach_of(from, limits_);
  const auto add = [this](Block block, double passed_mm_s = 0.0) {
    blocks_.push_back(std::move(block));
    waiting_.push_as_cells(blocks_, passed_mm_s);
  };
  double way_mm = -from.s_mm;
  double passed_mm_s = 0.0;
  for (std::size_t i = 0; i < from.blocks.size() && way_mm < far_mm && !last_is_cut_; ++i) {
    if (i > kMaxBlocks || (i > kManyBlocks && way_mm > gentle_mm)) {
      has_more_blocks_ = true;
      break;
    }
    const Block& block = *from.blocks[i];
    NearBlock near = near_block(
        block, {.begin_mm = i == 0 ? from.s_mm - back_mm : 0.0, .end_mm = far_mm - way_mm});
    if (i == 0) {
      first_begin_mm_ = near.begin_mm;
    }
    if (i == 0 && from.before != nullptr && near.begin_mm == 0.0) {
      const Block& before = *from.before;
      add(near_block(before, {.begin_mm = before.length_mm - back_mm, .end_mm = before.length_mm})
              .block);
      first_ = 1;
      passed_mm_s = from.state.v_mm_s;
    }
    add(std::move(near.block), std::exchange(passed_mm_s, 0.0));
    last_is_cut_ = !near.ends_block;
    way_mm += block.length_mm;
  }
  waiting_.close_as_cells(blocks_);
}

// From the motion on, up to a rest or the end of what is known.
void WayAhead::take_cells(const BrakingFrom& from) {
  const PathAt path = this->path();
  const double s_mm = from.s_mm - first_begin_mm_;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    Cell cell = waiting_[i];
    const bool is_first = cell.block == first_;
    if (cell.block < first_ || (is_first && cell.s_end_mm() <= s_mm)) {
      continue;
    }
    if (is_first && cell.s_begin_mm < s_mm) {
      const double way = s_mm - cell.s_begin_mm;
      cell = parts_of(cell, {way, cell.length_mm - way}, path).back();
    }
    cells_.push_back(cell);
    if (cell.rest_after) {
      has_more_blocks_ = has_more_blocks_ && i + 1 == waiting_.size();
      break;
    }
  }
  cut_at_ends(from, path);
  if (last_is_cut_ && !cells_.empty() && cells_.back().block + 1 == blocks_.size()) {
    cells_.back().ends_block = false;
  }
  double way_mm = 0.0;
  for (const Cell& cell : cells_) {
    ways_mm_.push_back(way_mm += cell.length_mm);
  }
}

void WayAhead::cut_at_ends(const BrakingFrom& from, const PathAt& path) {
  std::vector<Cell> cut;
  auto end = from.ends.begin();
  for (Cell cell : cells_) {
    const std::size_t block = block_of(cell);
    const double begin_mm = this->begin_mm(block);
    for (; end != from.ends.end() &&
           (end->block < block ||
            (end->block == block && end->s_mm - begin_mm < cell.s_end_mm() - kShortest_mm));
         ++end) {
      const double way = end->s_mm - begin_mm - cell.s_begin_mm;
      if (end->block == block && way > kShortest_mm) {
        const std::vector<Cell> halves = parts_of(cell, {way, cell.length_mm - way}, path);
        cut.push_back(halves.front());
        cell = halves.back();
      }
    }
    cut.push_back(cell);
  }
  cells_ = std::move(cut);
}

}  // namespace kerf::lookahead
