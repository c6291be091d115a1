#include "bench/planning.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <kerf/kernel.hpp>

#include "bench/program_text.hpp"
#include "bench/real_programs.hpp"

namespace kerf::bench {

namespace {

constexpr double kLeastMedian = 50'000.0;  // lines a second
constexpr std::ptrdiff_t kManyLines = 2000;
constexpr double kLongestCall_s = 0.01;
// Before these a program begins at rest, with all of its horizon to be planned.
constexpr std::int64_t kTicksToBegin = 300;

constexpr int kRuns = 3;
constexpr double kNoted_s = 0.001;

// Of this thread: what else runs on the machine does not count.
double processor_s() {
  std::timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

using Calls = std::map<std::int64_t, double>;  // by the tick before which they are, in s

// As `kerf dry-run` in one thread, with ticks to nowhere. calls: null, or gets what takes longer
// than kNoted_s. The ticks; 0: it did not end well.
std::int64_t run(const RealProgram& program, Calls* calls) {
  using Clock = std::chrono::steady_clock;  // a clock of the processor would take as long as a tick
  Kernel kernel(program.settings, {.one_thread = true});
  kernel.feed(program.text);
  kernel.finish();
  std::int64_t ticks = 0;
  TickStatus status = TickStatus::running;
  for (Setpoint setpoint; status != TickStatus::finished && status != TickStatus::failed;) {
    kernel.reach_tick();
    const Clock::time_point began = calls == nullptr ? Clock::time_point() : Clock::now();
    kernel.plan();
    if (calls != nullptr) {
      const std::chrono::duration<double> took = Clock::now() - began;
      if (took.count() > kNoted_s) {
        calls->emplace(ticks, took.count());
      }
    }
    status = kernel.tick(setpoint);
    ++ticks;
  }
  return status == TickStatus::finished && !kernel.has_errors() ? ticks : 0;
}

struct LongestCalls {
  double any_s = 0.0;
  double in_motion_s = 0.0;
};

// Every call is the shortest of kRuns: what else runs on the machine lengthens some of them.
LongestCalls longest_calls(const RealProgram& program) {
  std::array<Calls, kRuns> runs;
  for (Calls& calls : runs) {
    run(program, &calls);
  }
  LongestCalls longest;
  for (const auto& [tick, first_s] : runs.front()) {
    double least_s = first_s;
    for (const Calls& calls : runs) {
      const auto call = calls.find(tick);
      least_s = std::min(least_s, call == calls.end() ? kNoted_s : call->second);
    }
    longest.any_s = std::max(longest.any_s, least_s);
    if (tick > kTicksToBegin) {
      longest.in_motion_s = std::max(longest.in_motion_s, least_s);
    }
  }
  return longest;
}

std::vector<RealProgram> programs() {
  std::vector<RealProgram> all;
  for (const char* name : {"butterfly", "pocket", "raster", "star"}) {
    all.push_back({.name = name,
                   .text = source_file(std::string("programs/") + name + ".ngc"),
                   .settings = default_machine()});
  }
  for (RealProgram& program : programs_by_others()) {
    all.push_back(std::move(program));
  }
  return all;
}

}  // namespace

int planning() {
  std::printf(
      "| program | lines | ticks | processor [s] | lines/s | longest call of plan [ms] | behind "
      "%lld ticks [ms] | |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
      static_cast<long long>(kTicksToBegin));
  std::vector<double> rates;
  bool met = true;
  for (const RealProgram& program : programs()) {
    const double began_s = processor_s();
    const std::int64_t ticks = run(program, nullptr);
    const double took_s = processor_s() - began_s;
    const LongestCalls longest = longest_calls(program);
    const std::ptrdiff_t lines = std::ranges::count(program.text, '\n');
    const double rate = static_cast<double>(lines) / took_s;
    if (lines > kManyLines) {
      rates.push_back(rate);
    }
    const bool is_short = ticks > 0 && longest.any_s <= kLongestCall_s;
    met = met && is_short;
    std::printf("| %s | %td | %lld | %.3f | %.0f | %.1f | %.1f | %s |\n", program.name.c_str(),
                lines, static_cast<long long>(ticks), took_s, rate, 1e3 * longest.any_s,
                1e3 * longest.in_motion_s, is_short ? "met" : "MISSED");
  }
  std::ranges::sort(rates);
  const double median = rates.empty() ? 0.0 : rates[rates.size() / 2];
  const bool is_fast = median >= kLeastMedian;
  std::printf("\nMedian of the %zu of more than %td lines: %.0f lines/s, at least %.0f: %s.\n",
              rates.size(), kManyLines, median, kLeastMedian, is_fast ? "met" : "MISSED");
  return met && is_fast ? 0 : 1;
}

}  // namespace kerf::bench
