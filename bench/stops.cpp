#include "bench/stops.hpp"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/machine.hpp>

#include "bench/program_text.hpp"
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

std::filesystem::path programs_folder() {
  const char* const given = std::getenv("KERF_PROGRAMS_DIR");
  return given != nullptr
             ? std::filesystem::path(given)
             : std::filesystem::path(KERF_SOURCE_DIR).parent_path() / "shared/reference/programs";
}

// Real programs by others that run (tests/programs.tsv), where they are at hand.
std::vector<test::SmoothRun> programs_by_others() {
  std::istringstream lines(source_file("tests/programs.tsv"));
  std::vector<test::SmoothRun> runs;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line);
    std::string name;
    std::string dialect;
    std::string verdict;
    columns >> name >> dialect >> verdict;
    std::ifstream file(programs_folder() / name, std::ios::binary);
    if (verdict == "runs" && file) {
      MachineSettings settings = default_machine();
      settings.dialect = dialect == "fanuc" ? Dialect::fanuc : Dialect::rs274;
      runs.push_back(
          {.name = name,
           .text = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()},
           .settings = settings});
    }
  }
  return runs;
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
  for (const test::SmoothRun& run : programs_by_others()) {  // few
    add(run, row);
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
