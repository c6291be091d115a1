// What the time of [Sigmoid, table 4] is made of: the paper's method, replayed.
#pragma once

#include <array>
#include <vector>

#include "bench/papers/comparison.hpp"
#include "bench/papers/in_motion.hpp"
#include "bench/papers/parametric_curve.hpp"
#include "bench/papers/sigmoid_method.hpp"

namespace kerf::bench {

struct Rule {
  ChordRule rule;
  const char* name;
};
inline constexpr std::array kRules{Rule{ChordRule::largest_distance, "largest distance"},
                                   Rule{ChordRule::at_middle_parameter, "at the middle of u"},
                                   Rule{ChordRule::circle_of_curvature, "circle of curvature"}};

// By the text's own scan.
void add_breaking_points(const MethodCurve& curve, const lookahead::PlanLimits& limits,
                         Comparison& table);
// By each scan, Kerf's among them.
void print_breaking_points(const MethodCurve& curve, const lookahead::VelocityLimitCurve& kerf_scan,
                           const lookahead::PlanLimits& limits, Comparison& table);

struct MethodRow {
  ChordRule rule = ChordRule::largest_distance;
  bool dips = true;
  MethodPlan sigmoid;
  MethodPlan sine;
};

// Of each rule, with the dips and without them.
std::vector<MethodRow> method_rows(const MethodCurve& curve, const lookahead::PlanLimits& limits);

// The row of the text's own rule, the largest distance.
const MethodRow& by_largest_distance(const std::vector<MethodRow>& rows, bool dips);

void print_method(const std::vector<MethodRow>& rows, Comparison& table);

struct KerfRuns {
  const MotionRun& sigmoid;
  const MotionRun& sigmoid_by_paper;  // with the paper's bound of the jerk
  const MotionRun& sine;
};

// From Kerf's plan to the published time, a step a row.
void print_steps(const KerfRuns& kerf, const std::vector<MethodRow>& rows,
                 const lookahead::PlanLimits& limits);

}  // namespace kerf::bench
