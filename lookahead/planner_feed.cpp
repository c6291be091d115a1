// What the feed stops: at a feed of 0 nothing begins to move that follows it.
#include <cassert>

#include "lookahead/planner.hpp"

namespace kerf::lookahead {

// Within a tap nothing is stopped.
bool Planner::is_stopped_by_feed() const {
  return settings_.may_hold && emitter_.ends_at_rest() && stopped_feed_.stops(blocks_[0].follows) &&
         (blocks_[0].follows.hold || emitter_.kept().ends_following_hold());
}

void Planner::hold_by_feed(Outbox& outbox) {
  const std::size_t first = outbox.phases.size();
  held_by_feed_ = blocks_[0].follows;
  held_ = true;
  empty_window();
  emitter_.emit_rest_here(0, outbox);
  outbox.phases.back().holds = true;
  emitter_.keep(outbox, first);
}

bool Planner::hold_feed(std::int64_t tick, Outbox& outbox) {
  assert(settings_.may_hold && !before_ && outbox.phases.empty());
  const auto stop = find_stop_at(tick);
  if (!stop || !stop->from.phase.follows_hold) {
    return false;
  }
  const bool rests = stop->parts.empty() && stop->from.when.tick <= tick;
  return (!rests || feed_stops_behind(stop->from)) && hold_at(*stop, outbox);
}

bool Planner::feed_stops_behind(const EmittedItems::Motion& rest) const {
  const EmittedItems& kept = emitter_.kept();
  if (kept.is_last(rest)) {
    return false;
  }
  const EmittedItems::Blocks emitted = kept.blocks_from(rest);
  const Block* next = emitted.blocks.empty() ? kept.block_behind(rest) : emitted.blocks.front();
  if (next == nullptr && emitter_.is_on_block() && !blocks_.empty()) {
    next = &blocks_[0];
  }
  return next == nullptr || stopped_feed_.stops(next->follows);
}

}  // namespace kerf::lookahead
