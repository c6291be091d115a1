#include "lookahead/emit/emitter.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <variant>

#include "lookahead/path/remainder.hpp"

namespace kerf::lookahead {

namespace {

// A rest that ends this close after a tick ends on it: rounding of sums of durations.
constexpr double kTickRounding = 1e-9;

}  // namespace

std::int64_t PlanClock::next_tick() const noexcept {
  return now_.tick + (now_.offset_s > kTickRounding * period_s_ ? 1 : 0);
}

void PlanClock::advance(double duration_s) noexcept {
  assert(duration_s >= 0.0);
  const double offset = now_.offset_s + duration_s;
  const auto whole = static_cast<std::int64_t>(offset / period_s_);
  now_.tick += whole;
  now_.offset_s = std::max(offset - static_cast<double>(whole) * period_s_, 0.0);
}

void PlanClock::align_to_tick() noexcept {
  now_ = {.tick = next_tick()};
}

void PlanClock::set(const interp::TickTime& time) noexcept {
  now_ = time;
  if (now_.offset_s <= kTickRounding * period_s_) {
    now_.offset_s = 0.0;
  } else if (now_.offset_s >= (1.0 - kTickRounding) * period_s_) {
    now_ = {.tick = time.tick + 1};
  }
}

Emitter::Emitter(double period_s, bool keeps) : clock_(period_s) {
  if (keeps) {
    kept_.emplace(period_s);
  }
}

void Emitter::change_at_block(std::uint64_t number, const interp::OutputChange& change) {
  block_changes_.push_back({.number = number, .change = change});
}

void Emitter::note(const PlanDegradation& degradation) noexcept {
  PlanDegradations& noted = totals_.degradations;
  if (noted.count < noted.first.size()) {
    noted.first[static_cast<std::size_t>(noted.count)] = degradation;
  }
  ++noted.count;
}

void Emitter::emit_change(const interp::OutputChange& change, Outbox& outbox) {
  if (++place_.output_changes > output_changes_sent_) {
    outbox.output_changes.push_back(change);
    output_changes_sent_ = place_.output_changes;
  }
}

void Emitter::emit_path(const Block& block, Outbox& outbox) {
  if (place_.curve <= curves_sent_) {
    return;
  }
  curves_sent_ = place_.curve;
  curves::for_each_piece(block.curve, [&](const curves::Piece& piece) {
    outbox.pieces.push_back({.curve = place_.curve, .geometry = piece, .extra = block.extra});
  });
  for (const LineMark& mark : block.marks) {
    outbox.line_changes.push_back(
        {.curve = place_.curve, .s_mm = mark.s_mm, .line = mark.line, .run_block = mark.run_block});
  }
}

void Emitter::pass_block_changes() {
  std::size_t next = place_.block_changes - block_changes_gone_;
  while (next < block_changes_.size() && block_changes_[next].number <= place_.curve) {
    ++next;
  }
  place_.block_changes = block_changes_gone_ + next;
}

void Emitter::drop_block_changes(std::uint64_t before) {
  for (; block_changes_gone_ < before; ++block_changes_gone_) {
    block_changes_.pop_front();
  }
}

void Emitter::begin_block(const Block& block, Outbox& outbox) {
  if (kept_) {
    kept_->begin(place_);
  }
  ++place_.curve;
  place_.s_mm = place_.curve_mm = 0.0;
  place_.on_block = true;
  totals_.blocks = place_.curve;
  const std::uint64_t first = place_.block_changes;
  pass_block_changes();
  for (std::uint64_t i = first; i < place_.block_changes; ++i) {
    emit_change(block_changes_[i - block_changes_gone_].change, outbox);
  }
  if (!kept_) {
    drop_block_changes(place_.block_changes);
  }
  place_.rests = block.extra.alone;
  emit_path(block, outbox);
}

void Emitter::emit(const Block& block, const profiles::TimeLaw& law, double s_end_mm,
                   Outbox& outbox) {
  assert(s_mm() <= s_end_mm && s_end_mm <= block.length_mm);
  if (!place_.on_block) {
    begin_block(block, outbox);
  }
  const LineMark from = block.mark_at(place_.s_mm);
  outbox.phases.push_back({.curve = place_.curve,
                           .begin = clock_.now(),
                           .s_begin_mm = place_.curve_mm,
                           .s_end_mm = block.on_whole_mm(s_end_mm),
                           .path_begin_mm = place_.path_begin_mm,
                           .law = law,
                           .line = from.line,
                           .run_block = from.run_block,
                           .has_changes = !block.marks.empty(),
                           .output_changes = place_.output_changes,
                           .plan = plan_,
                           .rapid = block.rapid,
                           .follows_feed = block.follows.feed,
                           .follows_hold = block.follows.hold,
                           .follows_adaptive = block.follows.adaptive,
                           .heeds_feed_stop = block.follows.feed_stop,
                           .deviation_mm = block.deviation_mm});
  place_.s_mm = s_end_mm;
  place_.curve_mm = block.on_whole_mm(s_end_mm);
  place_.line = block.marks.empty() ? block.line : block.mark_at(s_end_mm).line;
  clock_.advance(law.duration_s());
}

void Emitter::end_segment(const Block& block, double s_mm) {
  totals_.segments = ++place_.segments;
  place_.s_mm = s_mm;
  place_.curve_mm = block.on_whole_mm(s_mm);
  totals_.path_length_mm = place_.path_begin_mm + (place_.rests ? 0.0 : place_.curve_mm);
}

void Emitter::end_block(Block&& block) {
  end_segment(block, block.length_mm);
  place_.path_begin_mm += place_.rests ? 0.0 : place_.curve_mm;
  place_.on_block = false;
  if (kept_) {
    kept_->end(whole_of(std::move(block)));
  }
}

void Emitter::end_block_here(Block&& block) {
  place_.path_begin_mm += place_.rests ? 0.0 : place_.curve_mm;
  totals_.path_length_mm = place_.path_begin_mm;
  place_.on_block = false;
  if (kept_) {
    kept_->end(std::move(block));
  }
}

void Emitter::come_to_rest(Outbox& outbox) {
  assert(!outbox.phases.empty());
  outbox.phases.back().ends_at_rest = true;
  clock_.align_to_tick();
}

interp::Phase Emitter::rest_phase(double duration_s) const {
  const bool counts_curve = !place_.on_block && !place_.rests;
  return {.curve = place_.curve,
          .begin = clock_.now(),
          .s_begin_mm = place_.curve_mm,
          .s_end_mm = place_.curve_mm,
          .path_begin_mm = place_.path_begin_mm - (counts_curve ? place_.curve_mm : 0.0),
          .law = profiles::Transition::rest(duration_s),
          .line = place_.line,
          .output_changes = place_.output_changes,
          .plan = plan_,
          .ends_at_rest = true};
}

void Emitter::emit_rest(const Rest& rest, Outbox& outbox) {
  if (kept_) {
    kept_->begin(place_);
    kept_->end(rest);
  }
  for (const interp::OutputChange& change : rest.changes_before) {
    emit_change(change, outbox);
  }
  if (rest.change) {
    emit_change(*rest.change, outbox);
  }
  interp::Phase phase = rest_phase(rest.duration_s);
  place_.line = rest.line != 0 ? rest.line : place_.line;
  phase.line = place_.line;
  phase.rest_block = rest.run_block;
  phase.follows_feed = rest.follows.feed;
  phase.follows_hold = rest.follows.hold;
  phase.follows_adaptive = rest.follows.adaptive;
  phase.heeds_feed_stop = rest.follows.feed_stop;
  phase.ends_program = rest.ends_program;
  outbox.phases.push_back(phase);
  clock_.advance(rest.duration_s);
  clock_.align_to_tick();
  totals_.ticks = clock_.now().tick;
}

void Emitter::restore(Emitter&& before) {
  before.note_sent_by(*this);
  *this = std::move(before);
}

void Emitter::note_sent_by(const Emitter& copy) {
  plans_ = copy.plans_;
  curves_sent_ = copy.curves_sent_;
  output_changes_sent_ = copy.output_changes_sent_;
}

void Emitter::emit_rest_here(std::uint32_t line, Outbox& outbox) {
  interp::Phase phase = rest_phase(0.0);
  phase.line = line != 0 ? line : place_.line;
  outbox.phases.push_back(phase);
}

void Emitter::keep(const Outbox& outbox, std::size_t first) {
  if (!kept_) {
    return;
  }
  for (std::size_t i = first; i < outbox.phases.size(); ++i) {
    kept_->add(outbox.phases[i]);
  }
}

void Emitter::forget_before(std::int64_t tick) {
  if (!kept_) {
    return;
  }
  kept_->forget_before(tick);
  const EmitPlace* oldest = kept_->oldest();
  drop_block_changes(oldest != nullptr ? oldest->block_changes : place_.block_changes);
}

std::uint64_t Emitter::oldest_curve() const noexcept {
  const EmitPlace* oldest = kept_ ? kept_->oldest() : nullptr;
  return oldest != nullptr ? oldest->curve : place_.curve;
}

EmittedItems::Motion Emitter::motion_at(std::int64_t tick) const {
  const auto motion = kept_->at(tick);
  return motion ? *motion : EmittedItems::Motion{.when = {.tick = tick}};
}

void Emitter::take_back(const EmittedItems::Motion& motion, std::deque<Item>& ahead) {
  plan_ = plans_ = (plans_ | 1U) + 1U;  // odd numbers are those of the tick side
  clock_.set(motion.when);
  const EmittedItems::TakenBack taken = kept_->take_back(motion, place_, ahead);
  place_ = taken.begin;
  if (taken.within) {
    const interp::Phase& phase = motion.phase;
    place_.curve = phase.curve;
    place_.on_block = true;
    place_.rests = std::get<Block>(ahead.front()).extra.alone;
    place_.s_mm = place_.curve_mm = motion.curve_mm;
    place_.line = phase.line;
    place_.output_changes = phase.output_changes;
    pass_block_changes();
  }
  totals_.blocks = place_.curve;
  totals_.segments = place_.segments;
}

}  // namespace kerf::lookahead
