#include "bench/held_run.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <random>
#include <utility>

#include <kerf/machine.hpp>

namespace kerf::bench {

namespace {

constexpr std::int64_t kFirstTick = 300;
constexpr std::int64_t kLastTick = 6000;
constexpr double kAtLimit = 0.999;

}  // namespace

HeldRun::HeldRun(const ControlProgram& program, ProfileKind profile)
    : program_(&program), options_{.profile = {.kind = profile}, .start_mm = program.start_mm} {
  Kernel kernel = fresh();
  Setpoint setpoint;
  while (kernel.next(setpoint) == TickStatus::running && setpoint.tick < kLastTick) {
    whole_.push_back(setpoint);
  }
}

Kernel HeldRun::fresh(bool one_thread) const {
  KernelOptions options = options_;
  options.one_thread = one_thread;
  Kernel kernel(default_machine(), options);
  kernel.feed(program_->text);
  kernel.finish();
  return kernel;
}

test::PlannedPath HeldRun::path() const {
  return {default_machine(), options_, program_->text};
}

bool HeldRun::watch(TickStatus status, const Setpoint& setpoint, Held& held) const {
  const double ms = 1e3 * default_machine().limits.period_s;
  const Setpoint& planned =
      whole_.at(static_cast<std::size_t>(std::min(setpoint.tick, ticks() - 1)));
  WayToRest& way = held.way;
  const bool is_as_planned = setpoint.position_mm == planned.position_mm ||
                             setpoint.s_mm == held.begin_mm;  // it rests where the plan did
  if (held.rests_as_planned && is_as_planned) {
    held.reaction_ms += ms;
    held.at_limit_ms = brakes_at_limit(setpoint.tick) ? held.at_limit_ms + ms : 0.0;
    held.begin_mm = setpoint.s_mm;
    return status != TickStatus::running;
  }
  if (std::exchange(held.rests_as_planned, false)) {
    way.from = {.s_mm = setpoint.s_mm, .v_mm_s = setpoint.v_mm_s, .a_mm_s2 = setpoint.a_mm_s2};
  }
  held.rest_ms += ms;
  way.way_mm = setpoint.s_mm - way.from.s_mm;
  way.a_mm_s2.push_back(setpoint.a_mm_s2);
  return status != TickStatus::running;
}

bool HeldRun::brakes_at_limit(std::int64_t tick) const {
  if (tick < 1 || tick >= ticks()) {
    return false;
  }
  const MachineLimits limits = default_machine().limits;
  const double before_mm_s2 = whole_[static_cast<std::size_t>(tick - 1)].a_mm_s2;
  const double a_mm_s2 = whole_[static_cast<std::size_t>(tick)].a_mm_s2;
  return a_mm_s2 <= -kAtLimit * limits.path.acceleration_mm_s2 ||
         before_mm_s2 - a_mm_s2 >= kAtLimit * limits.path.jerk_mm_s3 * limits.period_s;
}

Held HeldRun::hold_at(std::int64_t tick) const {
  using Clock = std::chrono::steady_clock;
  Kernel kernel = fresh();
  Setpoint setpoint;
  while (setpoint.tick + 1 < tick) {
    kernel.next(setpoint);
  }
  Held held;
  const Clock::time_point asked = Clock::now();
  kernel.hold();
  held.planning_ms = std::chrono::duration<double, std::milli>(Clock::now() - asked).count();
  while (!watch(kernel.next(setpoint), setpoint, held)) {
  }
  return held;
}

std::vector<std::int64_t> HeldRun::random_ticks() const {
  std::mt19937_64 random(1);
  std::vector<std::int64_t> held(kHolds);
  for (std::int64_t& tick : held) {
    tick = kFirstTick + static_cast<std::int64_t>(
                            random() % static_cast<std::uint64_t>(ticks() - 2 * kFirstTick));
  }
  return held;
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

}  // namespace kerf::bench
