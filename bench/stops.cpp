#include "bench/stops.hpp"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/real_programs.hpp"
#include "tests/kernel/smooth_runs.hpp"

namespace kerf::bench {

namespace {

struct Row {
  std::string_view name;
  std::size_t runs = 0;
  std::size_t degraded = 0;
  std::uint64_t degradations = 0;
  double time_s = 0.0;
  double planning_s = 0.0;
};

void add(const test::SmoothRun& run, Row& row) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  const test::SmoothPlan plan = test::plan_of(run);
  row.planning_s += std::chrono::duration<double>(Clock::now() - began).count();
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

// False: something of it is not as it should be.
bool print(const Row& row) {
  std::printf("| %s | %zu | %zu | %llu | %.3f | %.1f |\n", std::string(row.name).c_str(), row.runs,
              row.degraded, static_cast<unsigned long long>(row.degradations), row.time_s,
              row.planning_s);
  return row.degraded == 0;
}

}  // namespace

int stops(std::size_t every) {
  std::vector<Row> rows;
  for (const test::SmoothKind kind : test::kSmoothKinds) {
    Row& row = rows.emplace_back(Row{.name = name_of(kind)});
    for (std::size_t i = 0; i < test::count_of(kind); i += every) {
      add(test::smooth_run(kind, i), row);
    }
  }
  Row& row = rows.emplace_back(Row{.name = "programs by others"});
  for (RealProgram& program : programs_by_others()) {  // few
    add({.name = program.name, .text = std::move(program.text), .settings = program.settings}, row);
  }
  std::printf(
      "\n| runs | count | with a degradation | degradations | time on the machine s | planning s "
      "|\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  bool met = true;
  for (const Row& each : rows) {
    met = print(each) && met;
  }
  return met ? 0 : 1;
}

}  // namespace kerf::bench
