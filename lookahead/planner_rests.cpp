// Rests, and what is switched between motions.
#include "lookahead/planner.hpp"

namespace kerf::lookahead {

void Planner::push_rest(double duration_s, std::uint32_t line) {
  rest_ = {.duration_s = duration_s, .line = line};
  rest_pending_ = true;
  draining_ = true;
  ready_spans_ = 0;
}

void Planner::push_switch_at_rest(const interp::Switch& change, std::uint32_t line) {
  push_rest(0.0, line);
  rest_.change = change;
}

void Planner::push_switch_at_motion(const interp::Switch& change) {
  switches_.push_back({.block = pushed_blocks_ + 1, .change = change});
}

void Planner::finish(std::uint32_t line) {
  push_rest(0.0, line);
  rest_.ends_program = true;
}

// At the first tick that is on the block, or past it where the block is shorter than a tick.
void Planner::emit_switches(Outbox& outbox) {
  while (!switches_.empty() && switches_.front().block <= totals_.blocks) {
    outbox.switches.push_back({.tick = clock_.next_tick(), .change = switches_.front().change});
    switches_.pop_front();
  }
}

void Planner::emit_rest(Outbox& outbox) {
  interp::Phase phase{.curve = curve_,
                      .begin = clock_.now(),
                      .s_begin_mm = s_mm_,
                      .s_end_mm = s_mm_,
                      .law = profiles::Transition::rest(rest_.duration_s),
                      .line = rest_.line != 0 ? rest_.line : line_,
                      .ends_at_rest = true,
                      .ends_program = rest_.ends_program};
  phase.path_begin_mm = block_begun_ || rests_ ? path_begin_mm_ : path_begin_mm_ - s_mm_;
  if (rest_.change) {
    outbox.switches.push_back({.tick = clock_.now().tick, .change = *rest_.change});
  }
  outbox.phases.push_back(phase);
  clock_.advance(rest_.duration_s);
  clock_.align_to_tick();
  totals_.ticks = clock_.now().tick;
  rest_pending_ = false;
  draining_ = rest_.ends_program;
}

}  // namespace kerf::lookahead
