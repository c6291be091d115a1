#include "bench/control.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <pthread.h>
#include <random>
#include <sched.h>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "bench/control_programs.hpp"
#include "bench/shortest_stop.hpp"
#include "tests/kernel/planned_path.hpp"

namespace kerf::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kHolds = 60;
constexpr std::int64_t kFirstTick = 300;
constexpr std::int64_t kLastTick = 6000;
constexpr double kLineFeed_mm_s = 100.0;
// What has to hold.
constexpr double kReactionAtMost_ms = 20.0;
constexpr double kMedianAtMost_ms = 30.0;
constexpr double kWorstOf99AtMost_ms = 60.0;
constexpr double kWayAtMost = 1.1;
// A way so much shorter than the bound shows that it is none there.
constexpr double kWayAtLeast = 0.98;

bool is_line(const ControlProgram& program) {
  return program.name == "line";
}

struct Held {
  double reaction_ms = 0.0;      // of ticks, from the request to the first that is another
  bool rests_as_planned = true;  // none is: the plan braked to a rest that is as near
  double planning_ms = 0.0;
  double rest_ms = 0.0;
  double begin_mm = 0.0;  // of the last tick that was not another
  // From the first that is, which is the first whose motion is known to brake: between these two
  // the plan before may go on for a part of a tick, with another acceleration.
  WayToRest way{};

  [[nodiscard]] double way_mm() const { return way.from.s_mm + way.way_mm - begin_mm; }
};

class HeldRun {
 public:
  HeldRun(const ControlProgram& program, ProfileKind profile)
      : program_(&program), options_{.profile = {.kind = profile}, .start_mm = program.start_mm} {
    Kernel kernel = fresh();
    Setpoint setpoint;
    while (kernel.next(setpoint) == TickStatus::running && setpoint.tick < kLastTick) {
      whole_.push_back(setpoint);
    }
  }

  [[nodiscard]] std::int64_t ticks() const { return static_cast<std::int64_t>(whole_.size()); }
  [[nodiscard]] const Setpoint& whole(std::int64_t tick) const {
    return whole_.at(static_cast<std::size_t>(std::min(tick, ticks() - 1)));
  }
  [[nodiscard]] Kernel fresh(bool one_thread = true) const {
    KernelOptions options = options_;
    options.one_thread = one_thread;
    Kernel kernel(default_machine(), options);
    kernel.feed(program_->text);
    kernel.finish();
    return kernel;
  }

  [[nodiscard]] test::PlannedPath path() const {
    return {default_machine(), options_, program_->text};
  }

