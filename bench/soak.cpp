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

#include "tests/kernel/degenerate_program.hpp"
#include "tests/kernel/judged_run.hpp"
#include "tests/kernel/random_machine.hpp"
#include "tests/kernel/singular_curves.hpp"
#include "tests/kernel/smoothing_program.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::bench {

using profiles::ProfileKind;
using test::JudgedRun;
using test::RandomProgram;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongest_s = 60.0;  // of the processor's time: the machine may be busy
constexpr std::uint64_t kSeedsOfASecondRun = 8;
constexpr double kLongestCurve_s = 20.0;
constexpr double kBetweenPoints_mm = 3e-5;  // of the paths that are compared
constexpr double kAtEnd_mm = 2e-9;  // what the digits and the resolution of a program leave open

struct Trial {
  RandomProgram program;
  MachineSettings settings;
  test::Way way;
};

// The time optimum for five of eight.
ProfileKind kind_of(std::uint64_t seed) {
  return seed % 8 < 5 ? ProfileKind::time_optimal : static_cast<ProfileKind>(seed / 8 % 6);
}

Trial curve_trial(std::uint64_t seed) {
  const test::SingularCase made = test::random_singular_case(seed, kLongestCurve_s);
  Trial trial{.program = test::curve_program(made), .settings = {}, .way = {.kind = kind_of(seed)}};
  trial.settings.limits = made.limits;
  return trial;
}

Trial program_trial(std::uint64_t seed) {
  Trial trial{
      .program = {},
      .settings =
          test::random_machine(seed, seed / 4 % 2 == 0 ? test::Spread::wide : test::Spread::common),
      .way = {.kind = kind_of(seed), .window_blocks = seed % 5 < 3 ? 2 + seed / 7 % 7 : 1000}};
  const bool contour = seed % 7 == 0;
  trial.program =
      test::random_program(seed, {.arcs = seed % 4 != 0,
                                  .nurbs = seed % 4 == 1,
                                  .extra = seed % 11 == 3,
                                  .contour = contour,
                                  .blocks = contour ? 60 : 8,
                                  .longest_mm = std::min(1e3, test::unhurried_mm(trial.settings))});
  return trial;
}

Trial smoothed_trial(std::uint64_t seed) {
  return {.program = test::smoothing_program(seed),
          .settings = test::random_machine(seed, test::Spread::common),
          .way = {.kind = kind_of(seed), .window_blocks = seed % 5 == 0 ? 2 + seed / 7 % 7 : 1000}};
}

// What is wrong with the path itself; empty: it has no gap and stays within the tolerances.
std::string deviation_complaint(std::uint64_t seed) {
  const test::RandomMoves program = test::smoothing_moves(seed);
  if (program.moves.empty()) {
    return "";
  }
  const test::Smoothed smoothed = test::smooth(program.moves);
  std::string complaint = test::faults_of_junctions(program.moves, smoothed);
  const double tolerance = std::max(program.tolerances.corner_mm, program.tolerances.merge_mm);
  const double apart = test::apart_mm(test::points_of(smoothed), test::points_of(program.moves));
  if (!(apart <= std::min(tolerance, smoothed.deviation.distance_mm) + kBetweenPoints_mm)) {
    complaint += std::to_string(apart) + " mm apart, tolerance " + std::to_string(tolerance) +
                 " mm, said to be " + std::to_string(smoothed.deviation.distance_mm) + " mm";
  }
  return complaint;
}

Trial degenerate_trial(std::uint64_t seed) {
  return {.program = test::degenerate_program(seed),
          .settings = test::random_machine(seed, test::Spread::common),
          .way = {.kind = kind_of(seed)}};
}

Trial trial_of(std::uint64_t seed, SoakKind kind) {
  switch (kind) {
    case SoakKind::smoothed:
      return smoothed_trial(seed);
    case SoakKind::degenerate:
      return degenerate_trial(seed);
    case SoakKind::mixed:
      break;
  }
  return seed % 3 == 0 ? curve_trial(seed) : program_trial(seed);
}

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

// What a classical profile takes for a program that the time optimum ran. Where the optimum is
// slower by more than a tick, that is printed and counted; it is no failure yet.
constexpr std::array kRivals{ProfileKind::s_curve, ProfileKind::sigmoid,    ProfileKind::s_curve,
                             ProfileKind::sine,    ProfileKind::s_curve,    ProfileKind::quintic,
                             ProfileKind::s_curve, ProfileKind::sine_series};

struct Slower {
  std::uint64_t compared = 0;
  std::uint64_t programs = 0;
  std::int64_t worst_ticks = 0;
  double worst_ratio = 1.0;
};

void compare(std::uint64_t seed, const Trial& trial, std::int64_t ticks, Slower& slower) {
  test::Way way = trial.way;
  way.kind = kRivals[seed / 8 % kRivals.size()];
  const std::int64_t rival = test::judged_run(trial.program, trial.settings, way).ticks;
  ++slower.compared;
  if (ticks > rival + 1) {
    ++slower.programs;
    slower.worst_ticks = std::max(slower.worst_ticks, ticks - rival);
    slower.worst_ratio =
        std::max(slower.worst_ratio, static_cast<double>(ticks) / static_cast<double>(rival));
    std::printf("seed %llu, window %zu: %lld ticks, with %s %lld\n",
                static_cast<unsigned long long>(seed), trial.way.window_blocks,
                static_cast<long long>(ticks), std::string(profiles::name_of(way.kind)).c_str(),
                static_cast<long long>(rival));
  }
}

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

void judge(std::uint64_t seed, const Soak& order, Tally& tally) {
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
    compare(seed, trial, run.ticks, tally.slower);
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
