// The calls of a tick, as another thread sees them.
#pragma once

#include <atomic>
#include <cstdint>

namespace kerf::interp {

// Counts them at their begin and at their end, so that whoever looks knows of what it saw between
// which two it was, and whoever has news for them, which is the first to have it.
class TickCalls {
 public:
  // Around each call. Real time.
  class Call {
   public:
    explicit Call(TickCalls& calls) noexcept : calls_(&calls), has_news_(calls.begin()) {}
    ~Call() { calls_->count(); }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    // tell() came before this call, and after the one before.
    [[nodiscard]] bool has_news() const noexcept { return has_news_; }

   private:
    TickCalls* calls_;
    bool has_news_;
  };

  // Another thread. Reads, with acquiring loads, between two calls, and again until the clock lets
  // the number of calls pass (KernelOptions::plan_clock).
  template <typename Clock, typename Read>
  void follow(const Clock& clock, const Read& read) const {
    while (true) {
      const std::int64_t seen = between();
      read();
      if (bounds_.load(std::memory_order_relaxed) == seen && clock(seen / kCall)) {
        return;
      }
    }
  }

  // The same thread. What it has written the next call sees, and which one that is the clock knows.
  template <typename Clock>
  void tell(const Clock& clock) {
    while (true) {
      std::int64_t seen = between();
      if (!clock(seen / kCall)) {
        continue;
      }
      if (bounds_.compare_exchange_strong(seen, seen | kNews, std::memory_order_acq_rel)) {
        return;
      }
      clock(kTakenBack);
    }
  }
  // For the clock: the number that it let pass last came to nothing, for a call was faster.
  static constexpr std::int64_t kTakenBack = -1;

 private:
  static constexpr std::int64_t kNews = 1;
  static constexpr std::int64_t kBound = 2;
  static constexpr std::int64_t kCall = 2 * kBound;

  [[nodiscard]] std::int64_t between() const noexcept {
    while (true) {  // a call takes microseconds
      const std::int64_t seen = bounds_.load(std::memory_order_acquire);
      if ((seen & kBound) == 0) {
        return seen;
      }
    }
  }
  bool begin() noexcept {
    if ((count() & kNews) == 0) {
      return false;
    }
    bounds_.fetch_sub(kNews, std::memory_order_relaxed);
    return true;
  }
  std::int64_t count() noexcept { return bounds_.fetch_add(kBound, std::memory_order_acq_rel); }

  std::atomic<std::int64_t> bounds_ = 0;
};

}  // namespace kerf::interp
