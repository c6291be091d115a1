// Curves of shipped programs, planned and run tick by tick.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <kerf/kerf.hpp>

#include "curves/nurbs_curve.hpp"
#include "interp/motion.hpp"
#include "kernel/tick_judge.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/moves/move.hpp"
#include "profiles/profile.hpp"

namespace kerf::bench {

// Throw where a file of the sources is not what it must be.
MachineSettings machine(const std::string& name);
std::vector<parser::Move> moves_of(const std::string& program);
// The first block of the program's first curve, at its own feedrate or another.
lookahead::Block curve_block(const std::string& program, const lookahead::PlanLimits& limits,
                             std::optional<double> feedrate_mm_s = std::nullopt);

// The data of the program's first curve.
curves::NurbsData curve_data(const std::string& program);

struct CurveRun {
  double time_s = 0.0;
  double planning_s = 0.0;  // of blocks to phases, without the scan of the chord error
  Peaks path{};
  std::array<Peaks, 3> axes{};
  double chord_error_mm = 0.0;
};

struct TickOfRun {
  Setpoint setpoint{};
  double chord_error_mm = 0.0;  // of the tick that ends there
};

struct PlannedRun {
  double planning_s = 0.0;
  std::vector<TickOfRun> ticks;
  std::vector<interp::Phase> phases;
};

// The blocks from rest to rest, through the planner and the interpolator.
PlannedRun plan_of(const std::vector<lookahead::Block>& blocks, const lookahead::PlanLimits& limits,
                   const profiles::Profile& profile);

// Judged tick by tick from its setpoints.
CurveRun from_rest(const lookahead::Block& block, const lookahead::PlanLimits& limits,
                   const profiles::Profile& profile);

}  // namespace kerf::bench
