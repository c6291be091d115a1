#include "bench/optimum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "bench/acceleration_bound.hpp"
#include "bench/curve_run.hpp"
#include "bench/program_text.hpp"
#include "profiles/profile.hpp"

namespace kerf::bench {

using lookahead::PlanLimits;

namespace {

constexpr double kTolerance = 1.005;
constexpr double kOfReference = 1.01;
constexpr double kMedianOfReference = 1.003;
constexpr double kOfBound = 0.999;  // the bound has a grid, and ticks round the time up

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

using Times = std::map<std::string, double>;

Times times_of(const std::string& file) {
  std::istringstream lines(source_file("bench/optima/" + file));
  Times times;
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

struct References {
  Times as_given = times_of("reference.tsv");
  Times from_rest = times_of("from_rest.tsv");
};

// The cells of a reference time and of the ratio to it.
struct Beside {
  std::string cells = " | |";  // there is no such time
  double ratio = 0.0;
};

Beside beside(const Times& times, const std::string& key, double time_s) {
  const auto found = times.find(key);
  if (found == times.end()) {
    return {};
  }
  const double ratio = time_s / found->second;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " %.4f | %.4f |", found->second, ratio);
  return {.cells = text.data(), .ratio = ratio};
}

bool is_within(double ratio) {
  return ratio > 0.0 && ratio <= kOfReference;
}

// ratios: of what has a reference from rest, this row's after the others.
bool print_row(const std::string& curve, const LimitSet& set, bool on_axes,
               const References& references, std::vector<double>& ratios) {
  using profiles::Profile;
  using profiles::ProfileKind;
  const PlanLimits limits = plan_limits(set, on_axes);
  const lookahead::Block block = curve_block(curve + ".ngc", limits, set.each.velocity_mm_s);
  const CurveRun best = from_rest(block, limits, Profile(ProfileKind::time_optimal));
  const CurveRun classical = from_rest(block, limits, Profile(ProfileKind::s_curve));
  const double over = largest_over_limit(best, limits);
  const bool keeps = over <= kTolerance && best.planning_s <= 0.1 * best.time_s;
  const std::string key =
      key_of(curve, on_axes, set.each.velocity_mm_s, set.each.acceleration_mm_s2);
  const Beside given = beside(references.as_given, key, best.time_s);
  const Beside real = beside(references.from_rest, key, best.time_s);
  const auto judged = [](double ratio) {
    return ratio == 0.0 ? "" : is_within(ratio) ? "met" : "MISSED";
  };
  if (real.ratio > 0.0) {
    ratios.push_back(real.ratio);
  }
  const double bound_s = any_jerk_motion(block, limits).time_s;
  std::printf("| %s | %s %.0f/%.0f/%.0f/%g | %.3f | %.1f | %.4f | %s |%s %s |%s %s |",
              curve.c_str(), on_axes ? "axis" : "path", set.each.velocity_mm_s,
              set.each.acceleration_mm_s2, set.each.jerk_mm_s3, set.chord_mm, best.time_s,
              1e3 * best.planning_s, over, keeps ? "met" : "MISSED", real.cells.c_str(),
              judged(real.ratio), given.cells.c_str(), judged(given.ratio));
  if (on_axes) {
    std::printf(" |");
  } else {
    std::printf(" %.3f |", line_s(block.length_mm, set.each));
  }
  std::printf(" %.3f | %.3f | %.1f |\n", bound_s, classical.time_s,
              largest_over_limit(classical, limits));
  return keeps && best.time_s >= kOfBound * bound_s && (real.ratio == 0.0 || is_within(real.ratio));
}

}  // namespace

int optimum() {
  std::printf(
      "Rest to rest. Kept: no figure more than 0.5 %% over its limit at any tick, planned in a "
      "tenth of the time. From rest: the optimum by bench/optima/make_optima, the jerk of launch "
      "and "
      "landing included. Reference: that of bench/optima/reference.tsv, which leaves it out (j = "
      "sqrt(b) b'' / 2 vanishes at rest whatever b'' is) and is shorter for it. Ratios: at most "
      "1.01. Line: the least time of a straight line of the "
      "curve's length, in closed form; no motion with limits along the path takes less, so a "
      "reference below it cannot be reached. Any jerk: the least time within "
      "feedrate, velocity, acceleration and chord error alone.\n\n"
      "| curve | limits | time-optimal [s] | planning [ms] | largest over limit | kept | from rest "
      "[s] | ratio | | reference [s] | ratio | | line [s] | any jerk [s] | s-curve [s] | largest "
      "over limit |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- "
      "| --- |\n");
  const References references;
  std::vector<double> ratios;
  bool met = true;
  for (const char* curve :
       {"butterfly", "circle", "mazatrol", "rational4", "scroll", "star", "trident7"}) {
    for (const LimitSet& set : kSets) {
      for (const bool on_axes : {false, true}) {
        met = print_row(curve, set, on_axes, references, ratios) && met;
      }
    }
  }
  std::ranges::sort(ratios);
  const double median = ratios[ratios.size() / 2];
  const bool is_near = median <= kMedianOfReference;
  std::printf("\nMedian of the ratios from rest: %.4f, at most %.3f: %s.\n", median,
              kMedianOfReference, is_near ? "met" : "MISSED");
  return met && is_near ? 0 : 1;
}

}  // namespace kerf::bench
