#include "programs/tick_timer.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace kerf::program {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

std::int64_t now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kNanosecondsPerSecond + now.tv_nsec;
}

}  // namespace

TickTimer::TickTimer(double period_s) noexcept
    : period_ns_(std::llround(period_s * 1e9)), due_ns_(now_ns()) {}

void TickTimer::wait() noexcept {
  const timespec due{.tv_sec = due_ns_ / kNanosecondsPerSecond,
                     .tv_nsec = due_ns_ % kNanosecondsPerSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR) {
  }
  const std::int64_t now = now_ns();
  const std::int64_t delay_ns = now - due_ns_;
  worst_delay_ns_ = std::max(worst_delay_ns_, delay_ns);
  if (delay_ns >= period_ns_) {
    ++late_;
    due_ns_ = now;
  }
  due_ns_ += period_ns_;
}

double TickTimer::worst_delay_s() const noexcept {
  return static_cast<double>(worst_delay_ns_) / static_cast<double>(kNanosecondsPerSecond);
}

}  // namespace kerf::program
