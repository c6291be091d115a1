#include "bench/holds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "bench/control_programs.hpp"
#include "tests/kernel/planned_path.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::bench {

namespace {

constexpr int kStep = 37;
constexpr int kRestTicks = 20;  // before it is resumed
constexpr double kOffPathAtMost_mm = 1e-9;

struct Held {
  const ControlProgram& program;
  ProfileKind profile{};
};

struct Places {
  int step = 1;
  int remainder = 0;
};

KernelOptions options_of(const Held& of) {
  return {.profile = {.kind = of.profile}, .one_thread = true, .start_mm = of.program.start_mm};
}

// After the margin from a request to its plan, an S-curve from the largest feedrate: v/A + A/J.
std::int64_t longest_stop_ticks() {
  constexpr double kMargin_s = 0.012;
  const MotionLimits& path = default_machine().limits.path;
  const double stop_s =
      path.velocity_mm_s / path.acceleration_mm_s2 + path.acceleration_mm_s2 / path.jerk_mm_s3;
  return std::llround((kMargin_s + stop_s) / default_machine().limits.period_s);
}

// The program without a hold.
struct Whole {
  std::int64_t last_tick = 0;
  Position end_mm{};
  test::PlannedPath path;
};

// A kernel that has come to a tick, and what has judged it until then. A process that forks holds a
// copy of both.
class Run {
 public:
  explicit Run(const Held& of)
      : kernel_(default_machine(), options_of(of)),
        fastest_mm_s_(default_machine().limits.path.velocity_mm_s),
        checker_(default_machine().limits, of.profile != ProfileKind::trapezoid) {
    kernel_.feed(of.program.text);
    kernel_.finish();
  }

  TickStatus next() {
    const TickStatus status = kernel_.next(setpoint_);
    checker_.add({.setpoint = setpoint_, .feedrate_mm_s = fastest_mm_s_});
    return status;
  }
  [[nodiscard]] const Setpoint& setpoint() const { return setpoint_; }

  // Empty: all held.
  std::string hold_and_resume(const Whole& whole) {
    const bool may_end_first = whole.last_tick - setpoint_.tick <= longest_stop_ticks();
    const auto [status, rests, off_mm] = run_held(whole);
    if (const auto fault = kernel_.fault()) {
      return fault->what;
    }
    if (!checker_.complaint().empty()) {
      return checker_.complaint();
    }
    if (off_mm > kOffPathAtMost_mm) {
      return std::to_string(off_mm) + " mm off the path";
    }
    return status != TickStatus::finished          ? "it did not finish"
           : setpoint_.position_mm != whole.end_mm ? "it ends elsewhere"
           : rests < kRestTicks && !may_end_first  ? "it was not held"
                                                   : "";
  }

 private:
  struct HeldRun {
    TickStatus status = TickStatus::running;
    int rests = 0;
    double off_mm = 0.0;
  };
  HeldRun run_held(const Whole& whole) {
    HeldRun run;
    kernel_.hold();
    while (run.status == TickStatus::running || run.status == TickStatus::held) {
      run.status = next();
      run.off_mm = std::max(run.off_mm, whole.path.off_mm(setpoint_));
      run.rests += run.status == TickStatus::held ? 1 : 0;
      if (run.status == TickStatus::held && run.rests == kRestTicks) {
        kernel_.resume();
      }
    }
    return run;
  }

  Kernel kernel_;
  double fastest_mm_s_;
  test::TickChecker checker_;
  Setpoint setpoint_{};
};

// Runs each hold in a process of its own, as many at a time as there are processors.
class Children {
 public:
  template <typename Job>
  void start(std::int64_t tick, const Job& job) {
    if (running_ == max_) {
      wait();
    }
    std::fflush(stdout);
    if (const pid_t child = ::fork(); child == 0) {
      const std::string complaint = job();
      if (!complaint.empty()) {
        std::printf("tick %lld: %s\n", static_cast<long long>(tick), complaint.c_str());
        std::fflush(stdout);
      }
      ::_exit(complaint.empty() ? 0 : 1);
    }
    ++running_;
    ++started_;
  }
  void finish() {
    while (running_ > 0) {
      wait();
    }
  }
  [[nodiscard]] std::int64_t started() const { return started_; }
  [[nodiscard]] std::int64_t failed() const { return failed_; }

 private:
  void wait() {
    int status = 0;
    ::wait(&status);
    failed_ += WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : 1;
    --running_;
  }

  unsigned max_ = std::max(1U, std::thread::hardware_concurrency());
  unsigned running_ = 0;
  std::int64_t started_ = 0;
  std::int64_t failed_ = 0;
};

Whole whole_of(const Held& of) {
  Run run(of);
  while (run.next() == TickStatus::running) {
  }
  return {.last_tick = run.setpoint().tick,
          .end_mm = run.setpoint().position_mm,
          .path = test::PlannedPath(default_machine(), options_of(of), of.program.text)};
}

bool hold_at(const Places& places, const Held& of, const Whole& whole) {
  Children children;
  Run held(of);
  for (std::int64_t tick = 0; tick < whole.last_tick; ++tick) {
    held.next();
    if (tick % places.step == places.remainder) {
      children.start(tick, [&] { return held.hold_and_resume(whole); });
    }
  }
  children.finish();
  std::printf("| %s | %s | %d of %d | %lld | %lld |\n", of.program.name.c_str(),
              std::string(name_of(of.profile)).c_str(), places.remainder, places.step,
              static_cast<long long>(children.started()),
              static_cast<long long>(children.failed()));
  std::fflush(stdout);
  return children.failed() == 0;
}

bool hold_everywhere(const Held& of, const HoldsOrder& order) {
  const Whole whole = whole_of(of);
  if (of.program.name == "butterfly") {
    return hold_at({}, of, whole);
  }
  bool all_hold = true;
  for (int i = order.first; i <= std::min(order.last, kStep - 1); ++i) {
    all_hold &= hold_at({.step = kStep, .remainder = i}, of, whole);
  }
  return all_hold;
}

}  // namespace

int holds(const HoldsOrder& order) {
  bool all_hold = true;
  std::printf(
      "| program | profile | remainder | holds | broken |\n| --- | --- | --- | --- | --- |\n");
  for (const ControlProgram& program : control_programs()) {
    const bool is_meant =
        program.name == "butterfly" || program.name == "pocket" || program.name == "raster";
    if (!is_meant || (!order.only.empty() && order.only != program.name)) {
      continue;
    }
    for (const ProfileKind profile : {ProfileKind::time_optimal, ProfileKind::s_curve}) {
      if (!order.profile || order.profile == profile) {
        all_hold &= hold_everywhere({.program = program, .profile = profile}, order);
      }
    }
  }
  return all_hold ? 0 : 1;
}

}  // namespace kerf::bench
