#include "lookahead/optimum/classical_run.hpp"

#include "lookahead/classical/segment_junction.hpp"

namespace kerf::lookahead {

void ClassicalRun::take(const Window<Block>& blocks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    schedule_.push(blocks[i], i > 0 ? &blocks[i - 1] : nullptr);
  }
}

std::size_t ClassicalRun::run_length(const Window<Block>& blocks) const {
  std::size_t count = 1;
  while (count < blocks.size() && !stops_between(blocks[count - 1], blocks[count])) {
    ++count;
  }
  return count;
}

std::size_t ClassicalRun::follow(const Window<Block>& blocks, bool expects_more) {
  const std::size_t count = run_length(blocks);
  take(blocks, count);
  goes_on_ = expects_more && count == blocks.size();
  return count;
}

bool ClassicalRun::push(const Window<Block>& blocks) {
  const Block* before = goes_on_ && !empty() ? &blocks[blocks.size() - 2] : nullptr;
  goes_on_ = before != nullptr && !stops_between(*before, blocks.back());
  if (goes_on_) {
    schedule_.push(blocks.back(), before);
  }
  return goes_on_;
}

bool ClassicalRun::emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox) {
  return schedule_.emit(blocks, supply_of(supply, blocks.size()), emitter, outbox);
}

// A window that was full of cells has room again once the classical schedule takes its blocks.
Supply ClassicalRun::supply_of(Supply supply, std::size_t blocks) const {
  if (!goes_on_) {
    return Supply::to_rest;
  }
  return supply == Supply::full && blocks < 2 * settings_.ready_blocks ? Supply::wanted : supply;
}

bool ClassicalRun::stops_between(const Block& before, const Block& after) const {
  return junction_of({.before = &before, .after = &after}, settings_.limits).feedrate_mm_s == 0.0;
}

}  // namespace kerf::lookahead
