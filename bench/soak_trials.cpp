#include "bench/soak_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/kernel/degenerate_program.hpp"
#include "tests/kernel/random_machine.hpp"
#include "tests/kernel/singular_curves.hpp"
#include "tests/kernel/smoothing_program.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::bench {

using profiles::ProfileKind;

namespace {

constexpr double kLongestCurve_s = 20.0;
constexpr double kBetweenPoints_mm = 3e-5;  // of the paths that are compared

// The time optimum for five of eight.
ProfileKind kind_of(std::uint64_t seed) {
  return seed % 8 < 5 ? ProfileKind::time_optimal : static_cast<ProfileKind>(seed / 8 % 6);
}

Trial curve_trial(std::uint64_t seed) {
  const test::SingularCase made = test::random_singular_case(seed, kLongestCurve_s);
  Trial trial{.program = test::curve_program(made), .settings = {}, .way = {.kind = kind_of(seed)}};
  trial.settings.limits = made.limits;
  return trial;
}

Trial program_trial(std::uint64_t seed) {
  Trial trial{
      .program = {},
      .settings =
          test::random_machine(seed, seed / 4 % 2 == 0 ? test::Spread::wide : test::Spread::common),
      .way = {.kind = kind_of(seed), .window_blocks = seed % 5 < 3 ? 2 + seed / 7 % 7 : 1000}};
  const bool contour = seed % 7 == 0;
  trial.program =
      test::random_program(seed, {.arcs = seed % 4 != 0,
                                  .nurbs = seed % 4 == 1,
                                  .extra = seed % 11 == 3,
                                  .contour = contour,
                                  .blocks = contour ? 60 : 8,
                                  .longest_mm = std::min(1e3, test::unhurried_mm(trial.settings))});
  return trial;
}

// One of four is a single curve.
bool is_smoothed_curve(std::uint64_t seed) {
  return seed % 4 == 2;
}

double tolerance_of_curve_mm(std::uint64_t seed) {
  return std::pow(10.0, -4.0 + 0.5 * static_cast<double>(seed / 4 % 7));
}

// In G64, with no path to be held against: it departs from it.
Trial smoothed_curve_trial(std::uint64_t seed) {
  Trial trial = curve_trial(seed);
  std::array<char, 40> mode{};
  std::snprintf(mode.data(), mode.size(), "G64 P%.6f\n", tolerance_of_curve_mm(seed));
  trial.program.text = mode.data() + trial.program.text;
  trial.program.feedrate_mm_s.insert(trial.program.feedrate_mm_s.begin(), 0.0);
  trial.program.dense.clear();
  return trial;
}

std::vector<parser::Move> smoothed_curve_moves(std::uint64_t seed) {
  const test::SingularCase made = test::random_singular_case(seed, kLongestCurve_s);
  const curves::NurbsData data = test::printed(made.data);
  parser::NurbsMove nurbs;
  nurbs.degree = data.degree;
  nurbs.knots = data.knots;
  for (const curves::ControlPoint& point : data.points) {
    nurbs.points.push_back({.position_mm = point.position_mm, .weight = point.weight});
  }
  parser::Move move;
  move.shape = nurbs;
  move.start_mm = data.points.front().position_mm;
  move.source.line = 1;
  move.feedrate_mm_s = made.feedrate_mm_s;
  move.mode = parser::PathMode::blend;
  move.blend_tolerance_mm = tolerance_of_curve_mm(seed);
  return {move};
}

Trial smoothed_trial(std::uint64_t seed) {
  if (is_smoothed_curve(seed)) {
    return smoothed_curve_trial(seed);
  }
  return {.program = test::smoothing_program(seed),
          .settings = test::random_machine(seed, test::Spread::common),
          .way = {.kind = kind_of(seed), .window_blocks = seed % 5 == 0 ? 2 + seed / 7 % 7 : 1000}};
}

Trial degenerate_trial(std::uint64_t seed) {
  return {.program = test::degenerate_program(seed),
          .settings = test::random_machine(seed, test::Spread::common),
          .way = {.kind = kind_of(seed)}};
}

}  // namespace

Trial trial_of(std::uint64_t seed, SoakKind kind) {
  switch (kind) {
    case SoakKind::smoothed:
      return smoothed_trial(seed);
    case SoakKind::degenerate:
      return degenerate_trial(seed);
    case SoakKind::control:  // has trials of its own
    case SoakKind::milling:  // the same
    case SoakKind::mixed:
      break;
  }
  return seed % 3 == 0 ? curve_trial(seed) : program_trial(seed);
}

std::string deviation_complaint(std::uint64_t seed) {
  test::RandomMoves program;
  if (is_smoothed_curve(seed)) {
    program.moves = smoothed_curve_moves(seed);
    program.tolerances = {.corner_mm = tolerance_of_curve_mm(seed), .merge_mm = 0.0};
  } else {
    program = test::smoothing_moves(seed);
  }
  if (program.moves.empty()) {
    return "";
  }
  const test::Smoothed smoothed = test::smooth(program.moves);
  std::string complaint = test::faults_of_junctions(program.moves, smoothed);
  const double tolerance = std::max(program.tolerances.corner_mm, program.tolerances.merge_mm);
  const double apart = test::apart_mm(test::points_of(smoothed), test::points_of(program.moves));
  if (!(apart <= std::min(tolerance, smoothed.deviation.distance_mm) + kBetweenPoints_mm)) {
    complaint += std::to_string(apart) + " mm apart, tolerance " + std::to_string(tolerance) +
                 " mm, said to be " + std::to_string(smoothed.deviation.distance_mm) + " mm";
  }
  return complaint;
}

}  // namespace kerf::bench
