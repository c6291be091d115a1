#include "bench/control_real_time.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <pthread.h>
#include <sched.h>
#include <string>
#include <thread>
#include <vector>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "bench/held_run.hpp"

namespace kerf::bench {

namespace {

constexpr double kMedianAtMost_ms = 30.0;
constexpr double kWorstOf99AtMost_ms = 60.0;

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

}  // namespace

bool holds_in_real_time(const ControlProgram& program, ProfileKind profile) {
  const HeldRun run(program, profile);
  const Load load;
  std::vector<double> reaction;
  bool is_urgent = true;
  for (const std::int64_t tick : run.random_ticks()) {
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

}  // namespace kerf::bench
