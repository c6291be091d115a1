#include "bench/optimum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "bench/curve_run.hpp"
#include "bench/program_text.hpp"

namespace kerf::bench {

using lookahead::PlanLimits;

namespace {

constexpr double kTolerance = 1.005;
constexpr double kOfReference = 1.01;

struct LimitSet {
  lookahead::MotionLimits each{};
  double chord_mm = 0.0;
};

const std::vector<LimitSet> kSets{
    {{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3}, 5e-4},
    {{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 20e3}, 1e-3},
    {{.velocity_mm_s = 200.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 30e3}, 1e-3}};

// Curve, "path" or "axis", and the feedrate and acceleration that tell the set.
std::string key_of(const std::string& curve, bool on_axes, double v, double a) {
  std::ostringstream key;
  key << curve << (on_axes ? " axis " : " path ") << v << " " << a;
  return key.str();
}

std::map<std::string, double> references() {
  std::istringstream lines(source_file("bench/optima.tsv"));
  std::map<std::string, double> times;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string curve;
    std::string limits;
    double v = 0.0;
    double a = 0.0;
    double j = 0.0;
    double chord = 0.0;
    double grid = 0.0;
    double time = 0.0;
    if (words >> curve >> limits >> v >> a >> j >> chord >> grid >> time) {
      times[key_of(curve, limits == "axis", v, a)] = time;
    }
  }
  return times;
}

PlanLimits plan_limits(const LimitSet& set, bool on_axes) {
  PlanLimits limits;
  limits.chord_tolerance_mm = set.chord_mm;
  limits.path = set.each;
  if (on_axes) {
    limits.path = {.velocity_mm_s = set.each.velocity_mm_s};
    limits.axes.fill({.velocity_mm_s = lookahead::kUnbounded,
                      .acceleration_mm_s2 = set.each.acceleration_mm_s2,
                      .jerk_mm_s3 = set.each.jerk_mm_s3});
  }
  return limits;
}

// The largest of all figures over its limit.
double largest_over_limit(const CurveRun& run, const PlanLimits& limits) {
  double largest = run.chord_error_mm / limits.chord_tolerance_mm;
  const auto look = [&largest](const Peaks& peaks, const lookahead::MotionLimits& of) {
    largest = std::max({largest, peaks.v_mm_s / of.velocity_mm_s,
                        peaks.a_mm_s2 / of.acceleration_mm_s2, peaks.j_mm_s3 / of.jerk_mm_s3});
  };
  look(run.path, limits.path);
  for (std::size_t k = 0; k < 3; ++k) {
    look(run.axes[k], limits.axes[k]);
  }
  return largest;
}

// Seconds from rest to v mm/s under A and J.
double ramp_s(double v_mm_s, const lookahead::MotionLimits& each) {
  const double a = each.acceleration_mm_s2;
  const double j = each.jerk_mm_s3;
  return v_mm_s * j >= a * a ? v_mm_s / a + a / j : 2.0 * std::sqrt(v_mm_s / j);
}

// The least time of a straight line of that length from rest to rest, in closed form but for the
// bisection to its highest feedrate. With limits along the path no curve of the length takes less.
double line_s(double length_mm, const lookahead::MotionLimits& each) {
  double low = 0.0;
  double peak_mm_s = each.velocity_mm_s;
  if (peak_mm_s * ramp_s(peak_mm_s, each) > length_mm) {
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + peak_mm_s);
      (middle * ramp_s(middle, each) > length_mm ? peak_mm_s : low) = middle;
    }
  }
  return length_mm / peak_mm_s + ramp_s(peak_mm_s, each);
}

// From 0 to V and back under A and J takes so much longer than under A alone: what a reference
// without the jerk of launch and landing lacks at the most.
double launch_s(const lookahead::MotionLimits& each) {
  return std::min(each.acceleration_mm_s2 / each.jerk_mm_s3,
                  std::sqrt(each.velocity_mm_s / each.jerk_mm_s3));
}

bool print_row(const std::string& curve, const LimitSet& set, bool on_axes,
               const std::map<std::string, double>& references) {
  using profiles::Profile;
  using profiles::ProfileKind;
  const PlanLimits limits = plan_limits(set, on_axes);
  const lookahead::Block block = curve_block(curve + ".ngc", limits, set.each.velocity_mm_s);
  const CurveRun best = from_rest(block, limits, Profile(ProfileKind::time_optimal));
  const CurveRun classical = from_rest(block, limits, Profile(ProfileKind::s_curve));
  const double over = largest_over_limit(best, limits);
  const auto reference =
      references.find(key_of(curve, on_axes, set.each.velocity_mm_s, set.each.acceleration_mm_s2));
  const bool known = reference != references.end();
  const double ratio = known ? best.time_s / reference->second : 0.0;
  const bool met = over <= kTolerance && best.planning_s <= 0.1 * best.time_s &&
                   (!known || best.time_s <= kOfReference * reference->second + launch_s(set.each));
  const auto figure = [](bool there, double value) {
    return there ? std::to_string(value) : std::string();
  };
  std::printf(
      "| %s | %s %.0f/%.0f/%.0f/%g | %.3f | %s | %s | %s | %s | %s | %.1f | %.4f | %.3f | %.1f |\n",
      curve.c_str(), on_axes ? "axis" : "path", set.each.velocity_mm_s, set.each.acceleration_mm_s2,
      set.each.jerk_mm_s3, set.chord_mm, best.time_s,
      figure(!on_axes, line_s(block.length_mm, set.each)).c_str(),
      figure(known, known ? reference->second : 0.0).c_str(), figure(known, ratio).c_str(),
      known ? (ratio <= kOfReference ? "met" : "beyond") : "", met ? "met" : "MISSED",
      1e3 * best.planning_s, over, classical.time_s, largest_over_limit(classical, limits));
  return met;
}

}  // namespace

int optimum() {
  std::printf(
      "Rest to rest. Line: the least time of a straight line of the curve's length under the same "
      "limits along the path; no motion along the curve takes less. The references leave out the "
      "jerk of launch and landing (j = sqrt(b) b'' / 2 vanishes at rest whatever b'' is): with it "
      "they are up to A / J longer, 0.055, 0.050 and 0.067 s, and several of them are shorter than "
      "the line. 1.01: at most 1.01 times the reference as it stands. With launch: at most 1.01 "
      "times the reference and A / J, no figure more than 0.5 %% over its limit, planned in a "
      "tenth of the time.\n\n"
      "| curve | limits | time-optimal [s] | line [s] | reference [s] | ratio | 1.01 | with launch "
      "| planning [ms] | largest over limit | s-curve [s] | largest over limit |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const std::map<std::string, double> times = references();
  bool met = true;
  for (const char* curve :
       {"butterfly", "circle", "mazatrol", "rational4", "scroll", "star", "trident7"}) {
    for (const LimitSet& set : kSets) {
      for (const bool on_axes : {false, true}) {
        met = print_row(curve, set, on_axes, times) && met;
      }
    }
  }
  return met ? 0 : 1;
}

}  // namespace kerf::bench
