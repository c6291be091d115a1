// kerf-bench papers: the published results beside ours. Anything else: Google Benchmark's cases and
// options, parse, plan and tick.
#include <string_view>

#include <benchmark/benchmark.h>

#include "bench/papers.hpp"

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "papers") {
    return kerf::bench::papers();
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
