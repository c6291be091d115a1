// The beat of a run in real time.
#pragma once

#include <cstdint>
#include <ctime>

namespace kerf::program {

class TickTimer {
 public:
  // The first wait() ends at once. Precondition: period_s in 1e-6..1 s.
  explicit TickTimer(double period_s) noexcept;

  // Sleeps until the next tick is due, on CLOCK_MONOTONIC and against absolute times, so that
  // delays do not add up. Where it is due a period ago or more, the tick counts as late and the
  // beat goes on from now.
  void wait() noexcept;

  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }
  [[nodiscard]] double worst_delay_s() const noexcept;

 private:
  std::int64_t period_ns_;
  std::int64_t due_ns_;
  std::int64_t worst_delay_ns_ = 0;
  std::uint64_t late_ = 0;
};

}  // namespace kerf::program
