#include "bench/soak_rivals.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace kerf::bench {

using profiles::ProfileKind;

namespace {

constexpr std::array kRivals{ProfileKind::s_curve, ProfileKind::sigmoid,    ProfileKind::s_curve,
                             ProfileKind::sine,    ProfileKind::s_curve,    ProfileKind::quintic,
                             ProfileKind::s_curve, ProfileKind::sine_series};

constexpr double kWorst = 1.01;
constexpr std::size_t kUsualWindow = 100;

}  // namespace

std::string compare(std::uint64_t seed, const Trial& trial, std::int64_t ticks, Slower& slower) {
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
  const double most = 1.0 + kWorst * static_cast<double>(rival);
  return trial.way.window_blocks >= kUsualWindow && static_cast<double>(ticks) > most
             ? "slower than a classical profile"
             : "";
}

}  // namespace kerf::bench
