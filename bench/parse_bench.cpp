// Lines per second through the parser, every check on. The text is in memory; what is measured is
// bytes in, moves out. `kerf-bench parse` measures the long programs.
#include <cstdint>

#include <benchmark/benchmark.h>

#include "bench/parse_programs.hpp"

namespace kerf::bench {
namespace {

void parse(benchmark::State& state, const ParseProgram& program) {
  for ([[maybe_unused]] auto _ : state) {
    std::int64_t moves = read_moves(program.text);
    benchmark::DoNotOptimize(moves);
    if (moves < 0) {
      state.SkipWithError("the program has errors");
    }
  }
  const auto size = static_cast<std::int64_t>(program.text.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(program.lines));
  state.SetBytesProcessed(state.iterations() * size);
}

void parse_finishing_pass(benchmark::State& state) {
  constexpr std::size_t kBytes = 5'000'000;
  parse(state, finishing_pass(kBytes));
}
void parse_circles(benchmark::State& state) {
  parse(state, circles(100'000));
}
void parse_nurbs(benchmark::State& state) {
  parse(state, curves(10'000));
}

BENCHMARK(parse_finishing_pass)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_circles)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_nurbs)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kerf::bench
