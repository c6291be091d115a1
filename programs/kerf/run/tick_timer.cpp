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

class SystemClock final : public TimerClock {
 public:
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return time_ns(CLOCK_MONOTONIC); }
  [[nodiscard]] std::int64_t with_sleep_ns() const noexcept override {
    return time_ns(CLOCK_BOOTTIME);
  }
  void sleep_until(std::int64_t due_ns) noexcept override {
    const timespec due{.tv_sec = static_cast<std::time_t>(due_ns / kNanosecondsPerSecond),
                       .tv_nsec = static_cast<long>(due_ns % kNanosecondsPerSecond)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR) {
    }
  }
};

}  // namespace

TimerClock& TimerClock::of_system() noexcept {
  static SystemClock clock;
  return clock;
}

TickTimer::TickTimer(double period_s, TimerClock& clock) noexcept
    : clock_(&clock),
      period_ns_(std::llround(period_s * 1e9)),
      due_ns_(clock.now_ns()),
      longest_gap_ns_(std::llround(std::max(kLongestGap_s, kMinPeriods * period_s) * 1e9)) {}

double TickTimer::wait() noexcept {
  const std::int64_t back_ns = due_ns_ - period_ns_ - clock_->now_ns();
  if (back_ns > longest_gap_ns_) {
    return seconds(back_ns);
  }
  clock_->sleep_until(due_ns_);
  const std::int64_t now = clock_->now_ns();
  delay_ns_ = now - due_ns_;
  delays_.add(delay_ns_);
  if (delay_ns_ >= period_ns_) {
    ++late_;
    due_ns_ = now;
  }
  due_ns_ += period_ns_;
  const std::int64_t awake_ns = clock_->with_sleep_ns();
  const std::int64_t gap_ns = last_ns_ > 0 ? awake_ns - last_ns_ : 0;
  last_ns_ = awake_ns;
  return gap_ns > longest_gap_ns_ ? seconds(gap_ns) : 0.0;
}

double TickTimer::delay_s() const noexcept {
  return seconds(delay_ns_);
}

}  // namespace kerf::program
