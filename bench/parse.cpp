#include "bench/parse.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <limits>

#include "bench/parse_programs.hpp"

namespace kerf::bench {

namespace {

constexpr std::size_t kBytes = 50'000'000;
constexpr std::size_t kFewBytes = 1'000'000;
constexpr std::uint64_t kLines = 2'000'000;
constexpr std::uint64_t kFewLines = 40'000;

struct Case {
  std::string_view name;
  std::string_view what;
  ParseProgram (*program)(bool long_one);
  double target_lines_s;
};

constexpr std::array kCases{
    Case{"plain", "short blocks", [](bool l) { return finishing_pass(l ? kBytes : kFewBytes); },
         4e6},
    Case{"loop", "the same inside an O-word loop",
         [](bool l) { return finishing_pass_in_loop(l ? kBytes : kFewBytes); }, 2e6},
    Case{"short-loop", "a loop of 1007 blocks, run 2000 times",
         [](bool l) { return short_loop(l ? kLines : kFewLines); }, 2e6},
    Case{"expressions", "a loop of 4 lines that reckons its points",
         [](bool l) { return expression_loop(l ? kLines : kFewLines); }, 0.0},
};

double cpu_time_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

const char* verdict_of(const Case& one, bool met) {
  if (one.target_lines_s == 0.0) {
    return "";
  }
  return met ? "met" : "missed";
}

bool measure(const Case& one) {
  constexpr int kRuns = 5;
  const ParseProgram program = one.program(true);
  double best_s = std::numeric_limits<double>::infinity();
  std::int64_t moves = 0;
  for (int run = 0; run < kRuns; ++run) {
    const double start_s = cpu_time_s();
    moves = read_moves(program.text);
    best_s = std::min(best_s, cpu_time_s() - start_s);
  }
  if (moves < 0) {
    std::printf("| %.*s | the program has errors |\n", static_cast<int>(one.what.size()),
                one.what.data());
    return false;
  }
  const double lines_s = static_cast<double>(program.lines) / best_s;
  const bool met = lines_s >= one.target_lines_s;
  const double megabytes = static_cast<double>(program.text.size()) / 1e6;
  std::printf("| %.*s | %.2f | %.3f | %.3f | %.3f | %.1f | %.2f | %s |\n",
              static_cast<int>(one.what.size()), one.what.data(), megabytes,
              static_cast<double>(program.lines) / 1e6, static_cast<double>(moves) / 1e6, best_s,
              megabytes / best_s, lines_s / 1e6, verdict_of(one, met));
  return met;
}

[[gnu::noinline]] std::int64_t counted_parse(std::string_view text) {
  return read_moves(text);
}

}  // namespace

int parse() {
  std::printf(
      "| program | text [MB] | lines [million] | moves [million] | CPU [s] | MB/s | "
      "million lines/s | target |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  bool all_met = true;
  for (const Case& one : kCases) {
    all_met = measure(one) && all_met;
  }
  return all_met ? 0 : 1;
}

int parse_once(std::string_view name) {
  const auto* const found =
      std::find_if(kCases.begin(), kCases.end(), [&](const Case& one) { return one.name == name; });
  if (found == kCases.end()) {
    return 2;
  }
  const ParseProgram program = found->program(false);
  const std::int64_t moves = counted_parse(program.text);
  std::printf("%llu\n", static_cast<unsigned long long>(program.lines));
  return moves < 0 ? 1 : 0;
}

}  // namespace kerf::bench
