#include "bench/control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "bench/control_programs.hpp"
#include "bench/control_real_time.hpp"
#include "bench/held_run.hpp"
#include "bench/shortest_stop.hpp"
#include "tests/kernel/planned_path.hpp"

namespace kerf::bench {

namespace {

constexpr double kLineFeed_mm_s = 100.0;
// What has to hold.
constexpr double kReactionAtMost_ms = 20.0;
constexpr double kWayAtMost = 1.1;
// A way so much shorter than the bound shows that it is none there.
constexpr double kWayAtLeast = 0.98;

bool is_line(const ControlProgram& program) {
  return program.name == "line";
}

// v^2 / 2a + v a / 2J of X, where a is the highest deceleration: A, or what it gets to.
double shortest_on_line_mm() {
  const MachineLimits limits = default_machine().limits;
  const MotionLimits& x = limits.axes[0];
  const MotionLimits& path = limits.path;
  const double a = std::min(x.acceleration_mm_s2, path.acceleration_mm_s2);
  const double j = std::min(x.jerk_mm_s3, path.jerk_mm_s3);
  const double highest = std::min(a, std::sqrt(kLineFeed_mm_s * j));
  return 0.5 * kLineFeed_mm_s * (kLineFeed_mm_s / highest + highest / j);
}

bool in_virtual_time(const ControlProgram& program, ProfileKind profile,
                     const std::string& folder) {
  const HeldRun run(program, profile);
  std::vector<double> reaction;
  std::vector<double> could_show;
  std::vector<double> planning;
  std::vector<double> rest;
  std::vector<double> over_shortest;
  const test::PlannedPath path = run.path();
  double way_mm = 0.0;
  for (const std::int64_t tick : run.random_ticks()) {
    const Held held = run.hold_at(tick);
    if (held.rests_as_planned) {
      continue;
    }
    reaction.push_back(held.reaction_ms);
    could_show.push_back(held.could_show_ms());
    planning.push_back(held.planning_ms);
    rest.push_back(held.rest_ms);
    way_mm = std::max(way_mm, held.way_mm());
    if (held.way.way_mm == 0.0) {
      continue;
    }
    over_shortest.push_back(held.way.way_mm /
                            shortest_stop_mm(path, held.way.from, default_machine().limits));
    const bool is_judged =
        over_shortest.back() >= kWayAtLeast && over_shortest.back() <= kWayAtMost;
    if (!folder.empty() && !is_judged) {
      write_way(folder + '/' + program.name + '-' + std::string(name_of(profile)) + '-' +
                    std::to_string(tick) + ".txt",
                path, held.way);
    }
  }
  const bool holds = quantile(could_show, 1.0) <= kReactionAtMost_ms &&
                     quantile(over_shortest, 0.5) <= kWayAtMost &&
                     (!is_line(program) || way_mm <= kWayAtMost * shortest_on_line_mm());
  std::printf("| %s | %s | %zu | %.0f | %.0f | %.0f | %.1f | %.1f | %.0f | %.2f | %.3f | %.3f |\n",
              program.name.c_str(), std::string(name_of(profile)).c_str(), reaction.size(),
              quantile(reaction, 0.5), quantile(reaction, 1.0), quantile(could_show, 1.0),
              quantile(planning, 0.5), quantile(planning, 1.0), quantile(rest, 1.0), way_mm,
              quantile(over_shortest, 0.5), quantile(over_shortest, 1.0));
  std::fflush(stdout);
  return holds;
}

}  // namespace

int control(const std::string& folder) {
  const std::vector<ControlProgram> all = control_programs();
  constexpr std::array kProfiles{ProfileKind::time_optimal, ProfileKind::s_curve};
  bool holds = true;
  std::printf(
      "%d holds each, in virtual time: ticks from the request to the first other setpoint, and "
      "what planning took. Where the plan brakes to a rest that is as near there is none, and the "
      "hold is not counted; it could show where the plan does not brake as hard as the path's "
      "limits allow until then. Way: the longest, from the last tick that was not another; from "
      "the first that was, over a bound that lets jumps and an axis at its limit of jerk cost "
      "nothing; where an axis leaves no jerk at all it may be far too long.\n\n"
      "| program | profile | counted | reaction, median ms | worst | that could show | planning, "
      "median ms | worst | braking, worst ms | way, mm | over the bound, median | worst |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      kHolds);
  for (const ControlProgram& program : all) {
    for (const ProfileKind profile : kProfiles) {
      holds &= in_virtual_time(program, profile, folder);
    }
  }
  std::printf(
      "\nIn real time, two busy threads beside it.\n\n"
      "| program | profile | reaction, median ms | 99 %% | worst | SCHED_FIFO |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  for (const ControlProgram& program : all) {
    for (const ProfileKind profile : kProfiles) {
      holds &= holds_in_real_time(program, profile);
    }
  }
  return holds ? 0 : 1;
}

}  // namespace kerf::bench
