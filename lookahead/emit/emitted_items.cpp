#include "lookahead/emit/emitted_items.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace kerf::lookahead {

namespace {

// A dwell that ends so close to a tick ends on it: rounding of sums of durations.
constexpr double kTickRounding = 1e-9;

// The place is a sum of ways, so it may miss the end by rounding: what would be left is no way.
bool is_at_end(const Block& block, double s_mm) {
  constexpr double kRounding_mm = 1e-12;
  constexpr double kRelative = 1e-14;
  return s_mm >= block.length_mm * (1.0 - kRelative) - kRounding_mm;
}

}  // namespace

void EmittedItems::begin(const EmitPlace& place) {
  items_.push_back({.begin = place, .first_phase = phase_count_});
}

void EmittedItems::end(Item item) {
  assert(!items_.empty() && !items_.back().item);
  items_.back().item = std::move(item);
}

void EmittedItems::add(const interp::Phase& phase) {
  phases_.push_back(interp::Phase(phase));
  ++phase_count_;
}

// The last phase stays: the motion rests at its end for as long as nothing follows. So does the
// item before the oldest phase: how its end is passed bounds the motion after it.
void EmittedItems::forget_before(std::int64_t tick) {
  while (phases_.size() > 1 && phases_[1].begin.tick + 1 < tick) {
    const std::uint64_t next = phase_count_ - phases_.size() + 1;
    for (std::size_t i = 0; i < items_.size() && items_[i].first_phase <= next; ++i) {
      items_[i].behind_rest |= items_[i].first_phase == next && phases_.front().ends_at_rest;
    }
    phases_.pop_front();
  }
  const std::uint64_t first = phase_count_ - phases_.size();
  while (items_.size() > 2 && items_[2].first_phase <= first) {
    items_.pop_front();
  }
}

std::optional<EmittedItems::Motion> EmittedItems::at(std::int64_t tick) const {
  std::size_t count = phases_.size();
  while (count > 0 && since_s(phases_[count - 1].begin, tick) < 0.0) {
    --count;
  }
  if (count == 0) {
    return std::nullopt;
  }
  const interp::Phase& phase = phases_[count - 1];
  const double t = since_s(phase.begin, tick);
  const profiles::PathMotion motion = phase.law.at(t);
  Motion found{.when = {.tick = tick},
               .v_mm_s = motion.v_mm_s,
               .a_mm_s2 = motion.a_mm_s2,
               .curve_mm = std::min(phase.s_begin_mm + motion.s_mm, phase.s_end_mm),
               .phase = phase,
               .number = phase_count_ - phases_.size() + count - 1};
  if (t >= phase.law.duration_s()) {
    found.curve_mm = phase.s_end_mm;
    if (phase.ends_at_rest) {
      found.v_mm_s = found.a_mm_s2 = 0.0;
    } else {
      found.when = end_of(phase);  // in motion, nothing is known after it
    }
  }
  return found;
}

std::vector<EmittedItems::Motion> EmittedItems::ends_within(const Ticks& ticks) const {
  std::vector<Motion> ends;
  for (std::size_t i = 1; i < phases_.size() && phases_[i].begin.tick < ticks.end; ++i) {
    const interp::Phase& phase = phases_[i - 1];
    if (phases_[i].begin.tick >= ticks.begin && !phase.ends_at_rest && !is_cut_short(i - 1)) {
      ends.push_back({.when = phases_[i].begin,
                      .v_mm_s = phase.law.ramp().v_end_mm_s,
                      .a_mm_s2 = phase.law.at(phase.law.duration_s()).a_mm_s2,
                      .curve_mm = phase.s_end_mm,
                      .phase = phase,
                      .number = phase_count_ - phases_.size() + i - 1});
    }
  }
  return ends;
}

std::vector<EmittedItems::CurvePlace> EmittedItems::places_behind(const Motion& motion,
                                                                  std::size_t most) const {
  std::vector<CurvePlace> places;
  const std::uint64_t first = phase_count_ - phases_.size();
  for (auto i = static_cast<std::size_t>(motion.number - first);
       i < phases_.size() && places.size() < most; ++i) {
    places.push_back({.curve = phases_[i].curve, .s_mm = phases_[i].s_end_mm});
  }
  return places;
}

std::optional<std::int64_t> EmittedItems::rest_after(std::int64_t tick) const {
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    if (phases_[i].ends_at_rest && end_tick(phases_[i]) >= tick) {
      return end_tick(phases_[i]);
    }
  }
  return std::nullopt;
}

interp::TickTime EmittedItems::end_of(const interp::Phase& phase) const {
  const double offset_s = phase.begin.offset_s + phase.law.duration_s();
  const auto whole = static_cast<std::int64_t>(offset_s / period_s_);
  return {.tick = phase.begin.tick + whole,
          .offset_s = std::max(offset_s - static_cast<double>(whole) * period_s_, 0.0)};
}

// What ends so close after the next begins there: the clock rounds to ticks.
bool EmittedItems::is_cut_short(std::size_t i) const {
  const interp::TickTime end = end_of(phases_[i]);
  return since_s(phases_[i + 1].begin, end.tick) + end.offset_s > 10.0 * kTickRounding * period_s_;
}

