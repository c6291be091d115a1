// [Quintic, tables 2 and 3].
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/curve_run.hpp"
#include "bench/papers/comparison.hpp"
#include "bench/papers/papers.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::bench {

using lookahead::Block;
using profiles::Profile;
using profiles::ProfileKind;

namespace {

constexpr double kPerMinute = 60.0;
constexpr double kPerMetre = 1e-3;

std::vector<Block> blocks_of(const lookahead::PlanLimits& limits) {
  std::vector<Block> blocks;
  for (const parser::Move& move : moves_of("polygon.ngc")) {
    if (!move.rapid && !lookahead::append_blocks(move, limits, blocks)) {
      throw std::runtime_error("polygon.ngc has a move that cannot be planned");
    }
  }
  return blocks;
}

// A Ts / |du| = A Ts / (2 sin(turn / 2)): the velocity jumps by A Ts as a vector.
double vector_rule_mm_s(const Block& before, const Block& after,
                        const lookahead::PlanLimits& limits) {
  const Eigen::Vector3d jump = curves::vec(after.begin.first) - curves::vec(before.end.first);
  return limits.axes[0].acceleration_mm_s2 * limits.period_s / jump.norm();
}

void add_corners(const std::vector<Block>& blocks, const lookahead::PlanLimits& limits,
                 Comparison& table) {
  constexpr std::array kPublished{674.0, 425.0, 530.0, 425.0, 674.0};
  if (blocks.size() != kPublished.size() + 1) {
    throw std::runtime_error("polygon.ngc is no hexagon");
  }
  std::printf(
      "## Quintic: the polygon\n\nIts table 2, corner feedrates in mm/min at 12.5 m/s2 and 1 ms. "
      "The paper's rule: velocity jumps by A Ts as a vector, along it. Kerf's: by A Ts on each "
      "axis.\n\n| corner | turn [degrees] | published | the paper's rule | Kerf's rule |\n| --- | "
      "--- | --- | --- | --- |\n");
  for (std::size_t i = 0; i < kPublished.size(); ++i) {
    const double vector = kPerMinute * vector_rule_mm_s(blocks[i], blocks[i + 1], limits);
    const double here =
        kPerMinute * lookahead::corner_feedrate_mm_s(blocks[i].end, blocks[i + 1].begin, limits);
    const double cosine =
        curves::vec(blocks[i].end.first).dot(curves::vec(blocks[i + 1].begin.first));
    const std::string corner(1, static_cast<char>('B' + i));
    std::printf("| %s | %.2f | %.0f | %.2f | %.1f |\n", corner.c_str(),
                std::acos(cosine) * 180.0 / std::numbers::pi, kPublished[i], vector, here);
    table.add({.name = "corner " + corner + ", the paper's rule [mm/min]",
               .published = kPublished[i],
               .here = std::floor(vector)});
    table.require("no axis binds before the vector at corner " + corner, here >= vector - 1e-6);
  }
  std::printf("\n");
}

void add_motion(const std::vector<Block>& blocks, const lookahead::PlanLimits& limits,
                Comparison& table) {
  const PlannedRun run = plan_of(blocks, limits, Profile(ProfileKind::quintic));
  TickJudge judge({.limits = limits});
  for (const TickOfRun& tick : run.ticks) {
    judge.add(tick.setpoint, tick.chord_error_mm);
  }
  const Peaks path = judge.path();
  const std::array<Peaks, 3> axes = judge.axes();
  const auto row = [&](const char* name, double published, double here, double band,
                       const char* why) {
    table.add({.name = name,
               .published = published,
               .decimals = 3,
               .here = here,
               .tolerance = 0.0015,
               .band = band,
               .why = why});
  };
  row("0 to 800 mm/min [s]", 0.200, run.phases.front().law.duration_s(), 0.0, "");
  row("feedrate [mm/min]", 800.0, kPerMinute * path.v_mm_s, 0.0, "");
  row("feed acceleration [m/s2]", 0.125, kPerMetre * path.a_mm_s2, 0.0, "");
  row("feed jerk [m/s3]", 1.924, kPerMetre * path.j_mm_s3, 0.0, "");
  row("axial feedrate X [mm/min]", 784.628, kPerMinute * axes[0].v_mm_s, 0.0, "");
  row("axial feedrate Y [mm/min]", 665.176, kPerMinute * axes[1].v_mm_s, 0.0, "");
  const char* split =
      "a tick with the corner inside sees a part of its jump, by chance of the legs' lengths, "
      "which "
      "are not in the paper: its 8.281 is 66 % of D's 12.5 in X, its 10.480 91 % of the 11.55 at B "
      "and F in Y; Kerf passes B, C, E and F faster, up to 12.5 on an axis";
  row("axial acceleration X [m/s2]", 8.281, kPerMetre * axes[0].a_mm_s2, 12.5 - 8.281, split);
  row("axial acceleration Y [m/s2]", 10.480, kPerMetre * axes[1].a_mm_s2, 12.5 - 10.480, split);
  row("axial jerk X [m/s3]", 8280.809, kPerMetre * axes[0].j_mm_s3, 25'000.0 - 8280.0, split);
  row("axial jerk Y [m/s3]", 10479.651, kPerMetre * axes[1].j_mm_s3, 25'000.0 - 10'479.0, split);
  table.require("the polygon keeps its limits", judge.excess().figure == TickExcess::Figure::none);
}

}  // namespace

bool quintic() {
  const lookahead::PlanLimits limits = machine("quintic.toml").limits;
  const std::vector<Block> blocks = blocks_of(limits);
  Comparison table;
  add_corners(blocks, limits, table);
  add_motion(blocks, limits, table);
  table.print("Its tables 2 and 3 by the motion:");
  return table.judge();
}

}  // namespace kerf::bench
