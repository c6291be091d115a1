#include "programs/kerf/run/tick_timer.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ctime>

namespace kerf::program {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

std::int64_t time_ns(clockid_t clock) noexcept {
  timespec now{};
  clock_gettime(clock, &now);
  return now.tv_sec * kNanosecondsPerSecond + now.tv_nsec;
}

double seconds(std::int64_t time_ns) noexcept {
  return static_cast<double>(time_ns) / static_cast<double>(kNanosecondsPerSecond);
}

}  // namespace

TickTimer::TickTimer(double period_s) noexcept
    : period_ns_(std::llround(period_s * 1e9)),
      due_ns_(time_ns(CLOCK_MONOTONIC)),
      longest_gap_ns_(std::llround(std::max(kLongestGap_s, kMinPeriods * period_s) * 1e9)) {}

double TickTimer::wait() noexcept {
  const timespec due{.tv_sec = static_cast<std::time_t>(due_ns_ / kNanosecondsPerSecond),
                     .tv_nsec = static_cast<long>(due_ns_ % kNanosecondsPerSecond)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR) {
  }
  const std::int64_t now = time_ns(CLOCK_MONOTONIC);
  delay_ns_ = now - due_ns_;
  delays_.add(delay_ns_);
  if (delay_ns_ >= period_ns_) {
    ++late_;
    due_ns_ = now;
  }
  due_ns_ += period_ns_;
  const std::int64_t awake_ns = time_ns(CLOCK_BOOTTIME);
  const std::int64_t gap_ns = last_ns_ > 0 ? awake_ns - last_ns_ : 0;
  last_ns_ = awake_ns;
  return gap_ns > longest_gap_ns_ ? seconds(gap_ns) : 0.0;
}

double TickTimer::delay_s() const noexcept {
  return seconds(delay_ns_);
}

std::int64_t TickTimer::now_ns() noexcept {
  return time_ns(CLOCK_MONOTONIC);
}

}  // namespace kerf::program