std::int64_t EmittedItems::end_tick(const interp::Phase& phase) const {
  const double ticks = (phase.begin.offset_s + phase.law.duration_s()) / period_s_;
  return phase.begin.tick + static_cast<std::int64_t>(std::ceil(ticks - kTickRounding));
}

EmittedItems::Blocks EmittedItems::blocks_from(const Motion& motion) const {
  Blocks found;
  std::size_t first = items_.size();
  while (first > 0 && items_[first - 1].first_phase > motion.number) {
    --first;
  }
  first -= first > 0 ? 1 : 0;
  if (first < items_.size() && items_[first].item) {
    const auto* block = std::get_if<Block>(&*items_[first].item);
    found.is_on_next = block != nullptr && is_at_end(*block, motion.curve_mm);
    first += found.is_on_next ? 1 : 0;
  }
  const bool is_behind_rest = first < items_.size() && this->is_behind_rest(items_[first]);
  if (first > 0 && items_[first - 1].item && !is_behind_rest) {
    found.before = std::get_if<Block>(&*items_[first - 1].item);
  }
  for (std::size_t i = first; i < items_.size() && items_[i].item; ++i) {
    const auto* block = std::get_if<Block>(&*items_[i].item);
    if (block == nullptr) {
      found.rest_follows = true;
      break;
    }
    found.blocks.push_back(block);
  }
  return found;
}

bool EmittedItems::is_behind_rest(const Entry& entry) const {
  const std::uint64_t first = phase_count_ - phases_.size();
  return entry.first_phase > first && entry.first_phase <= phase_count_
             ? phases_[entry.first_phase - 1 - first].ends_at_rest
             : entry.behind_rest;
}

std::optional<EmittedItems::Motion> EmittedItems::rest_before(std::int64_t tick,
                                                              const Stops& stops) const {
  const std::uint64_t first = phase_count_ - phases_.size();
  for (std::size_t i = 0; i + 1 < phases_.size(); ++i) {
    const interp::Phase& rest = phases_[i];
    const std::int64_t rests_at = end_tick(rest);
    if (rest.ends_at_rest && rests_at >= tick && phases_[i + 1].law.length_mm() > 0.0 &&
        stops(rest, phases_[i + 1])) {
      return Motion{.when = {.tick = rests_at},
                    .curve_mm = rest.s_end_mm,
                    .phase = rest,
                    .number = first + i};
    }
  }
  return std::nullopt;
}

EmittedItems::TakenBack EmittedItems::take_back(const Motion& motion, const EmitPlace& present,
                                                std::deque<Item>& ahead) {
  TakenBack taken{.begin = present};
  if (phases_.empty()) {
    return taken;
  }
  const auto reclaim = [&ahead](Entry& entry) {
    if (entry.item) {
      ahead.push_front(std::move(*entry.item));
      entry.item.reset();
    }
  };
  const auto drop_last = [&] {
    reclaim(items_.back());
    taken.begin = items_.back().begin;
    items_.keep_front(items_.size() - 1);
  };
  while (!items_.empty() && items_.back().first_phase > motion.number) {
    drop_last();
  }
  phases_.keep_front(phases_.size() - (phase_count_ - motion.number - 1));
  phase_count_ = motion.number + 1;
  interp::Phase& last = phases_.back();
  last.ends_at_rest &= end_tick(last) <= motion.when.tick;  // else it does not come to its end
  if (items_.empty()) {
    return taken;
  }
  Entry& entry = items_.back();
  if (entry.item && std::holds_alternative<Rest>(*entry.item)) {
    if (!has_begun(entry, motion)) {
      drop_last();
    } else if (auto left = part(entry, motion)) {
      ahead.push_front(*left);
    }
    return taken;
  }
  if (motion.curve_mm == 0.0) {
    drop_last();
    return taken;
  }
  const bool is_over = entry.item && is_at_end(std::get<Block>(*entry.item), motion.curve_mm);
  if (!is_over) {
    reclaim(entry);
    taken = {.begin = entry.begin, .within = true};
  }
  return taken;
}

bool EmittedItems::has_begun(const Entry& entry, const Motion& motion) const {
  return is_behind(entry, motion) || !(std::get<Rest>(*entry.item).duration_s > 0.0) ||
         since_s(motion.phase.begin, motion.when.tick) > 0.0;
}

std::optional<Rest> EmittedItems::part(Entry& entry, const Motion& motion) const {
  if (is_behind(entry, motion)) {
    return std::nullopt;
  }
  auto& rest = std::get<Rest>(*entry.item);
  const double run_s = since_s(motion.phase.begin, motion.when.tick);
  const double left_s = rest.duration_s - run_s;
  if (!(left_s > kTickRounding * period_s_)) {
    return std::nullopt;
  }
  rest.duration_s = run_s;
  return Rest{.duration_s = left_s,
              .line = rest.line,
              .run_block = rest.run_block,
              .follows = rest.follows};
}

}  // namespace kerf::lookahead
