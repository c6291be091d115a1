#include "bench/soak.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <string>
#include <thread>

#include "bench/soak_rivals.hpp"
#include "bench/soak_trials.hpp"
#include "tests/kernel/commanded_run.hpp"

namespace kerf::bench {

using profiles::ProfileKind;
using test::JudgedRun;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongest_s = 60.0;  // of the processor's time: the machine may be busy
constexpr std::uint64_t kSeedsOfASecondRun = 8;
constexpr double kAtEnd_mm = 2e-9;  // what the digits and the resolution of a program leave open

double distance_mm(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Ends the process where a program takes too long, for what hangs cannot be ended otherwise.
class Watchdog {
 public:
  void begin(std::uint64_t seed) {
    const std::lock_guard lock(mutex_);
    seed_ = seed;
    began_s_ = spent_s();
  }

 private:
  static double spent_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

  void watch(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; }) &&
           !stop.stop_requested()) {
      if (spent_s() - began_s_ > kLongest_s) {
        std::printf("seed %llu: does not end within a minute\n",
                    static_cast<unsigned long long>(seed_));
        std::fflush(stdout);
        std::_Exit(1);
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::uint64_t seed_ = 0;
  double began_s_ = spent_s();
  std::jthread thread_{[this](const std::stop_token& stop) { watch(stop); }};
};

struct Tally {
  Slower slower{};
  std::uint64_t runs = 0;
  std::uint64_t curves = 0;
  std::uint64_t failures = 0;
  std::uint64_t with_degradation = 0;
  std::int64_t ticks = 0;
  std::array<double, test::kFigures> worst{};
  double worst_chord = 0.0;
};

void judge_commands(std::uint64_t seed, SoakKind kind, Tally& tally) {
  constexpr std::uint64_t kOverrideSteps = 41;
  const test::CommandedRun run = test::commanded_run(
      seed, seed % kOverrideSteps == 0 ? test::Commands::override_steps : test::Commands::all,
      kind == SoakKind::milling ? test::Programs::milling : test::Programs::exact);
  ++tally.runs;
  tally.ticks += run.ticks;
  for (std::size_t i = 0; i < test::kFigures; ++i) {
    tally.worst[i] = std::max(tally.worst[i], run.worst[i]);
  }
  if (!run.complaint.empty()) {
    ++tally.failures;
    std::printf("seed %llu: %s; %s\n", static_cast<unsigned long long>(seed), run.complaint.c_str(),
                run.commands.c_str());
    std::fflush(stdout);
  }
}

void judge_run(std::uint64_t seed, const Soak& order, Tally& tally) {
  const SoakKind kind = order.kind;
  const Trial trial = trial_of(seed, kind);
  JudgedRun run = test::judged_run(trial.program, trial.settings, trial.way);
  const double off_mm = distance_mm(run.last.position_mm, trial.program.end_mm);
  if (run.complaint.empty() && !(off_mm <= kAtEnd_mm)) {
    run.complaint = "ends " + std::to_string(1e6 * off_mm) + " nm beside its end";
  }
  if (kind == SoakKind::smoothed) {
    run.complaint += deviation_complaint(seed);
    if (seed % kSeedsOfASecondRun == 0 &&
        test::judged_run(trial.program, trial.settings, trial.way).fingerprint != run.fingerprint) {
      run.complaint += "the second run differs";
    }
  }
  if (order.fingerprints) {
    std::printf("%llu %lld %016llx\n", static_cast<unsigned long long>(seed),
                static_cast<long long>(run.ticks),
                static_cast<unsigned long long>(run.fingerprint));
  }
  if (trial.way.kind == ProfileKind::time_optimal && run.complaint.empty()) {
    run.complaint = compare(seed, trial, run.ticks, tally.slower);
  }
  ++tally.runs;
  tally.curves += kind == SoakKind::mixed && seed % 3 == 0 ? 1U : 0U;
  tally.ticks += run.ticks;
  tally.with_degradation += run.degradations > 0 ? 1U : 0U;
  for (std::size_t i = 0; i < test::kFigures; ++i) {
    tally.worst[i] = std::max(tally.worst[i], run.worst[i]);
  }
  tally.worst_chord = std::max(tally.worst_chord, run.worst_chord);
  if (!run.complaint.empty()) {
    ++tally.failures;
    std::printf("seed %llu, %s, window %zu: %s\n", static_cast<unsigned long long>(seed),
                std::string(profiles::name_of(trial.way.kind)).c_str(), trial.way.window_blocks,
                run.complaint.c_str());
    std::fflush(stdout);
  }
}

void judge(std::uint64_t seed, const Soak& order, Tally& tally) {
  if (order.kind == SoakKind::control || order.kind == SoakKind::milling) {
    judge_commands(seed, order.kind, tally);
  } else {
    judge_run(seed, order, tally);
  }
}

void print(const Tally& tally, std::uint64_t first) {
  std::printf(
      "%llu programs from seed %llu on, %llu of them single curves, %lld ticks, %llu with "
      "a degradation, %llu failed\n\n| figure | largest over what is allowed |\n"
      "| --- | --- |\n",
      static_cast<unsigned long long>(tally.runs), static_cast<unsigned long long>(first),
      static_cast<unsigned long long>(tally.curves), static_cast<long long>(tally.ticks),
      static_cast<unsigned long long>(tally.with_degradation),
      static_cast<unsigned long long>(tally.failures));
  for (std::size_t i = 0; i < test::kFigures; ++i) {
    std::printf("| %s | %.6f |\n", test::name_of(static_cast<test::Figure>(i)), tally.worst[i]);
  }
  std::printf("| chord error | %.6f |\n", tally.worst_chord);
  std::printf(
      "\nslower than a classical profile: %llu of %llu, at the most by %lld ticks and by %.4f\n",
      static_cast<unsigned long long>(tally.slower.programs),
      static_cast<unsigned long long>(tally.slower.compared),
      static_cast<long long>(tally.slower.worst_ticks), tally.slower.worst_ratio);
}

}  // namespace

int soak(const Soak& order) {
  const Clock::time_point began = Clock::now();
  const std::chrono::duration<double> allowed(order.seconds);
  Watchdog watchdog;
  Tally tally;
  std::uint64_t seed = order.seed;
  do {
    watchdog.begin(seed);
    judge(seed, order, tally);
    ++seed;
  } while (seed <= order.last || Clock::now() - began < allowed);
  print(tally, order.seed);
  return tally.failures == 0 ? 0 : 1;
}

}  // namespace kerf::bench
