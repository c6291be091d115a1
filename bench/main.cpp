// kerf-bench papers: the published results beside ours. kerf-bench optimum: the time optimum of
// every shipped curve beside its reference. kerf-bench parse: text to moves, long programs; with
// the name of one, that one read once for counting instructions. Anything else: Google Benchmark's
// cases and options, parse, plan and tick.
#include <string_view>

#include <benchmark/benchmark.h>

#include "bench/optimum.hpp"
#include "bench/papers.hpp"
#include "bench/parse.hpp"

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "papers") {
    return kerf::bench::papers();
  }
  if (argc == 2 && std::string_view(argv[1]) == "optimum") {
    return kerf::bench::optimum();
  }
  if (argc >= 2 && argc <= 3 && std::string_view(argv[1]) == "parse") {
    return argc == 2 ? kerf::bench::parse() : kerf::bench::parse_once(argv[2]);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
