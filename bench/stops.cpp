#include "bench/stops.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

#include "tests/kernel/smooth_runs.hpp"

namespace kerf::bench {

namespace {

struct Row {
  std::size_t runs = 0;
  std::size_t degraded = 0;
  std::uint64_t degradations = 0;
  double time_s = 0.0;
};

void add(const test::SmoothRun& run, Row& row) {
  const test::SmoothPlan plan = test::plan_of(run);
  ++row.runs;
  row.time_s += plan.time_s;
  if (plan.degradations.count == 0 && plan.complaint.empty()) {
    return;
  }
  ++row.degraded;
  row.degradations += plan.degradations.count;
  const PlanDegradation& first = plan.degradations.first.front();
  std::printf("%s: %llu, the first on line %u at %.6f mm, kind %d %s\n", run.name.c_str(),
              static_cast<unsigned long long>(plan.degradations.count), first.line, first.s_mm,
              static_cast<int>(first.kind), plan.complaint.c_str());
  std::fflush(stdout);
}

}  // namespace

int stops(std::size_t every) {
  std::string table =
      "\n| runs | count | with a degradation | degradations | time on the machine s | planning s "
      "|\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  std::size_t degraded = 0;
  for (const test::SmoothKind kind : test::kSmoothKinds) {
    const auto began = std::chrono::steady_clock::now();
    Row row;
    for (std::size_t i = 0; i < test::count_of(kind); i += every) {
      add(test::smooth_run(kind, i), row);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    degraded += row.degraded;
    std::array<char, 200> line{};
    std::snprintf(line.data(), line.size(), "| %s | %zu | %zu | %llu | %.3f | %.1f |\n",
                  std::string(name_of(kind)).c_str(), row.runs, row.degraded,
                  static_cast<unsigned long long>(row.degradations), row.time_s, took.count());
    table += line.data();
  }
  std::printf("%s", table.c_str());
  return degraded == 0 ? 0 : 1;
}

}  // namespace kerf::bench
