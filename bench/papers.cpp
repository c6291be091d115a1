#include "bench/papers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/curve_run.hpp"
#include "lookahead/classical/limit_curve_cuts.hpp"
#include "lookahead/classical/split.hpp"
#include "lookahead/classical/velocity_pass.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::bench {

using lookahead::Block;
using lookahead::WindowSegment;

namespace {

// Between the least change of slope that tells the butterfly's own turns of feedrate from ripple
// and the largest that keeps all of them (the papers leave the value to the curve).
constexpr double kScreening_mm_s = 3000.0;

// As the papers run it: from the feedrate that the curve allows at its start to that at its end.
double in_motion_s(const Block& block, const profiles::Profile& profile) {
  std::vector<WindowSegment> window;
  for (lookahead::VelocitySegment& segment : lookahead::split(block, 0.001)) {
    window.push_back({.segment = std::move(segment)});
  }
  double v_end = block.limit_curve.back().v_mm_s;
  for (auto item = window.rbegin(); item != window.rend(); ++item) {
    item->v_end_mm_s = v_end;
    const auto before = std::next(item);
    const double cap = before != window.rend() ? before->segment.end.feedrate_mm_s
                                               : block.limit_curve.front().v_mm_s;
    v_end = lookahead::reach_backward_mm_s(item->segment, {.v_end_mm_s = v_end, .cap_mm_s = cap},
                                           profile);
  }
  double v = v_end;
  double time_s = 0.0;
  for (const WindowSegment& item : window) {
    lookahead::SegmentEnds ends{.v_begin_mm_s = v, .v_end_mm_s = item.v_end_mm_s};
    ends.v_end_mm_s = lookahead::end_feedrate_mm_s(item.segment, ends, 0.0, profile);
    time_s += lookahead::plan_segment(item.segment, ends, profile).duration_s();
    v = ends.v_end_mm_s;
  }
  return time_s;
}

const char* verdict(double found, double target) {
  return found <= target ? "met" : "MISSED";
}

struct Row {
  profiles::ProfileKind kind;
  std::optional<double> sigmoid_shape;
  const char* published;
  double rest_target_s;  // infinite: none
  double motion_target_s;
};

bool butterfly() {
  const MachineSettings settings = machine("sigmoid-butterfly.toml");
  const Block block = curve_block("butterfly.ngc", settings.limits);
  std::printf(
      "## Butterfly, V 100 mm/s, A 3000 mm/s2, J 55000 mm/s3, chord 5e-4 mm, Ts 1 ms, limits along "
      "the "
      "path\n\n"
      "| profile | published, in motion [s] | in motion [s] | target | rest to rest [s] | target | "
      "max "
      "a | max j | max chord error [mm] |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- "
      "|\n");
  const double none = lookahead::kUnbounded;
  using Kind = profiles::ProfileKind;
  const std::vector<Row> rows{
      {Kind::s_curve, {}, "", 4.47, 4.36},
      {Kind::sigmoid, {}, "4.360 (s = 3.3; chord error 5.19e-4)", 4.50, 4.39},
      {Kind::sigmoid, 3.3, "4.360 (chord error 5.19e-4)", none, none},
      {Kind::sine, {}, "4.417 (jerk 63546)", none, none},
      {Kind::sine_series, {}, "", none, none},
      {Kind::quintic, {}, "", none, none},
  };
  bool met = true;
  for (const Row& row : rows) {
    const profiles::Profile profile(row.kind, row.sigmoid_shape);
    const CurveRun rest = from_rest(block, settings.limits, profile);
    const double motion_s = in_motion_s(block, profile);
    const bool judged = std::isfinite(row.rest_target_s);
    met = met && rest.time_s <= row.rest_target_s && motion_s <= row.motion_target_s;
    std::printf("| %s%s | %s | %.3f | %s | %.3f | %s | %.0f | %.0f | %.3g |\n",
                std::string(profiles::name_of(row.kind)).c_str(),
                row.sigmoid_shape ? " s = 3.3" : "", row.published, motion_s,
                judged ? verdict(motion_s, row.motion_target_s) : "", rest.time_s,
                judged ? verdict(rest.time_s, row.rest_target_s) : "", rest.path.a_mm_s2,
                rest.path.j_mm_s3, rest.chord_error_mm);
  }
  const std::size_t points = lookahead::breaking_points(block.limit_curve, kScreening_mm_s).size();
  std::printf(
      "\nThe time optimum from rest to rest is 4.362 s. Breaking points: %zu (published: 37).\n\n",
      points);
  return met && points == 37;
}

void wm() {
  const MachineSettings settings = machine("sigmoid-wm.toml");
  const Block block = curve_block("wm.ngc", settings.limits);
  std::printf(
      "## WM-like curve of our own, V 100, A 1000, J 26000, chord 5e-4\n\nThe paper's curve is not "
      "in "
      "the paper (0.702 s with sigmoid, 0.721 s with sine); times compare only within the "
      "table.\n\n"
      "| profile | rest to rest [s] | max a | max j | max chord error [mm] |\n"
      "| --- | --- | --- | --- | --- |\n");
  for (const auto kind : {profiles::ProfileKind::s_curve, profiles::ProfileKind::sigmoid,
                          profiles::ProfileKind::sine}) {
    const CurveRun run = from_rest(block, settings.limits, profiles::Profile(kind));
    std::printf("| %s | %.3f | %.0f | %.0f | %.3g |\n",
                std::string(profiles::name_of(kind)).c_str(), run.time_s, run.path.a_mm_s2,
                run.path.j_mm_s3, run.chord_error_mm);
  }
  std::printf("\n");
}

bool corners() {
  const MachineSettings settings = machine("quintic.toml");
  std::printf(
      "## Corner feedrates of the closed polygon, quintic, 12.5 m/s2, 25000 m/s3, Ts 1 ms\n\n"
      "| corner | published [mm/min] | here [mm/min] |\n| --- | --- | --- |\n");
  std::vector<Block> blocks;
  for (const parser::Move& move : moves_of("polygon.ngc")) {
    if (!move.rapid && !lookahead::append_blocks(move, settings.limits, blocks)) {
      throw std::runtime_error("polygon.ngc has a move that cannot be planned");
    }
  }
  constexpr std::array<double, 5> kPublished{674, 425, 530, 425, 674};
  bool met = blocks.size() == 6;
  for (std::size_t i = 0; i + 1 < blocks.size(); ++i) {
    const double here =
        60.0 * lookahead::corner_feedrate_mm_s(blocks[i].end, blocks[i + 1].begin, settings.limits);
    met = met && std::abs(here - kPublished[i]) < 1.0;
    std::printf("| %c | %.0f | %.1f |\n", static_cast<char>('B' + i), kPublished[i], here);
  }
  const profiles::Transition ramp = profiles::Profile(profiles::ProfileKind::quintic)
                                        .fastest({0.0, 800.0 / 60.0}, {125.0, 1924.501});
  double a = 0.0;
  double j = 0.0;
  for (int k = 0; k <= 10'000; ++k) {
    const profiles::PathMotion motion = ramp.at(ramp.duration_s() * k / 10'000);
    a = std::max(a, std::abs(motion.a_mm_s2));
    j = std::max(j, std::abs(motion.j_mm_s3));
  }
  std::printf(
      "\n0 to 800 mm/min in %.4f s: %.3f m/s2 and %.3f m/s3 (published: 0.2 s, 0.125, 1.924).\n",
      ramp.duration_s(), a / 1e3, j / 1e3);
  return met;
}

}  // namespace

int papers() {
  const bool butterfly_met = butterfly();
  wm();
  const bool corners_met = corners();
  return butterfly_met && corners_met ? 0 : 1;
}

}  // namespace kerf::bench
