#include "interp/motion_queue.hpp"

namespace kerf::interp {

bool MotionQueue::commit(Ahead ahead) {
  std::uint64_t word = word_.load(std::memory_order_relaxed);
  if ((word & kTaken) != 0) {
    return false;
  }
  unsigned slot = slot_;
  std::uint64_t stop = word & kHasStop;
  if (ahead == Ahead::written) {
    slot = 1 - slot_;
    keys_[slot].from.store(stops_[slot].from, std::memory_order_relaxed);
    keys_[slot].tick.store(stops_[slot].tick, std::memory_order_relaxed);
    stop = kHasStop;
  } else if (ahead == Ahead::none) {
    stop = 0;
  }
  const std::uint64_t number = (word >> kNumberBit) + 1;
  const std::uint64_t next =
      phases_pushed_ | stop | std::uint64_t{slot} << kSlotBit | number << kNumberBit;
  if (!word_.compare_exchange_strong(word, next, std::memory_order_acq_rel)) {
    return false;
  }
  slot_ = slot;
  return true;
}

const StopAhead* MotionQueue::take_stop(std::uint32_t from, std::int64_t tick) noexcept {
  std::uint64_t word = word_.load(std::memory_order_acquire);
  const std::size_t slot = (word >> kSlotBit) & 1U;
  if (keys_[slot].tick.load(std::memory_order_relaxed) != tick ||
      keys_[slot].from.load(std::memory_order_relaxed) != from || (word & kTaken) != 0 ||
      (word & kHasStop) == 0 ||
      !word_.compare_exchange_strong(word, word | kTaken, std::memory_order_acq_rel)) {
    return nullptr;
  }
  return &stops_[slot];
}

}  // namespace kerf::interp
