// [Sigmoid, table 2], on a curve of our own.
#include <cstdio>
#include <string>
#include <variant>

#include "bench/papers/comparison.hpp"
#include "bench/papers/in_motion.hpp"
#include "bench/papers/papers.hpp"
#include "bench/papers/parametric_curve.hpp"
#include "bench/papers/sigmoid_method.hpp"
#include "lookahead/classical/limit_curve_cuts.hpp"

namespace kerf::bench {

using profiles::Profile;
using profiles::ProfileKind;

namespace {

struct Published {
  const char* name;
  double time_s;
  double points;
  double a_mm_s2;
  double j_mm_s3;
  double first_mm;
  double last_mm;
};

// How far figures may be from the published ones.
struct Bands {
  double time_s;
  double points;
  double j_mm_s3;
  double last_mm;
};

constexpr Published kSigmoid{"sigmoid s = 3.3", 0.702, 701, 928, 25'986, 7.38, 9.96};
constexpr Published kSine{"sine", 0.721, 722, 768, 26'772, 7.14, 8.22};
constexpr Bands kFitted{.time_s = 0.001, .points = 3, .j_mm_s3 = 100, .last_mm = 0.2};
constexpr Bands kFree{.time_s = 0.016, .points = 17, .j_mm_s3 = 800, .last_mm = 1.4};
constexpr PublishedLimits kLimits{
    .path = {.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 26'000.0},
    .chord_error_mm = 5e-4};

void add(const Published& published, const Bands& bands, const MotionRun& run,
         const std::string& why, Comparison& table) {
  const std::string of = std::string(", ") + published.name;
  const double v = kLimits.path.velocity_mm_s;
  const auto row = [&](const std::string& name, double figure, int decimals, double here,
                       double band) {
    table.add({.name = name,
               .published = figure,
               .decimals = decimals,
               .here = here,
               .band = band,
               .why = why});
  };
  row("time" + of + " [s]", published.time_s, 3, run.time_s, bands.time_s);
  row("points" + of, published.points, 0, static_cast<double>(run.ticks), bands.points);
  row("largest feedrate" + of + " [mm/s]", 100, 0, run.path.v_mm_s, 0.0);
  row("largest acceleration" + of + " [mm/s2]", published.a_mm_s2, 0, run.path.a_mm_s2, 15.0);
  const bool exceeds = published.j_mm_s3 > kLimits.path.jerk_mm_s3;
  table.add({.name = "largest jerk" + of + " [mm/s3]",
             .published = published.j_mm_s3,
             .here = run.path.j_mm_s3,
             .band = bands.j_mm_s3,
             .why = exceeds ? "the limit of 26000 is kept" : why,
             .impossible = exceeds});
  row("largest chord error" + of + " [1e-4 mm]", 5, 0, 1e4 * run.chord_error_mm, 0.0);
  row("first stretch at 100 mm/s" + of + " [mm]", published.first_mm, 2, run.first_stretch_mm(v),
      0.1);
  row("last stretch at 100 mm/s" + of + " [mm]", published.last_mm, 2, run.last_stretch_mm(v),
      bands.last_mm);
}

void add(const MotionRun& sigmoid, const MotionRun& sine, const lookahead::PlanLimits& limits,
         Comparison& table) {
  add(kSigmoid, kFitted, sigmoid,
      "the points are our own, fitted to this row: no independent check", table);
  const double apart_ms = 1e3 * (sine.time_s - sigmoid.time_s);
  add(kSine, kFree, sine,
      "the points are our own; between the laws are " + fixed(apart_ms, 0) +
          " ms on them, published 19",
      table);
  table.require("the WM keeps the limits of the paper's table 1",
                keeps(sigmoid, limits, kLimits) && keeps(sine, limits, kLimits));
}

void print_blocks(const lookahead::VelocityLimitCurve& scan,
                  const std::vector<std::size_t>& breaking) {
  std::printf(
      "Its blocks, between the breaking points of a scan by one row of ticks:\n\n| block | from u "
      "| length [mm] | "
      "from [mm/s] | to [mm/s] |\n| --- | --- | --- | --- | --- |\n");
  for (std::size_t k = 1; k < breaking.size(); ++k) {
    const lookahead::FeedSample& a = scan[breaking[k - 1]];
    const lookahead::FeedSample& b = scan[breaking[k]];
    std::printf("| %zu | %.4f | %.3f | %.2f | %.2f |\n", k, a.u, b.s_mm - a.s_mm, a.v_mm_s,
                b.v_mm_s);
  }
  std::printf("\n");
}

}  // namespace

bool sigmoid_wm() {
  constexpr double kScreening_mm_s = 1.0;
  const lookahead::PlanLimits limits = machine("sigmoid-wm.toml").limits;
  Comparison table;
  const MotionRun sigmoid = in_motion("wm.ngc", limits, Profile(ProfileKind::sigmoid, 3.3));
  const MotionRun sine = in_motion("wm.ngc", limits, Profile(ProfileKind::sine));
  const ParametricCurve curve(curve_data("wm.ngc"));
  const lookahead::VelocityLimitCurve scan =
      method_scan({curve, std::get<curves::NurbsCurve>(sigmoid.block.curve)},
                  ChordRule::largest_distance, limits);
  const auto breaking = lookahead::breaking_points(scan, kScreening_mm_s);
  const auto count = static_cast<double>(breaking.size());
  table.add({.name = "breaking points", .published = 20, .here = count, .tolerance = 0.5});
  table.add({.name = "blocks", .published = 19, .here = count - 1.0, .tolerance = 0.5});
  add(sigmoid, sine, limits, table);
  table.print(
      "## Sigmoid: the WM\n\nIts table 2 and section 5.1. V 100 mm/s, A 1000 mm/s2, J 26000 mm/s3, "
      "chord 5e-4 mm, Ts 1 ms, from motion to motion. The paper does not print its curve (degree "
      "2, "
      "eight control points). Ours, " +
      fixed(sigmoid.block.length_mm, 1) +
      " mm, has points of our own, chosen for six sharp turns, the time and the end stretches.");
  std::printf(
      "Impossible to compare: the feedrates at the paper's point A, 100 mm/s by the sigmoid and 97 "
      "by the sine. A is marked in its figure 13 alone, on the curve whose points are not "
      "there.\n\n");
  print_blocks(scan, breaking);
  return table.judge();
}

}  // namespace kerf::bench
