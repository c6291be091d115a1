#include "lookahead/optimum/begin_in_motion.hpp"

#include <algorithm>
#include <iterator>

#include "lookahead/optimum/grid/speed_estimate.hpp"

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

// Until the acceleration is 0, at the limit of jerk.
double rise_mm(const StartState& state, const Cell& first, const PlanLimits& limits) {
  const double a = std::max(state.a_mm_s2, 0.0);
  const double t_s = a / tangential_jerk_mm_s3(first, first.begin, limits);
  return t_s * (state.v_mm_s + a * t_s / 3.0);
}

}  // namespace

std::size_t prepare_to_begin(const BeginInMotion& from, const PlanLimits& limits,
                             WaitingCells& waiting, Window<Block>& blocks) {
  waiting.begin_at({.block = from.has_before ? 1U : 0U, .s_mm = from.s_mm}, blocks);
  if (from.has_before) {
    blocks.pop_front();
    waiting.block_done();
  }
  if (waiting.empty()) {
    return 0;
  }
  waiting.refine_begin({.finest_mm = from.to_rest.back().way_mm / kCellsToRest,
                        .rise_mm = rise_mm(from.state, waiting[0], limits)},
                       blocks);
  if (waiting.size() < kMinCells) {
    return 0;
  }
  const std::size_t count = std::min(waiting.size(), kMaxCellsInMotion);
  plan_way_to_rest(from.to_rest, count, waiting);
  return count;
}

}  // namespace kerf::lookahead
