// [SineSeries]: the times of the butterfly and of a trident. The table of its limits is lost, and
// so are the trident's points.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/curve_run.hpp"
#include "bench/papers/comparison.hpp"
#include "bench/papers/papers.hpp"

namespace kerf::bench {

using profiles::Profile;
using profiles::ProfileKind;

namespace {

constexpr const char* kButterfly = "butterfly.ngc";
constexpr const char* kTrident = "trident7.ngc";
constexpr const char* kMachine = "sine-series.toml";
constexpr double kSine_s = 5.427;
constexpr double kSeries_s = 4.802;

struct Limits {
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;
};

// Of the plan from rest to rest, at the feedrate of the limits whatever the program's F.
double time_s(const std::string& program, const Limits& path, ProfileKind kind) {
  lookahead::PlanLimits limits = machine(kMachine).limits;
  limits.path = {
      .velocity_mm_s = path.v_mm_s, .acceleration_mm_s2 = path.a_mm_s2, .jerk_mm_s3 = path.j_mm_s3};
  const PlannedRun run =
      plan_of({curve_block(program, limits, path.v_mm_s)}, limits, Profile(kind));
  double sum_s = 0.0;
  for (const interp::Phase& phase : run.phases) {
    sum_s += phase.law.duration_s();
  }
  return sum_s;
}

double gain_percent(const std::string& program, const Limits& path) {
  return 100.0 * (time_s(program, path, ProfileKind::sine_series) /
                      time_s(program, path, ProfileKind::sine) -
                  1.0);
}

// Where a falling function comes down to a value, on a scale of ratios.
template <typename Function>
double crossing(double low, double high, double value, const Function& falling) {
  constexpr int kHalvings = 12;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::sqrt(low * high);
    (falling(middle) > value ? low : high) = middle;
  }
  return high;
}

void print_searched() {
  std::printf(
      "Limits that give the butterfly's published times, 5.427 s with the single sine and 4.802 s "
      "with the series: of the acceleration the sine's decides, for its jerk does not bind; of the "
      "jerk then the series'. Below 115 mm/s there are none: the map at 100 mm/s.\n\n| V [mm/s] | "
      "A [mm/s2] | J [mm/s3] | sine [s] | "
      "series [s] | trident7 |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const double v : {120.0, 130.0, 150.0, 200.0}) {
    Limits limits{.v_mm_s = v, .a_mm_s2 = 0.0, .j_mm_s3 = 1e5};
    limits.a_mm_s2 = crossing(300.0, 700.0, kSine_s, [&](double a) {
      return time_s(kButterfly, {v, a, limits.j_mm_s3}, ProfileKind::sine);
    });
    limits.j_mm_s3 = crossing(3e4, 2e5, kSeries_s, [&](double j) {
      return time_s(kButterfly, {v, limits.a_mm_s2, j}, ProfileKind::sine_series);
    });
    std::printf("| %.0f | %.1f | %.0f | %.3f | %.3f | %.1f %% |\n", v, limits.a_mm_s2,
                limits.j_mm_s3, time_s(kButterfly, limits, ProfileKind::sine),
                time_s(kButterfly, limits, ProfileKind::sine_series),
                gain_percent(kTrident, limits));
  }
  std::printf("\n");
}

void print_map() {
  constexpr std::array kJerks{2e4, 5e4, 1e5, 2e5};
  for (const double v : {100.0, 120.0}) {
    std::printf(
        "What the series takes less than the sine on the butterfly at %.0f mm/s, in %% (published: "
        "11.52), by A [mm/s2] and J [mm/s3]:\n\n| A |",
        v);
    for (const double j : kJerks) {
      std::printf(" J %.0f |", j);
    }
    std::printf("\n| --- | --- | --- | --- | --- |\n");
    for (const double a : {350.0, 480.0, 600.0, 1000.0}) {
      std::printf("| %.0f |", a);
      for (const double j : kJerks) {
        std::printf(" %.1f |", -gain_percent(kButterfly, {v, a, j}));
      }
      std::printf("\n");
    }
    std::printf("\n");
  }
}

void add_times(const Limits& limits, Comparison& table) {
  const std::string inferred = "the limits are inferred";
  const std::string lost = "the trident's points are lost: trident7 is another";
  struct Row {
    const char* name;
    const char* program;
    double sine_s;
    double series_s;
    double gain;
    int gain_decimals;
    double tolerance_s;
    const std::string& why;
  };
  for (const Row& row :
       {Row{"butterfly", kButterfly, kSine_s, kSeries_s, 11.52, 2, 0.003, inferred},
        Row{"trident7", kTrident, 3.126, 2.577, 17.6, 1, 0.0, lost}}) {
    const double sine = time_s(row.program, limits, ProfileKind::sine);
    const double series = time_s(row.program, limits, ProfileKind::sine_series);
    const bool same = row.tolerance_s > 0.0;
    const auto add = [&](const std::string& what, double published, int decimals, double here,
                         double tolerance, double band) {
      table.add({.name = std::string(row.name) + what,
                 .published = published,
                 .decimals = decimals,
                 .here = here,
                 .tolerance = tolerance,
                 .band = band,
                 .why = row.why,
                 .impossible = !same && decimals == 3});
    };
    add(", single sine [s]", row.sine_s, 3, sine, row.tolerance_s, same ? 0.0 : 2.0);
    add(", sine series [s]", row.series_s, 3, series, row.tolerance_s, same ? 0.0 : 2.0);
    add(", less time [%]", row.gain, row.gain_decimals, 100.0 * (1.0 - series / sine),
        same ? 0.1 : 0.0, same ? 0.0 : 5.0);
  }
}

}  // namespace

bool sine_series() {
  const MachineSettings settings = machine(kMachine);
  const lookahead::MotionLimits& path = settings.limits.path;
  Comparison table;
  add_times({path.velocity_mm_s, path.acceleration_mm_s2, path.jerk_mm_s3}, table);
  add_contour_errors(settings, table);
  add_critical_points(settings.limits, table);
  table.print("## SineSeries\n\nIts simulations and experiments, from rest to rest, V " +
              fixed(path.velocity_mm_s, 0) + " mm/s, A " + fixed(path.acceleration_mm_s2, 0) +
              " mm/s2, J " + fixed(path.jerk_mm_s3, 0) +
              " mm/s3, chord 5e-4 mm, Ts 1 ms: limits that are inferred, for the paper's are lost "
              "(programs/machines/sine-series.toml).");
  print_over_critical_points(settings.limits);
  print_searched();
  print_map();
  return table.judge();
}

}  // namespace kerf::bench
