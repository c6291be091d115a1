// The timer of a run in real time.
#pragma once

#include <cstdint>
#include <ctime>

#include "programs/kerf/report/time_histogram.hpp"

namespace kerf::program {

class TickTimer {
 public:
  // The first wait() ends at once. Precondition: period_s in 1e-6..1 s.
  explicit TickTimer(double period_s) noexcept;

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
  // stopped, or the computer asleep, which CLOCK_BOOTTIME counts too.
  [[nodiscard]] double wait() noexcept;

  // On the same clock.
  [[nodiscard]] static std::int64_t now_ns() noexcept;

  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }
  [[nodiscard]] double worst_delay_s() const noexcept { return delays_.worst_s(); }
  // Of each tick behind its time.
  [[nodiscard]] const TimeHistogram& delays() const noexcept { return delays_; }
  // Of the last one.
  [[nodiscard]] double delay_s() const noexcept;

 private:
  std::int64_t period_ns_;
  std::int64_t due_ns_;
  std::int64_t longest_gap_ns_;
  std::int64_t last_ns_ = 0;  // of CLOCK_BOOTTIME; 0: no tick yet
  std::int64_t delay_ns_ = 0;
  TimeHistogram delays_;
  std::uint64_t late_ = 0;
};

}  // namespace kerf::program
