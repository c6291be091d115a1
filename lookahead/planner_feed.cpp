// What the feed stops: at a feed of 0 what follows it holds, and nothing begins to move.
#include <algorithm>
#include <cassert>
#include <variant>

#include "lookahead/planner.hpp"

namespace kerf::lookahead {

namespace {

parser::FollowedOverrides followed_by(const interp::Phase& phase) {
  return {.feed = phase.follows_feed,
          .hold = phase.follows_hold,
          .adaptive = phase.follows_adaptive,
          .feed_stop = phase.heeds_feed_stop};
}

// The item that is run next, or the first motion; all that there is where none is known.
parser::FollowedOverrides followed_next(const std::deque<Item>& waiting) {
  const auto* rest = waiting.empty() ? nullptr : std::get_if<Rest>(&waiting.front());
  if (rest != nullptr && rest->duration_s > 0.0) {
    return rest->follows;
  }
  const auto block = std::ranges::find_if(
      waiting, [](const Item& item) { return std::holds_alternative<Block>(item); });
  return block != waiting.end() ? std::get<Block>(*block).follows
                                : parser::FollowedOverrides{.adaptive = true};
}

}  // namespace

// Within a tap nothing is stopped.
bool Planner::is_stopped_by_feed() const {
  return settings_.may_hold && emitter_.ends_at_rest() && stopped_feed_.stops(blocks_[0].follows) &&
         (blocks_[0].follows.hold || emitter_.kept().ends_following_hold());
}

void Planner::hold_by_feed(Outbox& outbox) {
  const std::size_t first = outbox.phases.size();
  held_ = {.by_feed = blocks_[0].follows};
  empty_window();
  emitter_.emit_rest_here(0, outbox);
  outbox.phases.back().holds = true;
  emitter_.keep(outbox, first);
}

bool Planner::hold_feed(const StopOrder& order, Outbox& outbox) {
  assert(settings_.may_hold && !before_ && outbox.phases.empty());
  const auto stop = feed_stop_by(order);
  if (!stop || !hold_at(*stop, outbox)) {
    return false;
  }
  if (held_) {
    held_->by_feed = followed_next(waiting_);
  }
  return true;
}

// Where a rest of the plan is as near as any other, it counts what begins after that.
std::optional<PlanStop> Planner::feed_stop_by(const StopOrder& order) const {
  const std::int64_t tick = order.tick;
  const EmittedItems& kept = emitter_.kept();
  const EmittedItems::Motion motion = emitter_.motion_at(tick);
  std::int64_t rests_from = tick;
  if (stopped_feed_.stops(followed_by(motion.phase)) && motion.phase.follows_hold) {
    if (kept.dwells(motion)) {
      return PlanStop{.from = motion};
    }
    if (!motion.at_rest()) {
      auto stop = find_our_stop(order);
      if (!stop || !stop->parts.empty()) {
        return stop;
      }
      rests_from = stop->from.when.tick;
    }
  }
  const auto rest = kept.rest_before(rests_from, [this](const interp::Phase& before,
                                                        const interp::Phase& begins) {
    return stopped_feed_.stops(followed_by(begins)) && (begins.follows_hold || before.follows_hold);
  });
  const bool is_near =
      rest && static_cast<double>(rest->when.tick - tick) * settings_.limits.period_s <= kFarRest_s;
  return is_near ? std::optional(PlanStop{.from = *rest}) : std::nullopt;
}

}  // namespace kerf::lookahead
