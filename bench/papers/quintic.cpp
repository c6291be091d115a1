// [Quintic, equations 2.22 to 2.25, tables 2 and 3].
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

struct PlaceOfPeak {
  double share = 0.0;  // of the duration
  double peak = 0.0;

  void take(const PlaceOfPeak& seen) {
    if (seen.peak > peak) {
      *this = seen;
    }
  }
};

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

// Where the acceleration and the jerk of a transition are highest, and how high.
void add_law(Comparison& table) {
  constexpr int kPlaces = 100'000;
  const profiles::Transition law = Profile(ProfileKind::quintic)
                                       .fastest({.v_begin_mm_s = 0.0, .v_end_mm_s = 1.0},
                                                {.acceleration_mm_s2 = 1.0, .jerk_mm_s3 = 1.0});
  const double duration = law.duration_s();
  PlaceOfPeak acceleration;
  PlaceOfPeak jerk;
  for (int i = 0; i <= kPlaces / 2; ++i) {  // the second half mirrors the first
    const double share = static_cast<double>(i) / kPlaces;
    const profiles::PathMotion motion = law.at(share * duration);
    acceleration.take({.share = share, .peak = motion.a_mm_s2 * duration});
    jerk.take({.share = share, .peak = motion.j_mm_s3 * duration * duration});
  }
  const auto row = [&](const char* name, double published, double here) {
    table.add({.name = name, .published = published, .decimals = 3, .here = here});
  };
  row("largest acceleration, in Fd / td (2.24)", 1.875, acceleration.peak);
  row("its time, in td (2.22)", 0.5, acceleration.share);
  row("largest jerk, in Fd / td^2 (2.25)", 5.773, jerk.peak);
  row("its time, in td (2.23)", 0.211, jerk.share);
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
               .band = band,
               .why = why});
  };
  row("0 to 800 mm/min [s]", 0.200, run.phases.front().law.duration_s(), 0.0,
      "not printed: its 0.125 and 1.924 belong to that time by its equations 2.24 and 2.25");
  row("feedrate [mm/min]", 800.0, kPerMinute * path.v_mm_s, 0.0, "");
  const char* chosen =
      "limits along the path of our own, chosen for 0.2 s: no independent check; by its equation "
      "2.28 its limits of 12.5 and 25000 give 0.002 s, and 12.5 m/s2";
  row("feed acceleration [m/s2]", 0.125, kPerMetre * path.a_mm_s2, 0.0, chosen);
  row("feed jerk [m/s3]", 1.924, kPerMetre * path.j_mm_s3, 0.0, chosen);
  row("axial feedrate X [mm/min]", 784.628, kPerMinute * axes[0].v_mm_s, 0.0, "");
  row("axial feedrate Y [mm/min]", 665.176, kPerMinute * axes[1].v_mm_s, 0.0, "");
  const char* split =
      "a tick with the corner inside sees a part of its jump, by chance of the legs' lengths, "
      "which "
      "are not in the paper: its 8.281 is 66 % of D's 12.5 in X, its 10.480 91 % of the 11.55 at B "
      "and F in Y; Kerf passes B, C, E and F faster, up to 12.5 on an axis";
  row("axial acceleration X [m/s2]", 8.281, kPerMetre * axes[0].a_mm_s2, 2.0, split);
  row("axial acceleration Y [m/s2]", 10.480, kPerMetre * axes[1].a_mm_s2, 0.4, split);
  row("axial jerk X [m/s3]", 8280.809, kPerMetre * axes[0].j_mm_s3, 2000.0, split);
  row("axial jerk Y [m/s3]", 10479.651, kPerMetre * axes[1].j_mm_s3, 400.0, split);
  table.require("the polygon keeps its limits", judge.excess().figure == TickExcess::Figure::none);
}

}  // namespace

bool quintic() {
  const lookahead::PlanLimits limits = machine("quintic.toml").limits;
  const std::vector<Block> blocks = blocks_of(limits);
  Comparison table;
  add_corners(blocks, limits, table);
  add_law(table);
  add_motion(blocks, limits, table);
  table.print("Its tables 2 and 3 by the motion, and the figures of its law:");
  return table.judge();
}

}  // namespace kerf::bench
