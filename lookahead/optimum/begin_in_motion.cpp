#include "lookahead/optimum/begin_in_motion.hpp"

#include <algorithm>
#include <iterator>

namespace kerf::lookahead {

namespace {

constexpr std::size_t kMinCells = 3;
// On the way that it would take to rest.
constexpr double kCellsToRest = 40.0;

void plan_way_to_rest(const std::vector<BeginInMotion::Feed>& to_rest, std::size_t count,
                      WaitingCells& waiting) {
  double way_mm = 0.0;
  auto after = to_rest.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const double middle_mm = way_mm + 0.5 * waiting[i].length_mm;
    while (after != to_rest.end() && after->way_mm < middle_mm) {
      ++after;
    }
    if (after == to_rest.begin() || after == to_rest.end()) {
      return;
    }
    const BeginInMotion::Feed& before = *std::prev(after);
    const double share = (middle_mm - before.way_mm) / (after->way_mm - before.way_mm);
    const double v = before.v_mm_s + share * (after->v_mm_s - before.v_mm_s);
    waiting.plan_at(i, v * v);
    way_mm += waiting[i].length_mm;
  }
}

}  // namespace

std::size_t prepare_to_begin(const BeginInMotion& from, WaitingCells& waiting,
                             Window<Block>& blocks) {
  waiting.begin_at({.block = from.has_before ? 1U : 0U, .s_mm = from.s_mm}, blocks);
  if (from.has_before) {
    blocks.pop_front();
    waiting.block_done();
  }
  waiting.refine_begin(from.to_rest.back().way_mm / kCellsToRest, blocks);
  if (waiting.size() < kMinCells) {
    return 0;
  }
  const std::size_t count = std::min(waiting.size(), kMaxCellsInMotion);
  plan_way_to_rest(from.to_rest, count, waiting);
  return count;
}

}  // namespace kerf::lookahead
