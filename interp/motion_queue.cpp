#include "interp/motion_queue.hpp"

namespace kerf::interp {

bool MotionQueue::commit(Ahead ahead) {
  std::uint64_t word = word_.load(std::memory_order_relaxed);
  if ((word & kTaken) != 0) {
    return false;
  }
  std::uint64_t stops = word & (has_bit(0) | has_bit(1));
  const unsigned spare = 1 - slot_;
  if (ahead == Ahead::written || ahead == Ahead::beside) {
    keys_[spare].from.store(stops_[spare].from, std::memory_order_relaxed);
    keys_[spare].tick.store(stops_[spare].tick, std::memory_order_relaxed);
    stops = has_bit(spare) | (ahead == Ahead::beside ? stops : 0);
  } else if (ahead == Ahead::none) {
    stops = 0;
  }
  const std::uint64_t number = (word >> kNumberBit) + 1;
  const std::uint64_t next = phases_pushed_ | stops | number << kNumberBit;
  if (!word_.compare_exchange_strong(word, next, std::memory_order_acq_rel)) {
    return false;
  }
  slot_ = ahead == Ahead::written ? spare : slot_;
  return true;
}

// Where the consumer is faster it has taken one of them, and none stays.
void MotionQueue::settle(bool took_over) {
  slot_ = took_over ? 1 - slot_ : slot_;
  std::uint64_t word = word_.load(std::memory_order_relaxed);
  const std::uint64_t number = (word >> kNumberBit) + 1;
  const std::uint64_t phases = word & (kTaken - 1);
  const std::uint64_t next = phases | (word & has_bit(slot_)) | number << kNumberBit;
  if ((word & kTaken) == 0) {
    word_.compare_exchange_strong(word, next, std::memory_order_acq_rel);
  }
}

const StopAhead* MotionQueue::take_stop(std::uint32_t from, std::int64_t tick) noexcept {
  const auto is_ahead = [&](std::uint64_t word, unsigned slot) {
    return (word & has_bit(slot)) != 0 &&
           keys_[slot].tick.load(std::memory_order_relaxed) == tick &&
           keys_[slot].from.load(std::memory_order_relaxed) == from;
  };
  std::uint64_t word = word_.load(std::memory_order_acquire);
  for (int i = 0; i < kTakes && (word & kTaken) == 0; ++i) {
    const unsigned slot = is_ahead(word, 0) ? 0 : 1;
    if (!is_ahead(word, slot)) {
      return nullptr;
    }
    if (word_.compare_exchange_strong(word, word | kTaken, std::memory_order_acq_rel)) {
      return &stops_[slot];
    }
  }
  return nullptr;
}

}  // namespace kerf::interp
