#include "bench/papers/butterfly_method.hpp"

#include <algorithm>
#include <cstdio>

namespace kerf::bench {

using profiles::Profile;
using profiles::ProfileKind;

namespace {

constexpr double kShape = 3.3;

const char* name_of(ChordRule rule) {
  return std::ranges::find(kRules, rule, &Rule::rule)->name;
}

struct Step {
  const char* name;
  double sigmoid_s;
  double sine_s;
  double chord_error_mm;
};

void print(const Step& step) {
  std::printf("| %s | %.3f | %.3f | %.1f | %.2f |\n", step.name, step.sigmoid_s, step.sine_s,
              1e3 * (step.sine_s - step.sigmoid_s), 1e4 * step.chord_error_mm);
}

}  // namespace

std::vector<MethodRow> method_rows(const MethodCurve& curve, const lookahead::PlanLimits& limits) {
  std::vector<MethodRow> rows;
  for (const Rule& rule : kRules) {
    const lookahead::VelocityLimitCurve scan = method_scan(curve, rule.rule, limits);
    for (const bool dips : {true, false}) {
      const auto plan = [&](const Profile& profile) {
        return method_plan(curve, scan, profile, limits, dips);
      };
      rows.push_back({.rule = rule.rule,
                      .dips = dips,
                      .sigmoid = plan(Profile(ProfileKind::sigmoid, kShape)),
                      .sine = plan(Profile(ProfileKind::sine))});
    }
  }
  return rows;
}

const MethodRow& by_largest_distance(const std::vector<MethodRow>& rows, bool dips) {
  return *std::ranges::find_if(rows, [&](const MethodRow& row) {
    return row.rule == ChordRule::largest_distance && row.dips == dips;
  });
}

void print_method(const std::vector<MethodRow>& rows, Comparison& table) {
  std::printf(
      "The paper's method, its scan by one row of ticks, every transition as short as its limits "
      "allow (published: 4.360, 4.417, 57 ms, 5.19e-4 mm):\n\n"
      "| chord error of the scan | dips at the ends | sigmoid [s] | sine [s] | between them [ms] | "
      "largest chord error [mm] |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const MethodRow& row : rows) {
    const double between_s = row.sine.time_s - row.sigmoid.time_s;
    std::printf("| %s | %s | %.3f | %.3f | %.1f | %.2e |\n", name_of(row.rule),
                row.dips ? "kept" : "left out", row.sigmoid.time_s, row.sine.time_s,
                1e3 * between_s, row.sigmoid.chord_error_mm);
    table.require("the two laws are 29 to 31 ms apart in the paper's method",
                  between_s > 0.029 && between_s < 0.031);
    table.require("the paper's method is slower than 4.375 s or leaves its tolerance",
                  row.sigmoid.time_s > 4.375 || row.sigmoid.chord_error_mm > 1e-3);
  }
  std::printf("\n");
}

void print_steps(const KerfRuns& kerf, const std::vector<MethodRow>& rows,
                 const lookahead::PlanLimits& limits) {
  lookahead::PlanLimits looser = limits;
  looser.chord_tolerance_mm = 5.19e-4;
  const MotionRun sigmoid =
      in_motion("butterfly.ngc", looser, Profile(ProfileKind::sigmoid, kShape));
  const MotionRun sine = in_motion("butterfly.ngc", looser, Profile(ProfileKind::sine));
  std::printf(
      "From Kerf's time to the published one, step by step. One row of ticks sees the "
      "limit at its ticks alone, and no plan is held below it between two valleys:\n\n| plan | "
      "sigmoid [s] | sine [s] | between them [ms] | largest chord error [1e-4 mm] |\n| --- | --- | "
      "--- | --- | --- |\n");
  print({"Kerf's, below the limit at every phase of the ticks", kerf.sigmoid.time_s,
         kerf.sine.time_s, kerf.sigmoid.chord_error_mm});
  print({"the same, by the paper's bound of the sigmoid's jerk", kerf.sigmoid_by_paper.time_s,
         kerf.sine.time_s, kerf.sigmoid_by_paper.chord_error_mm});
  print({"the first, with the chord error that the paper reached, 5.19e-4 mm", sigmoid.time_s,
         sine.time_s, sigmoid.chord_error_mm});
  for (const bool dips : {true, false}) {
    const MethodRow& row = by_largest_distance(rows, dips);
    print({dips ? "the paper's method with 5e-4 mm: one row of ticks, free above the limit between "
                  "them"
                : "the same, without the two dips beside the ends",
           row.sigmoid.time_s, row.sine.time_s, row.sigmoid.chord_error_mm});
  }
  print({"published", 4.360, 4.417, 5.19e-4});
  std::printf("\n");
}

}  // namespace kerf::bench
