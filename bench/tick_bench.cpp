// The cost of one tick: interpolation alone, planning not counted.
#include <chrono>
#include <string>

#include <benchmark/benchmark.h>
#include <kerf/kerf.hpp>

#include "bench/program_text.hpp"

namespace kerf::bench {
namespace {

constexpr int kBatch = 100;  // ticks between two looks at the clock

void tick(benchmark::State& state, const std::string& program) {
  const std::string text = source_file(program);
  std::int64_t ticks = 0;
  for ([[maybe_unused]] auto _ : state) {
    Kernel kernel(default_machine());
    kernel.feed(text);
    kernel.finish();
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    std::chrono::steady_clock::duration spent{};
    while (status == TickStatus::running) {
      kernel.plan();
      const auto begin = std::chrono::steady_clock::now();
      for (int i = 0; i < kBatch && status == TickStatus::running; ++i) {
        status = kernel.tick(setpoint);
        ++ticks;
      }
      spent += std::chrono::steady_clock::now() - begin;
    }
    benchmark::DoNotOptimize(setpoint);
    state.SetIterationTime(std::chrono::duration<double>(spent).count());
  }
  state.SetItemsProcessed(ticks);
}

void tick_cubic_nurbs(benchmark::State& state) {
  tick(state, "programs/butterfly.ngc");
}
void tick_lines(benchmark::State& state) {
  tick(state, "programs/raster.ngc");
}
void tick_arcs(benchmark::State& state) {
  tick(state, "programs/pocket.ngc");
}

BENCHMARK(tick_cubic_nurbs)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tick_lines)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tick_arcs)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kerf::bench
