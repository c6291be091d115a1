#include "lookahead/emit/emitter.hpp"

#include <algorithm>
#include <cassert>
#include <variant>

namespace kerf::lookahead {

namespace {

// A rest that ends this close behind a tick ends on it: rounding of sums of durations.
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

void Emitter::change_at_block(std::uint64_t number, const interp::OutputChange& change) {
  assert(number > totals_.blocks);
  output_changes_.push_back({.number = number, .change = change});
}

void Emitter::note(const PlanDegradation& degradation) noexcept {
  PlanDegradations& noted = totals_.degradations;
  if (noted.count < noted.first.size()) {
    noted.first[static_cast<std::size_t>(noted.count)] = degradation;
  }
  ++noted.count;
}

void Emitter::begin_block(const Block& block, Outbox& outbox) {
  ++curve_;
  ++totals_.blocks;
  s_mm_ = 0.0;
  block_begun_ = true;
  // At the first tick that is on the block, or past it where the block is shorter than a tick.
  while (!output_changes_.empty() && output_changes_.front().number <= totals_.blocks) {
    outbox.output_changes.push_back(
        {.tick = clock_.next_tick(), .change = output_changes_.front().change});
    output_changes_.pop_front();
  }
  rests_ = block.extra.alone;
  curves::for_each_piece(block.curve, [&](const curves::Piece& piece) {
    outbox.pieces.push_back({.curve = curve_, .geometry = piece, .extra = block.extra});
  });
  for (const LineMark& mark : block.marks) {
    outbox.line_changes.push_back(
        {.curve = curve_, .s_mm = mark.s_mm, .line = mark.line, .run_block = mark.run_block});
  }
}

void Emitter::emit(const Block& block, const profiles::TimeLaw& law, double s_end_mm,
                   Outbox& outbox) {
  assert(s_mm() <= s_end_mm && s_end_mm <= block.length_mm);
  if (!block_begun_) {
    begin_block(block, outbox);
  }
  const LineMark from = block.mark_at(s_mm_);
  outbox.phases.push_back({.curve = curve_,
                           .begin = clock_.now(),
                           .s_begin_mm = s_mm_,
                           .s_end_mm = s_end_mm,
                           .path_begin_mm = path_begin_mm_,
                           .law = law,
                           .line = from.line,
                           .run_block = from.run_block,
                           .has_changes = !block.marks.empty(),
                           .rapid = block.rapid});
  s_mm_ = s_end_mm;
  line_ = block.marks.empty() ? block.line : block.mark_at(s_end_mm).line;
  clock_.advance(law.duration_s());
}

void Emitter::end_segment(double s_mm) {
  ++totals_.segments;
  s_mm_ = s_mm;
  totals_.path_length_mm = path_begin_mm_ + (rests_ ? 0.0 : s_mm_);
}

void Emitter::end_block(const Block& block) {
  end_segment(block.length_mm);
  path_begin_mm_ += rests_ ? 0.0 : s_mm_;
  block_begun_ = false;
}

void Emitter::come_to_rest(Outbox& outbox) {
  assert(!outbox.phases.empty());
  outbox.phases.back().ends_at_rest = true;
  clock_.align_to_tick();
}

void Emitter::emit_rest(const Rest& rest, Outbox& outbox) {
  interp::Phase phase{.curve = curve_,
                      .begin = clock_.now(),
                      .s_begin_mm = s_mm_,
                      .s_end_mm = s_mm_,
                      .law = profiles::Transition::rest(rest.duration_s),
                      .line = rest.line != 0 ? rest.line : line_,
                      .ends_at_rest = true,
                      .ends_program = rest.ends_program};
  phase.path_begin_mm = block_begun_ || rests_ ? path_begin_mm_ : path_begin_mm_ - s_mm_;
  if (rest.change) {
    outbox.output_changes.push_back({.tick = clock_.now().tick, .change = *rest.change});
  }
  outbox.phases.push_back(phase);
  clock_.advance(rest.duration_s);
  clock_.align_to_tick();
  totals_.ticks = clock_.now().tick;
}

}  // namespace kerf::lookahead
