// The calls of a tick, as another thread sees them.
#pragma once

#include <atomic>
#include <cstdint>

namespace kerf {

// Counts them at their begin and at their end, so that whoever looks knows of what it saw between
// which two it was.
class TickCalls {
 public:
  // Around each call. Real time.
  class Call {
   public:
    explicit Call(TickCalls& calls) noexcept : calls_(&calls) { calls_->count(); }
    ~Call() { calls_->count(); }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    TickCalls* calls_;
  };

  // Another thread. Reads, with acquiring loads, between two calls, and again until the clock lets
  // the number of calls pass.
  template <typename Clock, typename Read>
  void follow(const Clock& clock, const Read& read) const {
    while (true) {
      const std::int64_t seen = bounds_.load(std::memory_order_acquire);
      if (seen % 2 != 0) {
        continue;  // a call takes microseconds
      }
      read();
      if (bounds_.load(std::memory_order_relaxed) == seen && clock(seen / 2)) {
        return;
      }
    }
  }

 private:
  void count() noexcept { bounds_.fetch_add(1, std::memory_order_acq_rel); }

  std::atomic<std::int64_t> bounds_ = 0;
};

}  // namespace kerf
