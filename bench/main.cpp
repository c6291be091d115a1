// kerf-bench COMMAND:
//   papers              the published results beside ours
//   optimum             the time optimum of every shipped curve beside its reference
//   starts [EVERY]      the search begun from another motion, over all shipped curves and random
//                       limits or every so many-th
//   streaming           the time optimum in a window beside one over everything
//   stops [EVERY]       rests that the path does not ask for, over all smooth runs or every so
//                       many-th
//   parts [NAME] [--quick] [--long] [--profile NAME]
//                       programs of short segments, or those whose name begins so; quick: without
//                       the longest exact stops, long: ten million lines too
//   planning            how fast real programs are planned, and the longest call of plan()
//   control [FOLDER]    how soon a hold shows and how far the tool goes; the folder gets the ways
//                       that are long, for shortest_stops
//   holds [NAME] [--profile NAME] [--first N] [--last M]
//                       a hold at every tick of a curve, and of parts at every 37th, once for each
//                       of the remainders N to M; all are 0 to 36
//   soak [--seed N] [--last M] [--seconds S] [--kind smoothed|degenerate|control|milling]
//        [--fingerprints]
//                       random curves and programs, those of the seeds N to M and on for so long,
//                       or N alone; smoothed: programs of short lines in G64; fingerprints: of the
//                       ticks of each, to compare two builds
//   parse [NAME]        text to moves, long programs; or one of them, read once for counting
//                       instructions
//   work NAME ticks|windows
//                       one program, run for counting instructions
// Anything else: Google Benchmark's cases and options, parse, plan and tick.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/control.hpp"
#include "bench/holds.hpp"
#include "bench/optimum.hpp"
#include "bench/papers/papers.hpp"
#include "bench/parse.hpp"
#include "bench/parts.hpp"
#include "bench/planning.hpp"
#include "bench/soak.hpp"
#include "bench/starts.hpp"
#include "bench/stops.hpp"
#include "bench/streaming.hpp"
#include "bench/work.hpp"

namespace {

constexpr int kUsage = 2;  // the exit status where the words make no command
constexpr std::size_t kMany = 100;

std::optional<kerf::bench::SoakKind> soak_kind(const std::string& name) {
  using kerf::bench::SoakKind;
  if (name == "smoothed") {
    return SoakKind::smoothed;
  }
  if (name == "degenerate") {
    return SoakKind::degenerate;
  }
  if (name == "milling") {
    return SoakKind::milling;
  }
  return name == "control" ? std::optional(SoakKind::control) : std::nullopt;
}

// soak [--seed N] [--last M] [--seconds S] [--kind smoothed|degenerate|control|milling]
// [--fingerprints]
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
    } else if (const auto kind = soak_kind(words[i + 1]); words[i] == "--kind" && kind) {
      order.kind = *kind;
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

// holds [NAME] [--profile NAME] [--first N] [--last M]
std::optional<kerf::bench::HoldsOrder> holds_order(const std::vector<std::string>& words) {
  kerf::bench::HoldsOrder order;
  std::size_t i = 2;
  if (i < words.size() && !words[i].starts_with('-')) {
    order.only = words[i++];
  }
  for (; i + 1 < words.size(); i += 2) {
    const auto kind = kerf::profiles::profile_kind(words[i + 1]);
    if (words[i] == "--profile" && kind) {
      order.profile = *kind;
    } else if (words[i] == "--first") {
      order.first = order.last = std::atoi(words[i + 1].c_str());
    } else if (words[i] == "--last") {
      order.last = std::atoi(words[i + 1].c_str());
    } else {
      return std::nullopt;
    }
  }
  return i == words.size() ? std::optional(order) : std::nullopt;
}

using Words = std::vector<std::string>;

// Every so many-th run: the last word, all without one.
std::size_t every_of(const Words& words) {
  return words.size() == 2 ? 1 : std::max(std::strtoul(words[2].c_str(), nullptr, 10), 1UL);
}

struct Command {
  std::string_view name;
  std::size_t max_words;  // after it
  int (*run)(const Words& words);
};

constexpr std::array kCommands{
    Command{"papers", 0, [](const Words&) { return kerf::bench::papers(); }},
    Command{"optimum", 0, [](const Words&) { return kerf::bench::optimum(); }},
    Command{"parse", 1,
            [](const Words& words) {
              return words.size() == 2 ? kerf::bench::parse() : kerf::bench::parse_once(words[2]);
            }},
    Command{"control", 1,
            [](const Words& words) {
              return kerf::bench::control(words.size() == 3 ? words[2] : std::string());
            }},
    Command{"holds", kMany,
            [](const Words& words) {
              const auto order = holds_order(words);
              return order ? kerf::bench::holds(*order) : kUsage;
            }},
    Command{"planning", 0, [](const Words&) { return kerf::bench::planning(); }},
    Command{"streaming", 0, [](const Words&) { return kerf::bench::streaming(); }},
    Command{"stops", 1, [](const Words& words) { return kerf::bench::stops(every_of(words)); }},
    Command{"starts", 1, [](const Words& words) { return kerf::bench::starts(every_of(words)); }},
    Command{"work", 2,
            [](const Words& words) {
              using kerf::bench::Counted;
              return words.size() < 4
                         ? kUsage
                         : kerf::bench::work(
                               words[2], words[3] == "ticks" ? Counted::ticks : Counted::windows);
            }},
    Command{"soak", kMany,
            [](const Words& words) {
              const auto order = soak_order(words);
              return order ? kerf::bench::soak(*order) : kUsage;
            }},
    Command{"parts", kMany, [](const Words& words) {
              const auto order = parts_order(words);
              return order ? kerf::bench::parts(*order) : kUsage;
            }}};

}  // namespace

int main(int argc, char** argv) {
  const Words words(argv, argv + argc);
  for (const Command& command : kCommands) {
    if (words.size() > 1 && words[1] == command.name && words.size() - 2 <= command.max_words) {
      return command.run(words);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return kUsage;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
