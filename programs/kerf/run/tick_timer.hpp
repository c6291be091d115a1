// The timer of a run in real time.
#pragma once

#include <cstdint>
#include <ctime>

#include "programs/kerf/report/time_histogram.hpp"

namespace kerf::program {

// What a timer goes by: the system's clocks, or those of a test.
class TimerClock {
 public:
  TimerClock() = default;
  TimerClock(const TimerClock&) = delete;
  TimerClock& operator=(const TimerClock&) = delete;
  virtual ~TimerClock() = default;

  [[nodiscard]] virtual std::int64_t now_ns() const noexcept = 0;         // CLOCK_MONOTONIC
  [[nodiscard]] virtual std::int64_t with_sleep_ns() const noexcept = 0;  // CLOCK_BOOTTIME
  virtual void sleep_until(std::int64_t due_ns) noexcept = 0;             // of now_ns()

  [[nodiscard]] static TimerClock& of_system() noexcept;
};

class TickTimer {
 public:
  // The first wait() ends at once. Precondition: period_s in 1e-6..1 s.
  explicit TickTimer(double period_s, TimerClock& clock = TimerClock::of_system()) noexcept;

  // No drive waits longer for its next setpoint. A tick that is late by less is no fault on a
  // system that is not made for real time.
  static constexpr double kLongestGap_s = 0.25;
  // A long period is not a gap.
  static constexpr double kMinPeriods = 4.0;

  // Sleeps until the next tick is due, on CLOCK_MONOTONIC and against absolute times, so that
  // delays do not add up. Where it is due a period ago or more, the tick counts as late and the
  // beat goes on from now.
  //
  // Returns 0, or the time since the last tick where that is too long a gap: the process was
  // stopped, or the computer asleep, which CLOCK_BOOTTIME counts too. A clock that has gone back by
  // so much is a gap as well, and is not waited for.
  [[nodiscard]] double wait() noexcept;

  // Of the system, as the ticks.
  [[nodiscard]] static std::int64_t now_ns() noexcept { return TimerClock::of_system().now_ns(); }

  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }
  [[nodiscard]] double worst_delay_s() const noexcept { return delays_.worst_s(); }
  // Of each tick behind its time.
  [[nodiscard]] const TimeHistogram& delays() const noexcept { return delays_; }
  // Of the last one.
  [[nodiscard]] double delay_s() const noexcept;

 private:
  TimerClock* clock_;
  std::int64_t period_ns_;
  std::int64_t due_ns_;
  std::int64_t longest_gap_ns_;
  std::int64_t last_ns_ = 0;  // of CLOCK_BOOTTIME; 0: no tick yet
  std::int64_t delay_ns_ = 0;
  TimeHistogram delays_;
  std::uint64_t late_ = 0;
};

}  // namespace kerf::program
