#include "lookahead/plan_stop.hpp"

#include <utility>
#include <variant>

namespace kerf::lookahead {

namespace {

// How long after the tick a way to rest may begin, and how far apart are motions that are tried.
constexpr double kToTry_s = 0.01;
constexpr double kBetween_s = 0.005;
// Of the present plan, where a new one may change its jerk, too.
constexpr std::size_t kPlacesOfPlan = 50;

BrakingFrom braking_from(const EmittedItems& kept, const EmittedItems::Motion& motion,
                         const std::vector<const Block*>& ahead) {
  EmittedItems::Blocks emitted = kept.blocks_from(motion);
  BrakingFrom from;
  from.blocks = std::move(emitted.blocks);
  from.before = emitted.before;
  from.s_mm = emitted.is_on_next ? 0.0 : motion.curve_mm;
  from.state = {.v_mm_s = motion.v_mm_s, .a_mm_s2 = motion.a_mm_s2};
  const std::uint64_t curve = motion.phase.curve + (emitted.is_on_next ? 1 : 0);
  for (const auto& place : kept.places_behind(motion, kPlacesOfPlan)) {
    if (place.curve >= curve) {
      from.ends.push_back(
          {.block = static_cast<std::size_t>(place.curve - curve), .s_mm = place.s_mm});
    }
  }
  if (!emitted.rest_follows) {
    from.blocks.insert(from.blocks.end(), ahead.begin(), ahead.end());
  }
  return from;
}

// The first is the motion at the tick: what is left of its phase is a short cell, in which the way
// to rest can do something else than after it. From the end of a phase some ways are not found.
// Then ends follow, where the plan has found the motion feasible; those of a classical plan are far
// apart, as are those of a cruise.
std::vector<EmittedItems::Motion> motions_to_stop_from(const Emitter& emitter, std::int64_t tick,
                                                       const PlanLimits& limits) {
  const auto ticks_to_try = static_cast<std::int64_t>(kToTry_s / limits.period_s);
  const auto ticks_between = static_cast<std::int64_t>(kBetween_s / limits.period_s);
  std::vector<EmittedItems::Motion> motions{emitter.motion_at(tick)};
  for (const auto& end : emitter.kept().ends_within({.begin = tick, .end = tick + ticks_to_try})) {
    if (end.when.tick >= motions.back().when.tick + ticks_between) {
      motions.push_back(end);
    }
  }
  return motions;
}

// A rest begins for all that follows at the tick after it.
std::int64_t rest_tick(const PlanStop& stop, double period_s) {
  PlanClock clock(period_s);
  clock.set(stop.from.when);
  for (const BrakingPart& part : stop.parts) {
    clock.advance(part.law.duration_s());
  }
  return clock.next_tick();
}

std::optional<PlanStop> first_of_shortest(const Emitter& emitter,
                                          const std::vector<const Block*>& ahead,
                                          const StopOrder& order, const PlanLimits& limits) {
  for (const EmittedItems::Motion& motion : motions_to_stop_from(emitter, order.tick, limits)) {
    if (auto parts =
            find_braking(braking_from(emitter.kept(), motion, ahead), limits, order.is_late)) {
      return PlanStop{.from = motion, .parts = *std::move(parts)};
    }
  }
  return std::nullopt;
}

std::optional<PlanStop> first_of_any(const Emitter& emitter, const std::vector<const Block*>& ahead,
                                     std::int64_t tick, const PlanLimits& limits) {
  const auto motions = motions_to_stop_from(emitter, tick, limits);
  std::vector<BrakingFrom> from;
  from.reserve(motions.size());
  for (const EmittedItems::Motion& motion : motions) {
    from.push_back(braking_from(emitter.kept(), motion, ahead));
  }
  auto found = find_any_braking(from, limits);
  return found ? std::optional(
                     PlanStop{.from = motions[found->motion], .parts = std::move(found->parts)})
               : std::nullopt;
}

}  // namespace

std::optional<PlanStop> find_stop(const Emitter& emitter, const std::vector<const Block*>& ahead,
                                  const StopOrder& order, const PlanLimits& limits) {
  const std::int64_t tick = order.tick;
  const EmittedItems::Motion first = emitter.motion_at(tick);
  if (first.at_rest()) {
    return PlanStop{.from = first};
  }
  std::optional<PlanStop> found = order.effort == StopEffort::any
                                      ? first_of_any(emitter, ahead, tick, limits)
                                      : first_of_shortest(emitter, ahead, order, limits);
  const auto rest = emitter.kept().rest_after(tick);
  if (rest && !(found && rest_tick(*found, limits.period_s) < *rest)) {
    return PlanStop{.from = emitter.motion_at(*rest)};
  }
  return found;
}

void emit_stop(const std::vector<BrakingPart>& parts, std::deque<Item>& ahead, Emitter& emitter,
               Outbox& outbox) {
  for (const BrakingPart& part : parts) {
    auto& block = std::get<Block>(ahead.front());
    emitter.emit(block, part.law, part.s_end_mm, outbox);
    outbox.phases.back().active_constraint = interp::active_constraint(part.limit);
    if (outbox.phases.size() < parts.size()) {
      emitter.keep(outbox, outbox.phases.size() - 1);
    }
    if (part.ends_block) {
      emitter.end_block(std::move(block));
      ahead.pop_front();
    } else {
      emitter.end_segment(block, part.s_end_mm);
    }
  }
  if (parts.empty()) {
    // Of a dwell the rest is still to come.
    const auto* dwell = ahead.empty() ? nullptr : std::get_if<Rest>(&ahead.front());
    emitter.emit_rest_here(dwell != nullptr ? dwell->line : 0, outbox);
  } else {
    emitter.come_to_rest(outbox);
  }
}

}  // namespace kerf::lookahead
