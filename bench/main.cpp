// kerf-bench papers: the published results beside ours. kerf-bench optimum: the time optimum of
// every shipped curve beside its reference. kerf-bench parse: text to moves, long programs; with
// the name of one, that one read once for counting instructions. kerf-bench soak [--seed N]
// [--last M] [--seconds S] [--kind smoothed|degenerate] [--fingerprints]: random curves and
// programs, those of the seeds N to M and on for so long, or N alone; smoothed: programs of short
// lines in G64; fingerprints: of the ticks of each, to compare two builds. kerf-bench
// streaming: the time optimum in a window beside one over everything. kerf-bench parts [NAME]
// [--quick]
// [--long] [--profile NAME]: programs of short segments, or those whose name begins so; quick:
// without the longest exact stops, long: ten million lines too. Anything else: Google Benchmark's
// cases and options, parse, plan and tick.
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/optimum.hpp"
#include "bench/papers.hpp"
#include "bench/parse.hpp"
#include "bench/parts.hpp"
#include "bench/soak.hpp"
#include "bench/streaming.hpp"
#include "bench/work.hpp"

namespace {

// soak [--seed N] [--last M] [--seconds S] [--kind smoothed|degenerate] [--fingerprints]
std::optional<kerf::bench::Soak> soak_order(const std::vector<std::string>& words) {
  kerf::bench::Soak order;
  for (std::size_t i = 2; i < words.size(); i += 2) {
    if (words[i] == "--fingerprints") {
      order.fingerprints = true;
      --i;
      continue;
    }
    if (i + 1 == words.size()) {
      return std::nullopt;
    }
    const char* value = words[i + 1].c_str();
    if (words[i] == "--seed") {
      order.seed = std::strtoull(value, nullptr, 10);
    } else if (words[i] == "--last") {
      order.last = std::strtoull(value, nullptr, 10);
    } else if (words[i] == "--seconds") {
      order.seconds = std::strtod(value, nullptr);
    } else if (words[i] == "--kind" && words[i + 1] == "smoothed") {
      order.kind = kerf::bench::SoakKind::smoothed;
    } else if (words[i] == "--kind" && words[i + 1] == "degenerate") {
      order.kind = kerf::bench::SoakKind::degenerate;
    } else {
      return std::nullopt;
    }
  }
  return order;
}

// parts [NAME] [--quick] [--long] [--profile NAME]
std::optional<kerf::bench::PartsOrder> parts_order(const std::vector<std::string>& words) {
  using kerf::profiles::ProfileKind;
  kerf::bench::PartsOrder order;
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "--quick") {
      order.quick = true;
    } else if (words[i] == "--long") {
      order.with_long = true;
    } else if (words[i] == "--profile" && i + 1 < words.size()) {
      const auto kind = kerf::profiles::profile_kind(words[++i]);
      if (!kind) {
        return std::nullopt;
      }
      order.profile = *kind;
    } else if (words[i].starts_with('-') || !order.only.empty()) {
      return std::nullopt;
    } else {
      order.only = words[i];
    }
  }
  return order;
}

}  // namespace

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
  if (argc == 2 && std::string_view(argv[1]) == "streaming") {
    return kerf::bench::streaming();
  }
  if (argc == 4 && std::string_view(argv[1]) == "work") {
    using kerf::bench::Counted;
    return kerf::bench::work(
        argv[2], std::string_view(argv[3]) == "ticks" ? Counted::ticks : Counted::windows);
  }
  if (argc >= 2 && std::string_view(argv[1]) == "soak") {
    const auto order = soak_order({argv, argv + argc});
    return order ? kerf::bench::soak(*order) : 2;
  }
  if (argc >= 2 && std::string_view(argv[1]) == "parts") {
    const auto order = parts_order({argv, argv + argc});
    return order ? kerf::bench::parts(*order) : 2;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