  // Watches ticks from the request on. True: the tool rests.
  [[nodiscard]] bool watch(TickStatus status, const Setpoint& setpoint, Held& held) const {
    const double ms = 1e3 * default_machine().limits.period_s;
    WayToRest& way = held.way;
    const bool is_as_planned = setpoint.position_mm == whole(setpoint.tick).position_mm ||
                               setpoint.s_mm == held.begin_mm;  // it rests where the plan did
    if (held.rests_as_planned && is_as_planned) {
      held.reaction_ms += ms;
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

  [[nodiscard]] Held hold_at(std::int64_t tick) const {
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

 private:
  const ControlProgram* program_;
  KernelOptions options_;
  std::vector<Setpoint> whole_;
};

std::vector<std::int64_t> random_ticks(std::int64_t end) {
  std::mt19937_64 random(1);
  std::vector<std::int64_t> ticks(kHolds);
  for (std::int64_t& tick : ticks) {
    tick = kFirstTick +
           static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(end - 2 * kFirstTick));
  }
  return ticks;
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

// v^2 / 2a + v a / 2J of X, where a is the highest deceleration: A, or what it gets to.
double shortest_on_line_mm() {
  const MachineLimits limits = default_machine().limits;
  const MotionLimits& x = limits.axes[0];
  const MotionLimits& path = limits.path;
  const double a = std::min(x.acceleration_mm_s2, path.acceleration_mm_s2);
  const double j = std::min(x.jerk_mm_s3, path.jerk_mm_s3);
  const double highest = std::min(a, std::sqrt(kLineFeed_mm_s * j));
  return 0.5 * kLineFeed_mm_s * (kLineFeed_mm_s / highest + highest / j);
}

bool in_virtual_time(const ControlProgram& program, ProfileKind profile,
                     const std::string& folder) {
  const HeldRun run(program, profile);
  std::vector<double> reaction;
  std::vector<double> planning;
  std::vector<double> rest;
  std::vector<double> over_shortest;
  const test::PlannedPath path = run.path();
  double way_mm = 0.0;
  for (const std::int64_t tick : random_ticks(run.ticks())) {
    const Held held = run.hold_at(tick);
    if (held.rests_as_planned) {
      continue;
    }
    reaction.push_back(held.reaction_ms);
    planning.push_back(held.planning_ms);
    rest.push_back(held.rest_ms);
    way_mm = std::max(way_mm, held.way_mm());
    if (held.way.way_mm == 0.0) {
      continue;
    }
    over_shortest.push_back(held.way.way_mm /
                            shortest_stop_mm(path, held.way.from, default_machine().limits));
    const bool is_judged =
        over_shortest.back() >= kWayAtLeast && over_shortest.back() <= kWayAtMost;
    if (!folder.empty() && !is_judged) {
      write_way(folder + '/' + program.name + '-' + std::string(name_of(profile)) + '-' +
                    std::to_string(tick) + ".txt",
                path, held.way);
    }
  }
  const bool holds = quantile(reaction, 1.0) <= kReactionAtMost_ms &&
                     quantile(over_shortest, 0.5) <= kWayAtMost &&
                     (!is_line(program) || way_mm <= kWayAtMost * shortest_on_line_mm());
  std::printf("| %s | %s | %zu | %.0f | %.0f | %.1f | %.1f | %.0f | %.2f | %.3f | %.3f |\n",
              program.name.c_str(), std::string(name_of(profile)).c_str(), reaction.size(),
              quantile(reaction, 0.5), quantile(reaction, 1.0), quantile(planning, 0.5),
              quantile(planning, 1.0), quantile(rest, 1.0), way_mm, quantile(over_shortest, 0.5),
              quantile(over_shortest, 1.0));
  std::fflush(stdout);
  return holds;
}

// Keeps the processors busy.
class Load {
 public:
  Load() {
    for (std::jthread& thread : threads_) {
      thread = std::jthread([](const std::stop_token& stop) {
        for (volatile double x = 1.0; !stop.stop_requested();) {
          x = std::sqrt(x + 1.0);
        }
      });
    }
  }

 private:
  std::array<std::jthread, 2> threads_;
};

// False: not allowed.
bool become_urgent(int priority) {
  const sched_param urgent{.sched_priority = priority};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &urgent) == 0;
}

void wait_until(timespec& due, double period_s) {
  constexpr long kSecond_ns = 1'000'000'000;
  due.tv_nsec += std::lround(period_s * 1e9);
  due.tv_sec += due.tv_nsec / kSecond_ns;
  due.tv_nsec %= kSecond_ns;
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
}

Held hold_in_real_time(const HeldRun& run, std::int64_t tick, bool& is_urgent) {
  constexpr std::int64_t kTicksBefore = 50;
  constexpr int kTickPriority = 80;
  constexpr int kPlanPriority = 40;
  Kernel kernel = run.fresh(false);
  Setpoint setpoint;
  while (setpoint.tick + kTicksBefore < tick) {
    kernel.plan();
    kernel.tick(setpoint);
  }
  std::atomic<bool> asked = false;
  std::jthread planning([&](const std::stop_token& stop) {
    is_urgent = become_urgent(kPlanPriority);
    for (bool holds = false; !stop.stop_requested();) {
      if (asked && !holds) {
        kernel.hold();
        holds = true;
      }
      kernel.plan();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  Held held;
  std::thread ticking([&] {
    become_urgent(kTickPriority);
    timespec due{};
    clock_gettime(CLOCK_MONOTONIC, &due);
    for (bool rests = false; !rests;) {
      wait_until(due, default_machine().limits.period_s);
      asked = asked || setpoint.tick + 1 >= tick;
      const TickStatus status = kernel.tick(setpoint);
      rests = asked && run.watch(status, setpoint, held);
    }
  });
  ticking.join();
  return held;
}

bool in_real_time(const ControlProgram& program, ProfileKind profile) {
  const HeldRun run(program, profile);
  const Load load;
  std::vector<double> reaction;
  bool is_urgent = true;
  for (const std::int64_t tick : random_ticks(run.ticks())) {
    if (const Held held = hold_in_real_time(run, tick, is_urgent); !held.rests_as_planned) {
      reaction.push_back(held.reaction_ms);
    }
  }
  std::printf("| %s | %s | %.0f | %.0f | %.0f | %s |\n", program.name.c_str(),
              std::string(name_of(profile)).c_str(), quantile(reaction, 0.5),
              quantile(reaction, 0.99), quantile(reaction, 1.0), is_urgent ? "yes" : "no");
  std::fflush(stdout);
  return is_urgent && quantile(reaction, 0.5) <= kMedianAtMost_ms &&
         quantile(reaction, 0.99) <= kWorstOf99AtMost_ms;
}

}  // namespace

int control(const std::string& folder) {
  const std::vector<ControlProgram> all = control_programs();
  constexpr std::array kProfiles{ProfileKind::time_optimal, ProfileKind::s_curve};
  bool holds = true;
  std::printf(
      "%d holds each, in virtual time: ticks from the request to the first other setpoint, and "
      "what planning took. Where the plan brakes to a rest that is as near there is none, and the "
      "hold is not counted. Way: the longest, from the last tick that was not another; from the "
      "first that was, over a bound that lets jumps and an axis at its limit of jerk cost nothing; "
      "where an axis leaves no jerk at all it may be far too long.\n\n"
      "| program | profile | counted | reaction, median ms | worst | planning, median ms | worst | "
      "braking, "
      "worst ms | way, mm | over the bound, median | worst |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      kHolds);
  for (const ControlProgram& program : all) {
    for (const ProfileKind profile : kProfiles) {
      holds &= in_virtual_time(program, profile, folder);
    }
  }
  std::printf(
      "\nIn real time, two busy threads beside it.\n\n"
      "| program | profile | reaction, median ms | 99 %% | worst | SCHED_FIFO |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  for (const ControlProgram& program : all) {
    for (const ProfileKind profile : kProfiles) {
      holds &= in_real_time(program, profile);
    }
  }
  return holds ? 0 : 1;
}

}  // namespace kerf::bench
